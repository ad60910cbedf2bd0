// Tells the radius of a textbook's equation, x^2 + y^2 + z^2 = r^2, from the distance r.

#include "engine/base/translation.hpp"
#include "engine/language/elaborator.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {
namespace {

bool is_distance(std::string_view name) { return name == "r" || name == "rho"; }

std::size_t axis_of(std::string_view name) {
    return name.size() == 1 ? std::string_view("xyz").find(name) : std::string_view::npos;
}

}  // namespace

/// Adds the terms of a sum, those behind a minus as negative ones.
void Elaborator::add_terms(SyntaxId id, bool negative, std::vector<Term>& terms) const {
    const Syntax& syntax = tree_[id];
    if (syntax.kind == SyntaxKind::Negate) {
        add_terms(syntax.operands[0], !negative, terms);
    } else if (syntax.kind == SyntaxKind::Sum) {
        for (std::size_t i = 0; i < syntax.operands.size(); ++i) {
            const bool subtracts = i > 0 && syntax.marks[i - 1] == '-';
            add_terms(syntax.operands[i], negative != subtracts, terms);
        }
    } else {
        terms.push_back({.at = id, .negative = negative});
    }
}

/// What of x, y and z a part of the tree names.
std::set<std::size_t> Elaborator::axes_in(SyntaxId root) const {
    std::set<std::size_t> axes;
    std::vector<SyntaxId> pending{root};
    while (!pending.empty()) {
        const Syntax& syntax = tree_[pending.back()];
        pending.pop_back();
        const std::size_t axis =
            syntax.kind == SyntaxKind::Name ? axis_of(syntax.text) : std::string_view::npos;
        if (axis != std::string_view::npos) axes.insert(axis);
        pending.insert(pending.end(), syntax.operands.begin(), syntax.operands.end());
    }
    return axes;
}

/// Whether squares of x and y, or of other two, stand against the square of a name in a sum:
/// x^2 + (y - 1)^2 - r^2, which were no sphere or cylinder if r were a distance.
bool Elaborator::is_squared_against_axes(std::string_view name, SyntaxId root) const {
    const Syntax& relation = tree_[root];
    const bool compares = relation.kind == SyntaxKind::Compare && relation.operands.size() == 2;
    std::vector<Term> terms;
    add_terms(compares ? relation.operands[0] : root, false, terms);
    if (compares) add_terms(relation.operands[1], true, terms);
    std::array<std::set<std::size_t>, 2> squared;  // axes in squares, added and subtracted
    std::array<bool, 2> against{};
    for (const Term& term : terms) {
        const Syntax& power = tree_[term.at];
        const bool is_square = power.kind == SyntaxKind::Power &&
                               tree_[power.operands[1]].kind == SyntaxKind::Number &&
                               tree_[power.operands[1]].text == "2";
        if (!is_square) continue;
        const Syntax& base = tree_[power.operands[0]];
        if (base.kind == SyntaxKind::Name && base.text == name) against.at(term.negative) = true;
        squared.at(term.negative).merge(axes_in(power.operands[0]));
    }
    return (against[0] && squared[1].size() > 1) || (against[1] && squared[0].size() > 1);
}

/// Whether a name stands in an exponent of something with coordinates.
bool Elaborator::is_exponent(std::string_view name, SyntaxId root) const {
    std::vector<SyntaxId> pending{root};
    while (!pending.empty()) {
        const Syntax& syntax = tree_[pending.back()];
        pending.pop_back();
        if (syntax.kind == SyntaxKind::Power) {
            const Syntax& exponent = tree_[syntax.operands[1]];
            const bool is_it = exponent.kind == SyntaxKind::Name && exponent.text == name;
            if (is_it && !axes_in(syntax.operands[0]).empty()) return true;
        }
        pending.insert(pending.end(), syntax.operands.begin(), syntax.operands.end());
    }
    return false;
}

