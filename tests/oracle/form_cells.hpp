#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/view/camera.hpp"
#include "tests/support/random_numbers.hpp"

#include <array>
#include <cstddef>

namespace zeroset::test {

inline constexpr std::size_t cells_a_batch = batch_multiple;

/// A place on a ray of a view: base + (distance + s) (u right + v up) + s forward, exactly.
struct RayPlace {
    float col, row;  ///< ray's place in pixels, from the tile's first
    double u, v, s;
};

/// Cells of one view, the places in them at which they are checked, and w.
template <class Real>
struct FormCells {
    ViewFrame view{Camera{}};
    glm::dvec3 base{};      ///< TileRays::base
    double distance = 0;    ///< TileRays::distance
    RaysOf<double> rays{};  ///< rays of the tile, for values
    FrustumOf<Real> frustum{};
    std::array<Real, cells_a_batch> u{}, v{}, s{}, s_radius{};
    std::array<RayPlace, cells_a_batch> near{};  ///< a place in each cell
    std::array<RayPlace, cells_a_batch> far{};   ///< a place on the same ray, not nearer
    Uniforms uniforms;
    double w = 0;  ///< value of w at the places
};

/// Cells as tracers make them and random ones, in views that are likely to find faults: from tiny
/// to huge, along axes, beside the eye, deep in a zoom.
template <class Real>
FormCells<Real> random_cells(RandomNumbers& random);

}  // namespace zeroset::test
