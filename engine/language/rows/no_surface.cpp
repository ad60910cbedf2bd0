#include "engine/language/rows/no_surface.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/foreign.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {
namespace {

/// A hint for a text without a surface: tann(x) = y defines tann, but may have been meant as tan.
std::string hint_without_surface(const SyntaxTree& tree, DefinitionTable& table) {
    const Definition* const last = table.of_statement(tree.statements.size() - 1);
    const bool is_function = last != nullptr && last->is_function;
    if (is_function && !last->is_certain && last->name.size() > 2) {
        if (const auto meant = nearest_known_name(last->name))
            return filled(tr("this defines {0}; did you mean {1}?"), {last->name, *meant});
    }
    if (is_function && last->arguments == std::vector<std::string>{"x", "y", "z"})
        return filled(tr("type {0} on the next line"), {last->name + "(x, y, z) = 0"});
    const auto goes_by = [&](std::span<const std::string> names) {
        return last != nullptr && table.going_by(names).contains(last);
    };
    if (is_function && last->arguments == std::vector<std::string>{"x"}) {
        if (goes_by(std::vector<std::string>{"y", "z"}))
            return filled(tr("type {0} on the next line"), {last->name + "(x) = 0"});
        return filled(tr("type {0} on the next line"), {"y = " + last->name + "(x)"});
    }
    if (!is_function && goes_by(std::vector<std::string>{"x", "y", "z", "r", "rho"}))
        return filled(tr("type {0} on the next line"), {last->name + " = 0"});
    return filled(tr("type an equation such as {0} on the next line"), {"x^2 + y^2 + z^2 = 1"});
}

}  // namespace

ParseError error_without_surface(const SyntaxTree& tree, DefinitionTable& table) {
    return {.offset = tree.statements.back().offset,
            .reason = tr("there is no surface yet, only definitions"),
            .hint = hint_without_surface(tree, table),
            .unfinished = true};
}

std::optional<ParseError> error_for_parametric(const SyntaxTree& tree, DefinitionTable& table) {
    std::array<bool, 3> given{};
    std::array<bool, 2> used{};
    for (std::size_t i = 0; i < tree.statements.size(); ++i) {
        const Syntax& relation = tree[tree.statements[i].relation];
        if (relation.kind != SyntaxKind::Compare || relation.marks != "=") continue;
        const Syntax& left = tree[relation.operands[0]];
        const std::size_t axis = std::string_view("xyz").find(left.text);
        if (left.text.size() != 1 || axis > 2) continue;
        if (left.kind == SyntaxKind::Call && left.operands.size() == 2) used = {true, true};
        bool uses_axis = false;
        for (const NameUse& use : table.uses(i)) {
            const std::string& name = tree[use.at].text;
            const bool is_free = use.at != relation.operands[0] && table.meant(use, i) == nullptr;
            uses_axis = uses_axis || (is_free && (name == "x" || name == "y" || name == "z"));
            used[0] = used[0] || (is_free && name == "u");
            used[1] = used[1] || (is_free && name == "v");
        }
        given.at(axis) = given.at(axis) || !uses_axis;
    }
    const auto all = [](const auto& flags) { return std::ranges::all_of(flags, std::identity{}); };
    if (!all(given) || !all(used)) return std::nullopt;
    return ParseError{.offset = tree.statements.front().offset,
                      .reason = tr("x, y and z given by u and v in rows of their own are not read"),
                      .hint = filled(tr("type them as a point in one row: {0}"),
                                     {"(u cos v, u sin v, v), 0 < u < 1, 0 < v < 2 pi"})};
}

}  // namespace zeroset
