#pragma once

#include "engine/draw/space_function.hpp"
#include "engine/expr/expr.hpp"

#include <functional>
#include <vector>

namespace zeroset {

/// A surface of space on which a function may jump, or have an edge: where `border` is 0.
struct Seam {
    Expr border;
    std::vector<Expr> beside;  ///< what the function may be next to it
};

struct Seams {
    std::vector<Seam> list;
    bool complete = true;  ///< false: there were too many
};

/// The seams of a graph's steps, conditions, remainders and angles; those of kinks are `kinks_of`.
/// `values_of` bounds what a formula may be, where seams are wanted.
Seams seams_of(const Expr& f, const std::function<Bounds(const Expr&)>& values_of);

}  // namespace zeroset
