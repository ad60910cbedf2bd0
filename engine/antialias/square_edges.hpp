#pragma once

#include "engine/antialias/edge_lines.hpp"
#include "engine/antialias/edge_verdict.hpp"
#include "engine/antialias/sample_drafts.hpp"
#include "engine/antialias/square_creases.hpp"
#include "engine/antialias/square_field.hpp"
#include "engine/antialias/square_walls.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// Decides squares whose fronts are at an edge of a surface: by a line, a thread, a crease, a wall
/// of the clip region; else by dividing them.
class SquareEdges {
public:
    SquareEdges(const TraceFrame& frame, std::size_t surface, SquareField& field,
                SampleDrafts& drafts, Counters& counters)
        : frame_(frame),
          surface_(surface),
          field_(field),
          drafts_(drafts),
          counters_(counters),
          creases_(frame, field, drafts, counters),
          walls_(frame, surface, field, drafts, counters) {}

    /// A square that a root hides, in which normal . view changes much.
    void add_uneven(std::size_t square) { creases_.add(square, field_.fronts(square)[surface_]); }
    /// Decides these squares, all of one level, and those that were added; adds to `open` those
    /// whose search goes on.
    void decide(std::span<const std::size_t> squares, std::vector<std::size_t>& open);

private:
    /// The most rays at once, so few that what is known of them stays in the caches.
    static constexpr std::size_t most_rays = 128;
    static constexpr std::size_t most_squares = most_rays / square_ray_count;

    /// Sorts squares into those of lines_ and the others.
    void sort(std::span<const std::size_t> squares);
    /// Decides squares within the clip region where f is continuous and has no kinks.
    void decide_lines(std::span<const std::size_t> squares, bool all_rays,
                      std::vector<std::size_t>& open);
    void decide_squares(std::span<const std::size_t> squares, std::vector<std::size_t>& open);
    void decide_rays(std::span<const std::size_t> squares, std::vector<std::size_t>& open);
    /// Whether all rays of these squares are within the clip region where they are open.
    [[nodiscard]] bool are_inside(std::span<const std::size_t> squares) const;
    /// Sets the stretches that the fronts leave open of the rays through some places of squares,
    /// where they are within the clip region; `inside`: all are.
    void set_stretches(std::span<const std::size_t> squares, std::span<const SquareRay> places,
                       bool inside, std::span<RayStretch> stretches) const;
    /// Decides a square; whether its search goes on behind the edge.
    bool decide_one(std::size_t square, SquareStretches stretches, CornerStretches corners);
    /// Decides a square where f is continuous, at walls of the clip region; returns as decide_one.
    bool decide_at_walls(std::size_t square, SquareStretches stretches, CornerStretches corners);
    /// Decides a square whose edge is line i of lines_; returns as decide_one.
    bool decide_line(std::size_t square, std::size_t i);
    /// Shows a share of a square, and goes on beside it; returns as decide_one.
    bool show(std::size_t square, const EdgeCover& cover);
    /// Does with a square what its verdict says; returns as decide_one.
    bool act(std::size_t square, const EdgeSquare& edge, const EdgeVerdict& verdict);
    /// Whether f comes to 0 on all rays in the places where it is least, as f near to these tells.
    bool is_touched_nearby(SquareStretches stretches);
    bool decide_ray(std::size_t square, const RayStretch& stretch);
    /// Searches a stretch in which f may jump, or not be defined.
    bool decide_broken_ray(std::size_t square, const RayStretch& stretch);
    /// Nothing is seen of the surface at the edge.
    bool pass(std::size_t square) {
        field_.fronts(square)[surface_].pass();
        return true;
    }

    const TraceFrame& frame_;
    std::size_t surface_;
    SquareField& field_;
    SampleDrafts& drafts_;
    Counters& counters_;
    SquareCreases creases_;
    SquareWalls walls_;
    std::vector<std::size_t> even_, unclear_, others_;  ///< squares
    EdgeLines lines_;
    std::array<RayStretch, most_rays> stretches_;
    std::array<RayStretch, most_squares * square_corners.size()> corners_;
};

}  // namespace zeroset
