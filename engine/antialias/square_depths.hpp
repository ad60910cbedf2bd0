#pragma once

#include "engine/antialias/ray_stretches.hpp"
#include "engine/trace/tile_rays.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace zeroset {

/// Places of squares of one size, and where their rays are inside of the clip region, as
/// TileRays::depths has it. Plain data, nothing of it set at first.
struct SquareDepths {
    static constexpr std::size_t capacity = 64;

    alignas(64) std::array<double, capacity> u, v;
    alignas(64) std::array<double, capacity> enter_lo, enter_hi, exit_lo, exit_hi;  ///< out
    /// The hits of their middle rays: distances; out: their depths.
    alignas(64) std::array<double, capacity> hit;

    [[nodiscard]] DepthRange range(std::size_t i) const {
        return {.enter_lo = enter_lo[i],
                .enter_hi = enter_hi[i],
                .exit_lo = exit_lo[i],
                .exit_hi = exit_hi[i]};
    }
};

/// Fills in what is `out` of the first `count`; `radius`: of the squares, in u and v. In upward
/// rounding.
void find_depths(const TileRays& rays, double radius, std::size_t count, SquareDepths& squares);

/// Turns the first `count` hits' distances from the eye, as Framebuffer has them, into depths.
void find_hits(const TileRays& rays, std::size_t count, SquareDepths& squares);

/// Shortens stretches to where their rays are inside of the clip region.
void clip_stretches(const TileRays& rays, std::span<RayStretch> stretches);

}  // namespace zeroset
