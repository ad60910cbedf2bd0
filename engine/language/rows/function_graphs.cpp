#include "engine/language/rows/function_graphs.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/vocabulary/foreign.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace zeroset {

bool FunctionGraphs::may_read(const Definition& definition) const {
    DefinitionTable& table = reader_.table();
    const bool stands = table.of_statement(definition.statement) == &definition;
    const auto meant = nearest_known_name(definition.name);
    const bool misspelt =
        !definition.is_certain && definition.name.size() > 2 && meant && *meant != definition.name;
    const bool again = std::ranges::any_of(table.all(), [&](const Definition& other) {
        return other.name == definition.name && other.statement > definition.statement;
    });
    return stands && definition.is_function && !definition.is_called && !misspelt && !again;
}

FunctionGraphs::Result FunctionGraphs::read(Definition& definition) {
    constexpr std::array<const char*, 3> axes{"x", "y", "z"};
    ExprBuilder& builder = reader_.values().builder();
    std::array<bool, 3> taken{};
    BuiltValues arguments;
    for (const std::string& argument : definition.arguments) {
        const auto axis =
            static_cast<std::size_t>(std::ranges::find(axes, argument) - axes.begin());
        if (axis == axes.size() && definition.arguments.size() == 1)
            return read_of_point(definition);
        if (axis == axes.size() || std::exchange(taken.at(axis), true)) return std::nullopt;
        arguments.push_back({.id = builder.variable(static_cast<int>(axis))});
    }
    if (arguments.size() == 3) return surface(definition, arguments, {});
    if (arguments.size() != 2) return std::nullopt;
    const auto up = static_cast<std::size_t>(std::ranges::find(taken, false) - taken.begin());
    return surface(definition, arguments, axes.at(up));
}

/// The surface where a function of a vector is 0; nothing where it may be one of a number.
FunctionGraphs::Result FunctionGraphs::read_of_point(Definition& definition) {
    GraphValues& values = reader_.values();
    BuiltValues point;
    for (const int axis : {0, 1, 2})
        point.push_back({.id = values.builder().variable(axis)});
    if (!values.done(point.back().id, offset_of(definition))) return values.failure();
    const auto value = [&](const BuiltValue& argument) {
        const auto found = reader_.definitions().value(definition, {argument},
                                                       {.statement = definition.statement});
        if (!found) static_cast<void>(values.failure());
        return found.has_value();
    };
    const BuiltValue vector = BuiltValue::vector(std::move(point));
    if (!value(vector)) return std::nullopt;
    return surface(definition, {vector}, {});
}

/// The surface where a function is 0, or its graph over the other two axes than `up`, where that is
/// given; nothing where its value is no number, or goes by no point.
FunctionGraphs::Result FunctionGraphs::surface(Definition& definition, const BuiltValues& arguments,
                                               std::string_view up) {
    GraphValues& values = reader_.values();
    ExprBuilder& builder = values.builder();
    const std::size_t offset = offset_of(definition);
    for (const int axis : {0, 1, 2}) {
        if (!values.done(builder.variable(axis), offset)) return values.failure();
    }
    const auto value =
        reader_.definitions().value(definition, arguments, {.statement = definition.statement});
    if (!value) return values.failure();
    if (value->condition || !value->is_single()) return std::nullopt;
    if (up.empty() && !values.uses_space(value->id)) return std::nullopt;
    const NodeId root = up.empty()
                            ? value->id
                            : make_subtract(builder, builder.variable(up.front() - 'x'), value->id);
    if (!values.done(root, offset)) return values.failure();
    RowResult row = maker_.surface(definition.statement, root);
    if (!row) return std::unexpected(row.error());
    std::string call = definition.name + "(";
    for (const std::string& argument : definition.arguments)
        call += (call.ends_with('(') ? "" : ", ") + argument;
    call += ")";
    values.note(offset, up.empty() ? filled(tr("this is drawn where {0}"), {call + " = 0"})
                                   : filled(tr("this is the graph of {0}"),
                                            {std::string(up) + " = " + call}));
    return std::move(*row);
}

}  // namespace zeroset
