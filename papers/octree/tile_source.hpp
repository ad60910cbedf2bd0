#pragma once

#include "engine/real/scalar.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "papers/octree/leaf_tests.hpp"
#include "papers/octree/octree_ray.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace zeroset {

/// A bound of distances from the eye, surely no farther than the point at T on a ray.
inline float distance_before(const TraceFrame& frame, const OctreeRay& ray, double parameter) {
    const double distance = frame.view.distance_of(ray.point(parameter));
    const double before = distance - 0x1p-20 * std::abs(distance) - place_error(frame);
    return -float_above(-(frame.view.parallel() ? before : std::max(before, 0.0)));
}

/// The rays of a tile's pixels, and what is found on them.
class TileSource {
public:
    TileSource(const TraceFrame& frame, const Tile& tile, TileHits& hits)
        : frame_(frame), tile_(tile), hits_(hits), rays_(frame, tile) {}

    /// The next ray, with a name; nothing when there are no more.
    [[nodiscard]] std::optional<std::pair<OctreeRay, TileHits::Pixel>> next(
        const OctreeSpace& space) {
        while (next_pixel_ < tile_.cols * tile_.rows) {
            const TileHits::Pixel pixel{.col = static_cast<std::int16_t>(next_pixel_ % tile_.cols),
                                        .row = static_cast<std::int16_t>(next_pixel_ / tile_.cols)};
            ++next_pixel_;
            if (const auto ray = octree_ray(frame_, tile_, rays_, space, pixel.col, pixel.row))
                return std::pair{*ray, pixel};
        }
        return std::nullopt;
    }
    /// From T on the ray is not settled.
    void leave(TileHits::Pixel pixel, const OctreeRay& ray, double parameter) {
        hits_.mark_unsettled(pixel, distance_before(frame_, ray, parameter));
    }
    void hit(TileHits::Pixel pixel, const OctreeRay& ray, const LeafCase& judged, bool certified) {
        const glm::dvec3 at = ray.point(judged.from + 0.5 * (judged.to - judged.from));
        hits_.push(pixel, {at.x, at.y, at.z}, static_cast<float>(frame_.view.distance_of(at)),
                   certified ? Certificate::Certified : Certificate::Undecided);
    }
    void stop() { hits_.leave_undecided(tile_); }

private:
    const TraceFrame& frame_;
    const Tile& tile_;
    TileHits& hits_;
    TileRays rays_;
    int next_pixel_ = 0;
};

}  // namespace zeroset
