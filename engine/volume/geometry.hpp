#pragma once

#include <array>
#include <optional>

namespace zeroset {

using Matrix3 = std::array<std::array<double, 3>, 3>;  ///< rows

/// Where the samples of a grid lie: sample (i, j, k) at origin + world_from_index (i, j, k), in the
/// axes and the units of the formula's x, y and z.
struct Geometry {
    Matrix3 world_from_index{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<double, 3> origin{};

    bool operator==(const Geometry&) const = default;
};

/// The map from the world to indices. These numbers are taken for exact: they are the volume's
/// place, to which `Geometry` was rounded once.
struct IndexMap {
    Matrix3 index_from_world;
    std::array<double, 3> shift;  ///< the index of the world's origin
};

/// Nothing where the axes are not finite or lie in one plane.
std::optional<IndexMap> index_map(const Geometry& geometry);

/// The point where the sample of these indices lies.
std::array<double, 3> world_point(const Geometry& geometry, const std::array<double, 3>& index);

}  // namespace zeroset
