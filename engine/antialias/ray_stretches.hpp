#pragma once

#include "engine/antialias/square_rays.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace zeroset {

/// A stretch of a ray of a tile, and how near to 0 f comes in it, as far as samples tell.
struct RayStretch {
    double col, row;  ///< of the ray, as TileRays counts pixels
    double from, to;  ///< depths; the stretch is empty where from > to

    double near = 0.0;  ///< out: f at `from`
    double far = 0.0;   ///< out: f at `to`
    /// out: the least of f where near >= 0, else of -f: at most 0 behind a root; and where that is
    double least = 0.0, at = 0.0;
    bool inner = false;  ///< out: df/ds is 0 there; else it is at an end
    /// out: how `least` changes from ray to ray, a pixel to the right and downwards.
    double by_col = 0.0, by_row = 0.0;

    /// Whether f goes through 0 between `from` and `at`.
    [[nodiscard]] bool has_root() const { return !is_empty() && least <= 0.0; }
    [[nodiscard]] bool is_empty() const { return !(from <= to); }
};

/// A stretch of each of a square's rays.
using SquareStretches = std::span<const RayStretch, square_ray_count>;
/// A stretch of the ray at each of its corners.
using CornerStretches = std::span<const RayStretch, square_corners.size()>;

/// Fills in what is `out`. In double; in upward rounding, as all here.
void find_least(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                Counters& counters);

/// A stretch of a ray that holds a root, and the root.
struct RayRoot {
    double col, row;
    double from, to;
    bool several = false;  ///< it may hold several roots: the first is wanted that samples show

    bool found = false;  ///< out: f goes through 0
    double s = 0.0;      ///< out: to a thousandth of a pixel; the far end if f has one sign at both
    /// out: right before the root. Seen along the ray f goes the way that it goes at the root, even
    /// where it hardly does.
    glm::dvec3 gradient = glm::dvec3(0.0);
    double by_col = 0.0, by_row = 0.0;  ///< out: how s changes from ray to ray of the sheet
    double cosine = 0.0;                ///< out: of the angle between ray and normal
};

/// A root of each of a square's rays.
using SquareRoots = std::span<const RayRoot, square_ray_count>;

/// Fills in what is `out`; with `which` only for those roots.
void find_roots(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                Counters& counters);
void find_roots(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                std::span<const std::uint32_t> which, Counters& counters);

}  // namespace zeroset
