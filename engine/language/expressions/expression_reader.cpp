// Builds the nodes of expressions.

#include "engine/language/expressions/expression_reader.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/number.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/expressions/imaginary_unit.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/words.hpp"

#include <cmath>
#include <set>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

constexpr double largest_number = 1e300;
constexpr double largest_bound = 1e15;  // up to here i + 1 is exact and differs from i
constexpr int deepest_tree = 5000;      // depth of trees within calls within trees
constexpr int deep = 500;  // from this depth on, definitions are built before they are used

bool is_numbered_coordinate(std::string_view name) {
    return name == "x_1" || name == "x_2" || name == "x_3";
}

NodeId make_mod(ExprBuilder& builder, NodeId a, NodeId b) {
    return make_call(builder, Op::Mod, a, b);
}

}  // namespace

bool ExpressionReader::is_deep() const { return depth_ > deep; }

const Syntax& ExpressionReader::name_of(const Definition& definition) const {
    return tree_[tree_[tree_.statements[definition.statement].relation].operands[0]];
}

void ExpressionReader::note(std::size_t offset, std::string text, const Context& context) {
    if (!context.library_offset) values_.note(offset, std::move(text));
}

ExpressionReader::Built ExpressionReader::build(SyntaxId id, const Context& context) {
    struct Level {
        int& depth;
        explicit Level(int& d) : depth(d) { ++depth; }
        ~Level() { --depth; }
    };
    const Level level(depth_);
    const Syntax& syntax = tree_[id];
    if (depth_ > deepest_tree)
        return values_.fail(context.at(syntax.offset), tr("the definitions are nested too deep"));
    if (!values_.counts(context.at(syntax.offset))) return std::nullopt;
    switch (syntax.kind) {
        case SyntaxKind::Number: return literal(syntax, context);
        case SyntaxKind::Name: return name(syntax, context);
        case SyntaxKind::Negate: return negated(syntax, context);
        case SyntaxKind::Sum: return sum(syntax, context);
        case SyntaxKind::Product: return product(syntax, context);
        case SyntaxKind::Power: return power(syntax, context);
        case SyntaxKind::Volume: return volume(syntax, context);
        case SyntaxKind::Vector: return vector(syntax, context);
        case SyntaxKind::Items: return list(syntax, context);
        case SyntaxKind::Part: return part(syntax, context);
        case SyntaxKind::Replace: return replaced(syntax, context);
        case SyntaxKind::Call: return call(syntax, context);
        case SyntaxKind::Compare: return compare(syntax, context);
        case SyntaxKind::And: return connected(syntax, Op::And, context);
        case SyntaxKind::Or: return connected(syntax, Op::Or, context);
        case SyntaxKind::Not: return opposite(syntax, context);
        case SyntaxKind::Cases: return cases(syntax, context);
        case SyntaxKind::Let: return with_local_value(syntax, context);
        case SyntaxKind::List: return last_of_list(syntax, context);
        case SyntaxKind::Earlier: return earlier_.at(syntax.operands[0]);
    }
    return std::nullopt;
}

ExpressionReader::Number ExpressionReader::number(SyntaxId id, const Context& context) {
    const Built value = build(id, context);
    return value ? values_.number_of(*value, context.at(tree_[id].offset)) : std::nullopt;
}

ExpressionReader::Built ExpressionReader::operand(SyntaxId id, const Context& context) {
    Built value = build(id, context);
    if (!value || !value->condition) return value;
    const Number number = values_.number_of(*value, context.at(tree_[id].offset));
    if (!number) return std::nullopt;
    return BuiltValue{.id = *number};
}

