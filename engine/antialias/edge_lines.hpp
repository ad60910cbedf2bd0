#pragma once

#include "engine/antialias/ray_stretches.hpp"
#include "engine/antialias/square_rays.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// When the edges in squares of some size count as lines.
struct LineRules {
    double error;   ///< how far heights may be off from it, in parts of its slope
    bool flat_too;  ///< where they are far from 0 all over the square, too
    /// Stretches without roots, in which f is least at an end, may hide some.
    bool may_hide;
};

/// Squares of one size within the clip region, and the lines that edges of a continuous f without
/// kinks are in them. In columns, plain data, nothing of it set at first.
struct EdgeLines {
    static constexpr std::size_t capacity = 64;
    static constexpr std::size_t capacity_of_all_rays = 24;  ///< with all_rays
    using Column = std::array<double, capacity>;

    double side;  ///< in pixels
    LineRules rules;
    /// Whether f is searched on all five rays; else on the middle one, and on the others it is told
    /// by what it is beside the place where it is least.
    bool all_rays;
    std::size_t count;
    alignas(64) Column col, row;  ///< of the middles, as TileRays counts pixels
    alignas(64) Column from, to;  ///< the depths between which f is looked at

    /// out: 1: the edge is a line, and the stretches are not told; 0: nothing else is
    alignas(64) Column is_line;
    /// out, of lines: the part that has roots, in halves of the side from the middle; of share 0:
    /// none
    alignas(64) Column share, x, y;
    alignas(64) Column end;   ///< out: behind `from`, before the root of the ray through x, y
    alignas(64) Column hits;  ///< out: of the square's rays with roots the sum of 2^ray
    /// out: 1: there may be several roots, and another sheet, before those that were found; else 0
    alignas(64) Column folds;
    /// out, with all_rays
    std::array<std::array<RayStretch, square_ray_count>, capacity_of_all_rays> stretches;
};

/// Fills in what is `out`. In upward rounding.
void find_lines(const TraceFrame& frame, const TileRays& rays, EdgeLines& squares,
                Counters& counters);

}  // namespace zeroset
