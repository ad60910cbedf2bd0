#include "engine/trace/nearest.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace zeroset {

NearestSurfaces::NearestSurfaces() {
    constexpr std::size_t pixels = static_cast<std::size_t>(tile_size) * tile_size;
    depth_.resize(pixels);
    unsettled_.resize(pixels);
    surface_.resize(pixels);
    clear();
}

void NearestSurfaces::clear() {
    std::ranges::fill(depth_, std::numeric_limits<float>::infinity());
    std::ranges::fill(unsettled_, std::numeric_limits<float>::infinity());
    std::ranges::fill(surface_, no_surface);
}

void NearestSurfaces::add(const TileHits& hits, std::uint8_t surface) {
    for (std::size_t at = 0; at < depth_.size(); ++at) {
        if (hits.depth[at] < depth_[at]) {
            depth_[at] = hits.depth[at];
            surface_[at] = surface;
        }
        unsettled_[at] = std::min(unsettled_[at], hits.unsettled[at]);
    }
}

void NearestSurfaces::keep_nearest(TileHits& hits, std::uint8_t surface) const {
    for (std::size_t at = 0; at < depth_.size(); ++at) {
        if (surface_[at] != surface) {
            hits.depth[at] = std::numeric_limits<float>::infinity();
        } else if (!(unsettled_[at] > hits.depth[at])) {
            hits.certificate[at] = Certificate::Undecided;
        }
    }
}

}  // namespace zeroset