/// Whether phi is the golden ratio in a statement, as in Barth's sextic, and no angle: it stands in
/// no function, beside two of x, y and z, and no other name of polar coordinates is there.
bool Elaborator::is_ratio(std::size_t statement) {
    const auto known = radii_.find({statement, "phi"});
    if (known != radii_.end()) return known->second;
    const Definition* const definition = table_.of_statement(statement);
    const SyntaxId root =
        definition != nullptr ? definition->body : tree_.statements[statement].relation;
    bool is_one = axes_in(root).size() > 1;
    std::vector<SyntaxId> pending{root};
    while (!pending.empty()) {
        const Syntax& syntax = tree_[pending.back()];
        pending.pop_back();
        const bool is_polar =
            syntax.kind == SyntaxKind::Name && (is_distance(syntax.text) || syntax.text == "theta");
        if (is_polar || (syntax.kind == SyntaxKind::Call && names(syntax, "phi"))) is_one = false;
        pending.insert(pending.end(), syntax.operands.begin(), syntax.operands.end());
    }
    return radii_[{statement, "phi"}] = is_one;
}

/// Whether a name stands in what is below a node.
bool Elaborator::names(const Syntax& root, std::string_view name) const {
    std::vector<SyntaxId> pending(root.operands);
    while (!pending.empty()) {
        const Syntax& syntax = tree_[pending.back()];
        pending.pop_back();
        if (syntax.kind == SyntaxKind::Name && syntax.text == name) return true;
        pending.insert(pending.end(), syntax.operands.begin(), syntax.operands.end());
    }
    return false;
}

/// Whether r or rho is a radius in a statement, and no distance from the origin or the z-axis:
/// where its square stands against those of coordinates, or x, y and R are in the statement, too,
/// in exponents, |x|^r + |y|^r = 1, and in points, which are given by no coordinates.
bool Elaborator::is_radius(std::string_view name, std::size_t statement) {
    if (!is_distance(name)) return false;
    const auto known = radii_.find({statement, std::string(name)});
    if (known != radii_.end()) return known->second;
    const Definition* const definition = table_.of_statement(statement);
    const SyntaxId root =
        definition != nullptr ? definition->body : tree_.statements[statement].relation;
    std::set<std::string_view> said;
    for (const NameUse& use : table_.uses(statement))
        said.insert(tree_[use.at].text);
    const bool is_point = definition == nullptr && may_be_patch(tree_.statements[statement]);
    const bool is_polar = !is_point && (said.contains("theta") || said.contains("phi"));
    const bool beside = name == "r" && said.contains("R") && axes_in(root).size() > 1;
    const bool is_one =
        is_point ||
        (!is_polar && (beside || is_squared_against_axes(name, root) || is_exponent(name, root)));
    return radii_[{statement, std::string(name)}] = is_one;
}

/// Whether an equation says nothing, as sqrt(x^2 + y^2 + z^2) = r, because r is a distance in it;
/// from here on it is a radius there.
bool Elaborator::makes_radius(std::size_t statement, NodeId root) {
    const Node& top = builder_.node(root);
    const Node& node = top.op == Op::Where ? builder_.node(top.a) : top;
    if (node.op != Op::Subtract || node.a != node.b) return false;
    bool makes = false;
    for (const NameUse& use : table_.uses(statement)) {
        const std::string& name = tree_[use.at].text;
        if (use.calls || !is_distance(name) || table_.meant(use, statement) != nullptr) continue;
        makes = radii_[{statement, name}] = true;
    }
    return makes;
}

/// A radius, which is a parameter.
Elaborator::Built Elaborator::radius(const Syntax& name) {
    notes_.add(name.offset,
               filled(tr("{0} is a parameter; for the coordinate type {1}"),
                      {name.text, name.text == "r" ? "sqrt(x^2 + y^2 + z^2)" : "sqrt(x^2 + y^2)"}));
    return parameter(name.text, name.offset);
}

}  // namespace zeroset