std::optional<BuiltValues> ExpressionReader::operands(std::span<const SyntaxId> ids,
                                                      const Context& context) {
    BuiltValues values;
    for (const SyntaxId id : ids) {
        const Built value = operand(id, context);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

std::optional<std::vector<NodeId>> ExpressionReader::numbers(std::span<const SyntaxId> ids,
                                                             const Context& context) {
    std::vector<NodeId> values;
    for (const SyntaxId id : ids) {
        const Number value = number(id, context);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

std::optional<double> ExpressionReader::whole_number(SyntaxId id, const Context& context,
                                                     const Complaint& otherwise) {
    const Number value = number(id, context);
    if (!value) return std::nullopt;
    const std::optional<double> exact = exact_value(values_.builder(), *value);
    const bool is_whole =
        exact && *exact == std::floor(*exact) && std::abs(*exact) <= largest_bound;
    if (is_whole) return exact;
    return values_.fail(context.at(tree_[id].offset), otherwise.reason, otherwise.hint);
}

ExpressionReader::Built ExpressionReader::literal(const Syntax& syntax, const Context& context) {
    const NumberEnclosure number = enclose_number(syntax.text);
    if (number.hi > largest_number) {
        return values_.fail(context.at(syntax.offset),
                            filled(tr("the number {0} is too large"), {quoted(syntax.text)}),
                            tr("stay below 1e300"));
    }
    return values_.done(values_.builder().constant(number.lo, number.hi),
                        context.at(syntax.offset));
}

ExpressionReader::Built ExpressionReader::name(const Syntax& syntax, const Context& context) {
    for (const LocalName* local = context.scope; local != nullptr; local = local->outer) {
        values_.count_step();
        if (local->name == syntax.text) return local->value;
    }
    Definition* const definition =
        context.library_offset ? nullptr : table_.value(syntax.text, context.statement);
    if (definition != nullptr) return definitions_.value(*definition, syntax, context);
    if (is_built_in_value(syntax.text)) return names_.said(syntax.text, context.at(syntax.offset));
    return unknown(syntax, context);
}

/// Whether a name that nothing defines is the imaginary unit here.
bool ExpressionReader::is_imaginary_unit(std::string_view name) {
    if (!may_be_imaginary_unit(name)) return false;
    if (!has_complex_) has_complex_ = has_complex_numbers(tree_, table_);
    return *has_complex_;
}

/// Whether the text calls the coordinates x_1, x_2 and x_3: it uses two of these and none of x, y
/// and z, and defines none.
bool ExpressionReader::numbers_coordinates() {
    if (numbers_coordinates_) return *numbers_coordinates_;
    std::set<std::string_view> used;
    bool has_plain = false;
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        for (const NameUse& use : table_.uses(i)) {
            const std::string& name = tree_[use.at].text;
            has_plain = has_plain || name == "x" || name == "y" || name == "z";
            if (is_numbered_coordinate(name) && table_.meant(use, i) == nullptr) used.insert(name);
        }
    }
    numbers_coordinates_ = !has_plain && used.size() > 1;
    return *numbers_coordinates_;
}

/// The parameter of this name, or the error for a name that can be none.
ExpressionReader::Built ExpressionReader::unknown(const Syntax& syntax, const Context& context) {
    const std::string& name = syntax.text;
    const std::size_t offset = context.at(syntax.offset);
    if (const Definition* const function = table_.function(name, context.statement)) {
        std::string call = name + "(";
        for (const std::string& argument : function->arguments)
            call += (call.ends_with('(') ? "" : ", ") + argument;
        return values_.fail(offset, filled(tr("{0} is a function"), {quoted(name)}),
                            filled(tr("type {0}"), {call + ")"}));
    }
    if (is_imaginary_unit(name)) {
        note(offset, filled(tr("{0} is the imaginary unit"), {name}), context);
        return values_.complex(
            {.re = values_.builder().constant(0.0), .im = values_.builder().constant(1.0)}, offset);
    }
    if (is_numbered_coordinate(name) && numbers_coordinates()) {
        const std::string axis(1, static_cast<char>('x' + (name.back() - '1')));
        note(offset, filled(tr("{0} is {1}, as the text has no x, y and z"), {name, axis}),
             context);
        return names_.said(axis, offset);
    }
    if (is_parameter_name(name)) return names_.parameter(name, offset);
    if (const Function* const word = find_function(name);
        word != nullptr && (word->is_of_complex() || word->is_polynomial())) {
        return values_.fail(offset, filled(tr("'(' is missing after {0}"), {quoted(name)}),
                            filled(tr("type {0}"), {std::string(word->name) + "(" +
                                                    std::string(word->arguments) + ")"}));
    }
    if (auto foreign = error_for_foreign(name, offset))
        return values_.fail(foreign->offset, std::move(foreign->reason), std::move(foreign->hint));
    return values_.fail({.offset = offset,
                         .reason = filled(tr("{0} is not known"), {quoted(name)}),
                         .hint = hint_for_unknown(name),
                         .mend = context.library_offset ? std::nullopt : mend_for_unknown(name)});
}

ExpressionReader::Built ExpressionReader::negated(const Syntax& syntax, const Context& context) {
    const Built a = operand(syntax.operands[0], context);
    if (!a) return std::nullopt;
    return values_.mapped(
        std::span(&*a, 1), context.at(syntax.offset),
        [&](std::span<const NodeId> of) { return make_negate(values_.builder(), of[0]); });
}

ExpressionReader::Built ExpressionReader::power(const Syntax& syntax, const Context& context) {
    const Built a = operand(syntax.operands[0], context);
    const Built b = a ? operand(syntax.operands[1], context) : std::nullopt;
    if (!b) return std::nullopt;
    if (a->is_vector() || b->is_vector()) {
        return values_.fail(context.at(syntax.offset), tr("a vector has no powers"),
                            tr("type dot(p, p) for its squared length"));
    }
    return values_.combined(*a, *b, context.at(syntax.offset), make_power);
}

ExpressionReader::Built ExpressionReader::sum(const Syntax& syntax, const Context& context) {
    Built total = operand(syntax.operands[0], context);
    for (std::size_t i = 1; total && i < syntax.operands.size(); ++i) {
        const Built term = operand(syntax.operands[i], context);
        if (!term) return std::nullopt;
        const std::size_t offset = context.at(tree_[syntax.operands[i]].offset);
        if (total->is_vector() != term->is_vector() && !total->is_list() && !term->is_list())
            note(offset, tr("a number beside a vector counts for each of its parts"), context);
        total = values_.combined(*total, *term, offset,
                                 syntax.marks[i - 1] == '+' ? make_add : make_subtract);
    }
    return total;
}

/// Refuses x[1]: a name with a number in brackets is a part of a list, in any program.
bool ExpressionReader::refuses_index(const Syntax& product, std::size_t factor) {
    const Syntax& name = tree_[product.operands[factor - 1]];
    const Syntax& behind = tree_[product.operands[factor]];
    const Syntax& index = behind.kind == SyntaxKind::Power ? tree_[behind.operands[0]] : behind;
    if (name.kind != SyntaxKind::Name || index.kind != SyntaxKind::Number) return false;
    const bool is_point = name.text == "x" || name.text == "p";
    values_.fail(name.offset, filled(tr("{0} has no parts by number"), {quoted(name.text)}),
                 is_point ? tr("type x, y and z for the first, second and third coordinate")
                          : filled(tr("for a product type {0}"), {name.text + "*" + index.text}));
    return true;
}

ExpressionReader::Built ExpressionReader::product(const Syntax& syntax, const Context& context) {
    Built total = operand(syntax.operands[0], context);
    for (std::size_t i = 1; total && i < syntax.operands.size(); ++i) {
        const Built factor = operand(syntax.operands[i], context);
        if (!factor) return std::nullopt;
        const std::size_t offset = context.at(tree_[syntax.operands[i]].offset);
        if (total->is_vector() && factor->is_vector()) {
            note(offset,
                 tr("vectors are multiplied and divided part by part; type dot(a, b) or "
                    "cross(a, b) for their products"),
                 context);
        }
        switch (syntax.marks[i - 1]) {
            case '[':
                if (!total->is_single()) return values_.refuse_index(*total, offset);
                if (refuses_index(syntax, i)) return std::nullopt;
                [[fallthrough]];
            case '*': total = values_.combined(*total, *factor, offset, make_multiply); break;
            case '/':
                if (is_zero_by_name(tree_[syntax.operands[i]], *factor, context))
                    return std::nullopt;
                total = values_.combined(*total, *factor, offset, make_divide);
                break;
            default:
                total = values_.combined(*total, *factor, offset, make_mod);
                note(offset,
                     tr("a % b is mod(a, b), from 0 up to b; for the remainder of C, with "
                        "the sign of a, type fmod(a, b)"),
                     context);
        }
    }
    return total;
}

/// Whether a divisor is a name whose value is 0; sets the error if so.
bool ExpressionReader::is_zero_by_name(const Syntax& syntax, const BuiltValue& divisor,
                                       const Context& context) {
    if (!divisor.is_single()) return false;
    const bool is_name = syntax.kind == SyntaxKind::Name;
    if (!values_.refuses_undefined() || !is_name || !values_.is_zero(divisor.id)) return false;
    values_.fail(context.at(syntax.offset),
                 filled(tr("this is not a number: a division by 0, as {0} is 0"), {syntax.text}),
                 filled(tr("give {0} another value"), {syntax.text}));
    return true;
}

/// Builds an expression that follows a local value in a function's body.
ExpressionReader::Built ExpressionReader::with_local_value(const Syntax& syntax,
                                                           const Context& context) {
    const Built value = build(syntax.operands[0], context);
    if (!value) return std::nullopt;
    const LocalName local{.name = syntax.text, .value = *value, .outer = context.scope};
    return build(syntax.operands[1], context.with(&local));
}

/// Builds the values of a list in order, each once, so that a long list needs no deep stack.
ExpressionReader::Built ExpressionReader::last_of_list(const Syntax& syntax,
                                                       const Context& context) {
    Built last;
    for (const SyntaxId id : syntax.operands) {
        last = build(id, context.with(nullptr));
        if (!last) return last;
        earlier_.insert_or_assign(id, *last);
    }
    return last;
}

}  // namespace zeroset
