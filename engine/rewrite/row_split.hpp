#pragma once

#include "engine/expr/expr.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace zeroset {

/// A function f on the rows along x of a grid, taken apart so that what depends on fewer
/// coordinates is not computed again at each point. It has f's bits at every point.
struct RowSplit {
    static constexpr std::size_t most_tables = 3;

    /// The rest, for each point. Its coordinates are the tables' values at the point's x; its
    /// variables from w on are f's, then the values of `of_row`.
    Expr along;
    std::vector<Expr> tables;  ///< functions of x, at most three
    std::vector<Expr> of_row;  ///< functions of y and z
};

/// Takes a function of x, y and z apart.
RowSplit split_for_rows(const Expr& f);

}  // namespace zeroset
