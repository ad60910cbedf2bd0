// The graphs of functions that stand alone.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"
#include "engine/language/vocabulary/foreign.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {

/// In a text of definitions only, functions of two of x, y and z that no other one calls are
/// surfaces: their graphs.
bool Elaborator::build_graphs() {
    if (!surfaces_.empty() || !without_surface_.empty()) return true;
    for (Definition& definition : table_.all()) {
        const bool stands = table_.of_statement(definition.statement) == &definition;
        const bool misspelt = !definition.is_certain && definition.name.size() > 2 &&
                              nearest_known_name(definition.name);
        const bool again = std::ranges::any_of(table_.all(), [&](const Definition& other) {
            return other.name == definition.name && other.statement > definition.statement;
        });
        if (!stands || !definition.is_function || definition.is_called || misspelt || again)
            continue;
        if (!build_graph(definition)) return false;
    }
    return true;
}

/// The graph of a function of two of x, y and z over their plane; nothing of another function.
bool Elaborator::build_graph(Definition& definition) {
    constexpr std::array<const char*, 3> axes{"x", "y", "z"};
    std::array<bool, 3> taken{};
    Values arguments;
    for (const std::string& argument : definition.arguments) {
        const auto axis =
            static_cast<std::size_t>(std::ranges::find(axes, argument) - axes.begin());
        if (axis == axes.size() || std::exchange(taken.at(axis), true)) return true;
        arguments.push_back({.id = builder_.variable(static_cast<int>(axis))});
    }
    if (arguments.size() != 2) return true;
    const auto up = static_cast<std::size_t>(std::ranges::find(taken, false) - taken.begin());
    const std::size_t offset = tree_.statements[definition.statement].offset;
    const NodeId height = builder_.variable(static_cast<int>(up));
    statement_ = definition.statement;
    for (const NodeId id : {arguments[0].id, arguments[1].id, height}) {
        if (!done(id, offset)) return false;
    }
    const Built value = function_value(definition, arguments);
    if (!value) return false;
    if (value->condition || !value->is_single()) return true;
    const NodeId root = make_subtract(builder_, height, value->id);
    if (!done(root, offset) || !add_surface(definition.statement, root)) return false;
    notes_.add(offset, filled(tr("this is the graph of {0}"),
                              {std::string(axes.at(up)) + " = " + definition.name + "(" +
                               definition.arguments[0] + ", " + definition.arguments[1] + ")"}));
    return true;
}

}  // namespace zeroset
