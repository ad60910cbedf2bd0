#pragma once

#include "engine/trace/voxels/ray_cubic.hpp"

#include <array>
#include <cstddef>

namespace zeroset {

/// The coefficients about a cell of a cubic B-spline, less the level: 4 along each axis, the first
/// one fastest.
using CellCoefficients = std::array<double, 64>;

/// The spline on a stretch whose ends lie at the places `at_from` and `at_to` in the cell, as parts
/// of its edges. Its coefficients lie between those of the cell.
RayNonic ray_nonic(const CellCoefficients& cell, const std::array<double, 3>& at_from,
                   const std::array<double, 3>& at_to, double from, double to);

/// The slopes of the spline along the cell's axes at a place in it.
std::array<double, 3> cell_slopes(const CellCoefficients& cell, const std::array<double, 3>& at);

/// The numbers of a cell, `support` along each axis: 2 where f is trilinear, 4 of a cubic spline.
template <std::size_t support>
using CellNumbers = std::array<double, support * support * support>;

inline RayCubic ray_polynomial(const CellCorners& corners, const std::array<double, 3>& at_from,
                               const std::array<double, 3>& at_to, double from, double to) {
    return ray_cubic(corners, at_from, at_to, from, to);
}
inline RayNonic ray_polynomial(const CellCoefficients& cell, const std::array<double, 3>& at_from,
                               const std::array<double, 3>& at_to, double from, double to) {
    return ray_nonic(cell, at_from, at_to, from, to);
}

}  // namespace zeroset
