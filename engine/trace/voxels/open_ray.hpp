#pragma once

#include "engine/trace/voxels/layer_walk.hpp"
#include "engine/trace/voxels/ray_block.hpp"
#include "engine/trace/voxels/ray_cubic.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// A ray of a bundle that came near the surface and has not ended.
struct OpenRay {
    std::uint32_t pixel = 0;
    IndexRays::Ray ray{};
    double per_layer = 0;  ///< depth from a layer to the next one up
    double from = 0, to = 0;
    FirstRoot root = {};

    /// The stretch of the ray in a layer along an axis, as far as it is looked for roots.
    [[nodiscard]] LayerStretch stretch_in(std::int32_t layer, std::size_t axis) const {
        const auto [first, last] = std::minmax(
            {(layer - ray.at[axis]) * per_layer, (layer + 1 - ray.at[axis]) * per_layer});
        return {.from = std::max(first, from), .to = std::min(last, to)};
    }
};

}  // namespace zeroset
