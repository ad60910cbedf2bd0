#pragma once

#include "engine/expr/expr.hpp"

#include <vector>

namespace zeroset {

// Graphs with kinks: abs, min and max.

/// Functions without kinks, one of which the function is at each point: its operands in place of
/// each abs (with either sign), min and max. Where those would be too many, the function itself.
std::vector<Expr> smooth_pieces(const Expr& f);

/// A place where a function may have an edge: where `border` is 0. `beside` is the function on one
/// side of it, and equal to it there.
struct CreaseBorder {
    Expr beside, border;
};
/// One for each abs, min and max of the graph.
std::vector<CreaseBorder> kinks_of(const Expr& f);

/// For each node whether it is a condition of a restriction, or what one is made of.
std::vector<bool> restrictions_in(const Expr& f);
/// Where a restriction of the function begins to hold: the differences of the sides of each
/// comparison in the restrictions of the graph.
std::vector<Expr> restriction_borders(const Expr& f);

}  // namespace zeroset
