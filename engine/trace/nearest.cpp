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
    for (std::size_t i = 0; i < hits.size; ++i) {
        const std::size_t at = hits.pixel[i].index();
        if (!(hits.depth[i] < depth_[at])) continue;
        depth_[at] = hits.depth[i];
        surface_[at] = surface;
    }
    for (const auto& [pixel, depth] : hits.unsettled)
        unsettled_[pixel.index()] = std::min(unsettled_[pixel.index()], depth);
}

void NearestSurfaces::keep_nearest(TileHits& hits, std::uint8_t surface) const {
    const std::size_t size = hits.size;
    hits.size = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const TileHits::Pixel pixel = hits.pixel[i];
        if (surface_[pixel.index()] != surface) continue;
        const bool settled = unsettled_[pixel.index()] > hits.depth[i];
        hits.move(i, hits.size);
        if (!settled) hits.certificate[hits.size] = Certificate::Undecided;
        ++hits.size;
    }
}

}  // namespace zeroset
