#include "engine/language/rows/distance_note.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/angles.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

namespace zeroset {
namespace {

/// Where an expression begins, in bytes of the text.
std::size_t begin_of(const SyntaxTree& tree, SyntaxId id) {
    const Syntax* part = &tree[id];
    std::size_t begin = part->offset;
    while (!part->operands.empty()) {
        part = &tree[part->operands[0]];
        begin = std::min(begin, part->offset);
    }
    return begin;
}

}  // namespace

void note_distance(const SyntaxTree& tree, DefinitionTable& table, std::size_t statement,
                   Notes& notes) {
    const StatementSyntax& syntax = tree.statements[statement];
    const Syntax& relation = tree[syntax.relation];
    const std::size_t end =
        syntax.restrictions.empty() ? std::string::npos : begin_of(tree, syntax.restrictions[0]);
    std::map<std::string_view, SyntaxId> said;
    const auto add = [&](const NameUse& use) {
        const Syntax& name = tree[use.at];
        const bool is_free = name.kind == SyntaxKind::Name && name.offset < end &&
                             table.meant(use, statement) == nullptr;
        if (is_free) said.try_emplace(name.text, use.at);
    };
    std::ranges::for_each(table.uses(statement), add);
    if (relation.kind == SyntaxKind::Compare) add({.at = relation.operands[0], .calls = false});
    const auto r = said.find("r");
    if (r != said.end() && said.contains("x") && said.contains("y") && said.contains("z")) {
        notes.add(tree[r->second].offset,
                  filled(tr("{0} is {1}; for a radius with a slider type {2}"),
                         {"r", "sqrt(x^2 + y^2 + z^2)", "R"}));
    }
    const auto theta = said.find("theta");
    const auto phi = said.find("phi");
    const bool is_angle = theta != said.end() || phi != said.end();
    const bool are_both = theta != said.end() && phi != said.end();
    if (are_both || (is_angle && r != said.end())) {
        notes.add(
            tree[(theta != said.end() ? theta : phi)->second].offset,
            filled(tr("{0} is the angle about the z-axis and {1} the one from it; where a text "
                      "means them the other way, as in physics, add the row {2}"),
                   {"theta", "phi", std::string(angles_swapped)}));
    }
    if (said.contains("x") || said.contains("y")) return;
    const auto rho = said.find("rho");
    const bool is_spherical = said.contains("phi");
    if (r != said.end() && !is_spherical && (said.contains("z") || said.contains("theta"))) {
        notes.add(tree[r->second].offset,
                  filled(tr("{0} is {1}; for the distance from the z-axis type {2}"),
                         {"r", "sqrt(x^2 + y^2 + z^2)", "rho"}));
    }
    if (rho != said.end() && is_spherical) {
        notes.add(tree[rho->second].offset,
                  filled(tr("{0} is {1}; for the distance from the origin type {2}"),
                         {"rho", "sqrt(x^2 + y^2)", "r"}));
    }
}

}  // namespace zeroset
