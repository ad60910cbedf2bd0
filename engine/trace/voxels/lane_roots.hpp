#pragma once

#include "engine/trace/voxels/ray_block.hpp"
#include "engine/volume/geometry.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The data shared by the rays of a bundle in the search for their roots, many at once.
struct BundleSearch {
    const IndexRays& rays;
    const IndexMap& map;
    WalkAxes axes;
    double enter, exit;    ///< between these depths all of them are inside the region
    double error, finest;  ///< as FirstRoot has them; 0: no bracket certifies a root
    double look_distance;  ///< as TileRays has it
    double sign;           ///< of f's gradient against that of the volume
};

/// Some rays of a bundle in a layer of trilinear cells, a lane each.
struct LaneRays {
    static constexpr std::size_t most = 8;
    using Numbers = std::array<double, most>;

    std::size_t count = 0;
    std::array<std::uint8_t, most> ray{};  ///< of the bundle
    alignas(64) Numbers u{}, v{};
    alignas(64) std::array<Numbers, 3> at{}, along{};  ///< as IndexRays has them
    alignas(64) Numbers from{}, until{};               ///< the stretch in the cell
    alignas(64) Numbers to{};                          ///< where the ray leaves the layer
    alignas(64) std::array<Numbers, 3> cell{};
    alignas(64) std::array<Numbers, 8> corners{};  ///< of the cells, as CellCorners
    /// The roots' distances from the eye, and f's gradients at them.
    alignas(64) Numbers distance{};
    alignas(64) std::array<std::array<float, most>, 3> gradient{};
};

/// Lanes, a bit each, on which f is known to be above or below 0.
struct LaneSides {
    std::uint32_t above = 0, below = 0;
};

/// Takes the rays of (u, v) into a layer, to their first cells; returns the lanes whose rays are
/// inside the region all through it.
std::uint32_t enter_layer(const BundleSearch& search, std::int32_t layer, LaneRays& rays);

/// Takes the rays to the next cells of the layer; returns those of these lanes that have one.
std::uint32_t next_cells(const BundleSearch& search, std::uint32_t lanes, LaneRays& rays);

/// Looks at the rays of these lanes in their cells; `sides`: of f before, updated. Returns the
/// lanes with a first root that is proved, as FirstRoot proves it. Adds the lanes of which nothing
/// is known to `unclear`.
std::uint32_t find_roots(const BundleSearch& search, std::uint32_t lanes, LaneRays& rays,
                         LaneSides& sides, std::uint32_t& unclear);

}  // namespace zeroset
