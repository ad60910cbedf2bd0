#include "engine/language/parse.hpp"

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

}  // namespace

std::expected<Program, ParseError> read_program(std::string_view text, const FieldSource* files,
                                                std::span<const CutText> cuts) {
    const auto tree = read_syntax(text);
    if (!tree) return std::unexpected(tree.error());
    Elaborator elaborator(*tree, files);
    elaborator.cut(cuts);
    return elaborator.program();
}

std::expected<Expr, ParseError> read_value(std::string_view expression, std::string_view program,
                                           std::span<const std::string> parameters,
                                           const FieldSource* files) {
    // The expression is first read alone, since it must be one statement whatever program precedes
    // it.
    const auto alone = read_syntax(expression);
    if (!alone) return std::unexpected(alone.error());
    if (alone->statements.size() > 1) {
        return std::unexpected(ParseError{.offset = alone->statements[1].offset,
                                          .reason = tr("there is a second expression"),
                                          .hint = tr("type one of them")});
    }
    std::string text(program);
    text += "\n;\n";
    const std::size_t begin = text.size();
    text += expression;
    const auto tree = read_syntax(text, begin);
    auto value =
        tree ? Elaborator(*tree, files, begin).last_value() : std::unexpected(tree.error());
    if (!value) {
        ParseError error = value.error();
        error.offset -= std::min(error.offset, begin);
        return std::unexpected(error);
    }
    return renumbered(*value, parameters);
}

std::expected<Expr, ParseError> parse(std::string_view text) {
    const auto tree = read_syntax(text);
    if (!tree) return std::unexpected(tree.error());
    return Elaborator(*tree, nullptr).formula();
}

}  // namespace zeroset
