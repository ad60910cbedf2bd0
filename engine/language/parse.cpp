#include "engine/language/parse.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/expr/copy.hpp"
#include "engine/language/elaborator.hpp"

#include <algorithm>
#include <vector>

namespace zeroset {
namespace {

ParseError unknown_parameter(const std::string& name, std::span<const std::string> parameters) {
    std::string names;
    for (const std::string& parameter : parameters)
        names += (names.empty() ? "" : " ") + parameter;
    return {.offset = 0,
            .reason = filled(tr("there is no parameter {0}"), {"'" + name + "'"}),
            .hint = parameters.empty() ? tr("the formula has none")
                                       : filled(tr("the formula's are {0}"), {names})};
}

/// The graph with its parameters renumbered to their places in `parameters`.
std::expected<Expr, ParseError> renumbered(const Expr& expr,
                                           std::span<const std::string> parameters) {
    constexpr int first = variable_w + 1;
    ExprBuilder builder;
    std::vector<NodeId> copies;
    for (const Node& node : expr.nodes()) {
        if (node.op != Op::Variable || node.number < first) {
            copies.push_back(copy_node(builder, node, copies));
            continue;
        }
        const std::string& name = expr.parameters()[static_cast<std::size_t>(node.number - first)];
        const auto found = std::ranges::find(parameters, name);
        if (found == parameters.end()) return std::unexpected(unknown_parameter(name, parameters));
        copies.push_back(builder.variable(first + static_cast<int>(found - parameters.begin())));
    }
    return builder.finish(copies.back(), {parameters.begin(), parameters.end()});
}

/// The value of an expression without variables.
std::optional<double> constant_of(const std::string& expression, std::string_view program,
                                  const FieldSource* files) {
    if (const auto number = number_from<double>(expression)) return number;
    const auto value = read_value(expression, program, {}, files);
    if (!value) return std::nullopt;
    const Facts facts = facts_of(*value).back();
    return facts.constant ? std::optional(facts.middle) : std::nullopt;
}

/// The ends of a range that a command gives; nothing where they are no two numbers in order.
std::optional<std::array<double, 2>> ends_of(const AskedRange& range, std::string_view program,
                                             const FieldSource* files) {
    const auto lo = constant_of(range.lo, program, files);
    const auto hi = lo ? constant_of(range.hi, program, files) : std::nullopt;
    return hi && *lo < *hi ? std::optional(std::array{*lo, *hi}) : std::nullopt;
}

}  // namespace

std::expected<Program, ParseError> read_program(std::string_view text, const FieldSource* files,
                                                std::span<const CutText> cuts) {
    const auto tree = read_syntax(text);
    if (!tree) return std::unexpected(tree.error());
    auto program = Elaborator(*tree, files, std::string_view::npos, cuts).program();
    if (!program) return program;
    for (std::size_t axis = 0; axis < tree->box.size(); ++axis) {
        if (!tree->box.at(axis)) continue;
        const auto ends = ends_of(*tree->box.at(axis), text, files);
        if (!ends) {
            return std::unexpected(
                ParseError{.offset = tree->box_offset,
                           .reason = tr("the ends of a range are two numbers, the lower one first"),
                           .hint = tr("type them as numbers, such as -2 and 2")});
        }
        program->box.at(axis) = ends;
    }
    return program;
}

std::expected<Expr, ParseError> read_value(std::string_view expression, std::string_view program,
                                           std::span<const std::string> parameters,
                                           const FieldSource* files) {
    std::string text(program);
    text += "\n;\n";
    const std::size_t begin = text.size();
    text += expression;
    const auto at_expression = [&](ParseError error) {
        error.offset -= std::min(error.offset, begin);
        return std::unexpected(std::move(error));
    };
    const auto tree = read_syntax(text, begin);
    if (!tree) return at_expression(tree.error());
    const auto is_own = [&](const StatementSyntax& statement) { return statement.offset >= begin; };
    const auto own = std::ranges::find_if(tree->statements, is_own);
    if (own == tree->statements.end()) {
        const auto nothing = read_syntax(expression);
        if (!nothing) return std::unexpected(nothing.error());
    }
    if (tree->statements.end() - own > 1) {
        return at_expression({.offset = std::next(own)->offset,
                              .reason = tr("there is a second expression"),
                              .hint = tr("type one of them")});
    }
    auto value = Elaborator(*tree, files, begin).last_value();
    if (!value) return at_expression(value.error());
    return renumbered(*value, parameters);
}

std::expected<Expr, ParseError> parse(std::string_view text) {
    const auto tree = read_syntax(text);
    if (!tree) return std::unexpected(tree.error());
    return Elaborator(*tree, nullptr).formula();
}

}  // namespace zeroset
