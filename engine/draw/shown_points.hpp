#pragma once

#include "engine/draw/space_curve.hpp"
#include "engine/draw/space_function.hpp"
#include "engine/expr/expr.hpp"
#include "engine/scene/scene.hpp"

#include <cstddef>
#include <functional>

namespace zeroset {

// Which points of curves are on a surface as it is shown: tests of single points, up to rounding.
// `scene` lives longer than what is returned.

using ShownAt = std::function<bool(const CurvePoint&)>;

/// Whether the surface's function is defined there and 0, as its piece is.
ShownAt where_piece_counts(const Scene& scene, std::size_t surface, const Expr& piece,
                           const KernelMaker& make_kernel);
/// Whether the surface's function is defined there.
ShownAt where_defined(const Scene& scene, std::size_t surface);
/// Whether branches of the piece meet there: not where the point's curve, on which the piece's
/// derivatives vanish, is all that there is of it, a line without a surface.
ShownAt where_branches_meet(const Scene& scene, const Expr& piece, const KernelMaker& make_kernel);
/// Whether the surface has an edge there: its normals on both sides of the border differ.
ShownAt where_edge(const Scene& scene, std::size_t surface, const Expr& whole, const Expr& border,
                   const KernelMaker& make_kernel);
/// Whether the surface ends there as its function jumps across the border: it is 0 on one side.
ShownAt where_jump(const Scene& scene, std::size_t surface, const Expr& border,
                   const KernelMaker& make_kernel);
/// Whether the surface's function is defined on one side of the border only.
ShownAt where_end(const Scene& scene, std::size_t surface, const Expr& border,
                  const KernelMaker& make_kernel);

}  // namespace zeroset
