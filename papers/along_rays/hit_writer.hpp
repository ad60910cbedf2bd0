#pragma once

#include "engine/trace/ray_lines.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "papers/along_rays/root_decision.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Hands on what is found on the rays of a tile.
class HitWriter {
public:
    HitWriter(const TileRays& rays, const RayLines& lines, TileHits& hits)
        : rays_(rays), lines_(lines), hits_(hits), unsettled_(std::size_t{tile_size} * tile_size) {}

    /// A hit at depth s; nothing is certified behind an unsettled stretch.
    void push(std::uint32_t pixel, double s, bool is_proved) {
        const RayLine& line = lines_.of(pixel);
        const bool certified = is_proved && !unsettled_[pixel] && lines_.certifies(line);
        const double distance =
            rays_.distance_at(s, rays_.u(pixel % tile_size), rays_.v(pixel / tile_size));
        hits_.push(at(pixel), line.at(s), static_cast<float>(distance),
                   certified ? Certificate::Certified : Certificate::Undecided);
    }
    /// Leaves a pixel unsettled: a root at depth s could be neither rejected nor drawn.
    void leave_unsettled(std::uint32_t pixel, double s) {
        if (unsettled_[pixel]) return;
        unsettled_[pixel] = true;
        const double u = rays_.u(pixel % tile_size);
        hits_.mark_unsettled(at(pixel), rays_.distance_before(s, u, rays_.v(pixel / tile_size)));
    }

    /// Takes what is known of a stretch; whether the ray ends there.
    bool take(const RayTask& task, StretchAnswer answer) {
        switch (answer) {
            case StretchAnswer::Free: return false;
            case StretchAnswer::Unsettled:
                leave_unsettled(task.pixel, task.stretch.from);
                return false;
            case StretchAnswer::Hit:
            case StretchAnswer::Certified: break;
        }
        push(task.pixel, task.stretch.middle(), answer == StretchAnswer::Certified);
        return true;
    }

private:
    static TileHits::Pixel at(std::uint32_t pixel) {
        return {.col = static_cast<std::int16_t>(pixel % tile_size),
                .row = static_cast<std::int16_t>(pixel / tile_size)};
    }

    const TileRays& rays_;
    const RayLines& lines_;
    TileHits& hits_;
    std::vector<bool> unsettled_;  ///< by pixels
};

}  // namespace zeroset
