#include "engine/language/rows/equation_reader.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"

#include <string>

namespace zeroset {
namespace {

constexpr const char* no_surface = marked("a condition alone is no surface");

/// The error for a row that is a vector or a list.
std::unexpected<ParseError> refuse_row(GraphValues& values, const BuiltValue& value,
                                       std::size_t offset) {
    if (value.point()) {
        return values.failure(
            offset, tr("a list in brackets is a point or a parametric surface, no equation"),
            tr("type an equation in x, y and z"));
    }
    if (value.is_complex()) {
        values.refuse_complex(offset);
        return values.failure();
    }
    return values.failure(offset, filled(tr("this is {0}, and no surface"), {value.described()}),
                          tr("type an equation in x, y and z"));
}

}  // namespace

std::expected<EquationReader::Equation, ParseError> EquationReader::read(std::size_t statement) {
    GraphValues& values = reader_.values();
    const SyntaxTree& tree = reader_.tree();
    const Context context{.statement = statement};
    const SyntaxId id = tree.statements[statement].relation;
    const Syntax& relation = tree[id];
    const bool compares = relation.kind == SyntaxKind::Compare;
    NodeId f = 0;
    if (compares && relation.marks == "=") {
        const auto left = reader_.number(relation.operands[0], context);
        const auto right = left ? reader_.number(relation.operands[1], context) : std::nullopt;
        if (!right) return values.failure();
        f = make_subtract(values.builder(), *left, *right);
        if (!values.done(f, relation.offset)) return values.failure();
    } else if (compares && relation.marks.contains('=')) {
        return values.failure(relation.offset, tr("an equation and an inequality in one"),
                              tr("put the inequality behind a comma: x^2 + y^2 = 1, z < 1"));
    } else if (compares && relation.marks == "n") {
        return values.failure(relation.offset, tr(no_surface),
                              tr("compare with = for the surface where both sides are equal"));
    } else {
        const auto value = reader_.build(id, context);
        if (!value) return values.failure();
        if (value->condition) return solid(value->id, statement);
        if (!value->is_single())
            return refuse_row(values, *value, tree.statements[statement].offset);
        f = value->id;
    }
    const auto all = restriction(statement);
    if (!all) return std::unexpected(all.error());
    return Equation{.root = *all ? make_call(values.builder(), Op::Where, f, **all) : f,
                    .solid = false};
}

std::expected<std::optional<NodeId>, ParseError> EquationReader::restriction(
    std::size_t statement) {
    GraphValues& values = reader_.values();
    const SyntaxTree& tree = reader_.tree();
    const auto& restrictions = tree.statements[statement].restrictions;
    std::optional<NodeId> all;
    for (const SyntaxId id : restrictions) {
        const Syntax& syntax = tree[id];
        const bool equates = syntax.kind == SyntaxKind::Compare &&
                             syntax.marks.find_first_of("=e") != std::string::npos;
        if (equates) {
            return values.failure(syntax.offset,
                                  tr("behind a comma stands an inequality, not an equation"),
                                  tr("for a second surface type ';' instead of the comma"));
        }
        const auto one =
            reader_.condition(id, {.statement = statement}, ExpressionReader::Numbers::Refused);
        if (!one) return values.failure();
        all = all ? make_call(values.builder(), Op::And, *all, *one) : *one;
        if (!values.done(*all, syntax.offset)) return values.failure();
    }
    if (all && values.refuses_undefined() && values.never_holds(*all))
        return values.failure(tree[restrictions.front()].offset, tr("this never holds"));
    return all;
}

/// A number below 0 where the condition and all that restrict it hold, above 0 elsewhere.
std::expected<EquationReader::Equation, ParseError> EquationReader::solid(NodeId condition,
                                                                          std::size_t statement) {
    GraphValues& values = reader_.values();
    const SyntaxTree& tree = reader_.tree();
    const StatementSyntax& row = tree.statements[statement];
    const std::size_t offset = tree[row.relation].offset;
    GraphValues::Number all = boundaries_.boundary(condition, offset);
    for (const SyntaxId id : row.restrictions) {
        if (!all) break;
        const std::size_t at = tree[id].offset;
        const auto further =
            reader_.condition(id, {.statement = statement}, ExpressionReader::Numbers::Refused);
        if (!further) return values.failure();
        const auto one = boundaries_.boundary(*further, at);
        all = one ? GraphValues::Number(make_call(values.builder(), Op::Max, *all, *one))
                  : std::nullopt;
        if (all && !values.done(*all, at)) return values.failure();
    }
    if (values.failed()) return values.failure();
    if (!all) {
        return values.failure(
            offset, tr("this condition has no boundary that is a surface"),
            tr("type inequalities such as z > x^2 + y^2, or a surface and a comma before "
               "it: x^2 + y^2 = 1, z < 1"));
    }
    return Equation{.root = *all, .solid = true};
}

}  // namespace zeroset
