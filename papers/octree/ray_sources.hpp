#pragma once

#include "engine/real/scalar.hpp"
#include "engine/trace/single_rays.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "papers/octree/leaf_tests.hpp"
#include "papers/octree/octree_ray.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

// Where the octree's tracers have their rays from, and whom they tell what is found.

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

    static constexpr bool has_pixels = true;

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

/// Rays from anywhere, at most most_single_rays.
constexpr std::size_t most_single_rays = 1 << 14;
class SingleSource {
public:
    SingleSource(std::span<const SingleRay> rays, std::span<SingleRoot> roots,
                 const TraceFrame& frame)
        : frame_(frame), rays_(rays), roots_(roots) {}

    static constexpr bool has_pixels = false;  ///< names of rays are places in a tile

    [[nodiscard]] std::optional<std::pair<OctreeRay, TileHits::Pixel>> next(
        const OctreeSpace& space) {
        while (next_ < rays_.size()) {
            const std::size_t i = next_++;
            if (const auto ray = octree_ray(frame_, rays_[i], space))
                return std::pair{*ray,
                                 TileHits::Pixel{.col = static_cast<std::int16_t>(i), .row = 0}};
        }
        return std::nullopt;
    }
    void leave(TileHits::Pixel pixel, const OctreeRay&, double) { root(pixel).unsettled = true; }
    void hit(TileHits::Pixel pixel, const OctreeRay& ray, const LeafCase& judged, bool certified) {
        SingleRoot& found = root(pixel);
        found.is_found = true;
        found.is_proved = certified;
        const SingleRay& single = rays_[static_cast<std::size_t>(pixel.col)];
        const auto t_of = [&](double parameter) {
            return (ray.point(parameter)[ray.k] - single.origin[ray.k]) / single.direction[ray.k];
        };
        found.from = t_of(judged.from);
        found.to = t_of(judged.to);
    }
    void stop() {
        for (SingleRoot& found : roots_)
            found.unsettled = found.unsettled || !found.is_found;
    }

private:
    SingleRoot& root(TileHits::Pixel pixel) { return roots_[static_cast<std::size_t>(pixel.col)]; }

    const TraceFrame& frame_;
    std::span<const SingleRay> rays_;
    std::span<SingleRoot> roots_;
    std::size_t next_ = 0;
};

}  // namespace zeroset
