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
namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};

}  // namespace

/// In a text of definitions only, functions that no other one calls are surfaces: of two of x, y
/// and z their graphs, of all three or of a point where they are 0.
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
        if (!build_graph(definition) || !build_zeros(definition)) return false;
    }
    return true;
}

/// The graph of a function of two of x, y and z over their plane; nothing of another function.
bool Elaborator::build_graph(Definition& definition) {
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

/// Where a function of x, y and z, or of a point alone, is 0; nothing of another function.
bool Elaborator::build_zeros(Definition& definition) {
    const std::vector<std::string>& names = definition.arguments;
    const bool of_axes = names == std::vector<std::string>{"x", "y", "z"};
    const auto names_axis = [&](const NameUse& use) {
        return std::ranges::find(axes, tree_[use.at].text) != axes.end();
    };
    const bool of_point =
        names.size() == 1 && std::ranges::none_of(table_.uses(definition.statement), names_axis);
    if (!of_axes && !of_point) return true;
    const std::size_t offset = tree_.statements[definition.statement].offset;
    statement_ = definition.statement;
    Values point;
    for (const int axis : {0, 1, 2}) {
        point.push_back({.id = builder_.variable(axis)});
        if (!done(point.back().id, offset)) return false;
    }
    const Values arguments = of_axes ? point : Values{bundle(Value::Kind::Vector, point)};
    const Built value = function_value(definition, arguments);
    if (!value && of_axes) return false;
    const bool is_surface =
        value && value->is_single() && !value->condition && uses_space(value->id);
    if (!value) error_.reset();
    if (!is_surface) return true;
    if (!add_surface(definition.statement, value->id)) return false;
    std::string call = definition.name + "(" + names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
        call += ", " + names[i];
    call += ")";
    notes_.add(offset, filled(tr("{0} is read as {1}"), {call, call + " = 0"}));
    return true;
}

}  // namespace zeroset
