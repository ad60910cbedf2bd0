#pragma once

#include "engine/expr/expr.hpp"

#include <memory>
#include <optional>
#include <vector>

// Functions that belong to a surface's: without its restrictions, whose level it is, whose zeros
// are its own, where it is defined. Each has a source of its own.

namespace zeroset {

/// A field whose values at points are compared with a level.
struct LevelOfField {
    std::shared_ptr<const Field> field;
    Expr level;  ///< without x, y and z
};

/// The field and the level of an f that is field(x, y, z) - level or level - field(x, y, z):
/// neither scaled, nor at another point, nor restricted. Nothing for any other f.
std::optional<LevelOfField> level_of_field(const Expr& f);

/// A function and what restricts it as a whole: it is defined where no bound is above 0, but for
/// the places where one is 0.
struct RestrictedExpr {
    Expr function;
    std::vector<Expr> bounds;  ///< continuous where what they compare is
};

/// Takes the restrictions off the root whose conditions are comparisons, joined by and, or, not;
/// the others stay.
RestrictedExpr without_restriction(const Expr& expr);

/// Functions each of whose zeros is one of f where f is defined; at most a few, none where f is its
/// only one. f^2, -f max(f, g) and if(u < v, g, u - v) touch 0 or jump to it where one of their
/// parts crosses it: a proved root of that part is one of the whole. Remainders jump to 0 where the
/// one that is nearest to 0 crosses it.
std::vector<Expr> root_witnesses(const Expr& f);

/// Whether it is defined for all values of the variables; not seen for all that are.
bool is_defined_everywhere(const Expr& f);

/// A function such that f is defined wherever it is continuous: a sum of the operators of f that
/// lack values, and of 1/(x^2 + y^2) for angles. Nothing where that cannot be told.
std::optional<Expr> domain_witness(const Expr& f);

/// The function without its restrictions: what it would be where they do not hold. Nothing where it
/// has none.
std::optional<Expr> unrestricted(const Expr& expr);

/// The function whose level a surface f = 0 is: g where f is g - c or c - g, as g = c is read, for
/// a c without x, y and z; else f itself. Without restrictions of f: it is asked for only where
/// they hold.
Expr value_side(const Expr& f);

}  // namespace zeroset
