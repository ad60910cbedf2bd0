#include "engine/language/rows/function_graphs.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/vocabulary/foreign.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace zeroset {

bool FunctionGraphs::may_read(const Definition& definition) const {
    DefinitionTable& table = reader_.table();
    const bool stands = table.of_statement(definition.statement) == &definition;
    const bool misspelt =
        !definition.is_certain && definition.name.size() > 2 && nearest_known_name(definition.name);
    const bool again = std::ranges::any_of(table.all(), [&](const Definition& other) {
        return other.name == definition.name && other.statement > definition.statement;
    });
    return stands && definition.is_function && !definition.is_called && !misspelt && !again;
}

std::expected<std::optional<RowSurface>, ParseError> FunctionGraphs::read(Definition& definition) {
    constexpr std::array<const char*, 3> axes{"x", "y", "z"};
    GraphValues& values = reader_.values();
    ExprBuilder& builder = values.builder();
    std::array<bool, 3> taken{};
    BuiltValues arguments;
    for (const std::string& argument : definition.arguments) {
        const auto axis =
            static_cast<std::size_t>(std::ranges::find(axes, argument) - axes.begin());
        if (axis == axes.size() || std::exchange(taken.at(axis), true)) return std::nullopt;
        arguments.push_back({.id = builder.variable(static_cast<int>(axis))});
    }
    if (arguments.size() != 2) return std::nullopt;
    const auto up = static_cast<std::size_t>(std::ranges::find(taken, false) - taken.begin());
    const std::size_t offset = reader_.tree().statements[definition.statement].offset;
    const NodeId height = builder.variable(static_cast<int>(up));
    for (const NodeId id : {arguments[0].id, arguments[1].id, height}) {
        if (!values.done(id, offset)) return values.failure();
    }
    const auto value =
        reader_.definitions().value(definition, arguments, {.statement = definition.statement});
    if (!value) return values.failure();
    if (value->condition || !value->is_single()) return std::nullopt;
    const NodeId root = make_subtract(builder, height, value->id);
    if (!values.done(root, offset)) return values.failure();
    RowResult graph = maker_.surface(definition.statement, root);
    if (!graph) return std::unexpected(graph.error());
    values.note(offset, filled(tr("this is the graph of {0}"),
                               {std::string(axes.at(up)) + " = " + definition.name + "(" +
                                definition.arguments[0] + ", " + definition.arguments[1] + ")"}));
    return std::move(*graph);
}

}  // namespace zeroset
