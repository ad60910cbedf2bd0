#pragma once

#include "engine/trace/patch/patch_search.hpp"
#include "engine/trace/patch/patch_sight.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// Private to patch_tracer.cpp: the search of a tile.

namespace zeroset {

/// The axes of the rays of tiles.
SightAxes axes_of(const TileRays& rays);

/// Some rays in the image plane; none where lo > hi.
struct RayBounds {
    double u_lo, u_hi, v_lo, v_hi;
};

/// Whether a part of the patch is on one side of a plane through the eye that bounds rays.
bool is_beside(const PatchSight& sight, const SightAxes& axes, const RayBounds& bounds);

/// A tile whose patch is searched: parts of the patch that are flat enough, from front to back, and
/// in each the pixels that it may cover; what that leaves open, ray by ray.
class PatchTile {
public:
    /// A part of the patch as this tile sees it.
    struct Leaf {
        PatchNode* node;
        PatchSight sight;
        Contraction contraction;  ///< for all pixels that are asked about
    };
    /// A pixel whose ray may meet a leaf near a place of it.
    struct Candidate {
        std::size_t pixel, leaf;
        BoxPlace place;
    };
    /// A pixel whose ray may meet a part of the patch in whatever way, no nearer than `near`.
    struct Rest {
        std::size_t pixel;
        PatchNode* node;
        double near;
    };
    /// What a thread keeps from tile to tile. Of each ray, in rows of tile_size: where it is, as
    /// TileRays has it; the depth behind which nothing is wanted on it, -inf where it is not wanted
    /// itself; and what was found.
    struct Room {
        std::vector<double> u, v, to;
        std::vector<double> reach;  ///< of the first hit so far, or `to`: what is nearer counts
        std::vector<std::uint8_t> is_set;  ///< else there is no hit, and `best` is of before
        std::vector<PatchHit> best;

        [[nodiscard]] const PatchHit& hit(std::size_t pixel) const {
            static const PatchHit none;
            return is_set[pixel] != 0 ? best[pixel] : none;
        }
        void set(std::size_t pixel, const PatchHit& hit) {
            best[pixel] = hit;
            is_set[pixel] = 1;
            reach[pixel] = std::min(hit.s, to[pixel]);
        }
        std::vector<Leaf> leaves;
        std::vector<Candidate> candidates;
        std::vector<Rest> rest;
        std::vector<glm::dvec2> places;
        std::vector<PatchPoint> points;
    };

    /// How the rays of a tile lie, and what is wanted on them.
    enum class Wish : std::uint8_t {
        FirstHits,  ///< of rays through the pixels' centres
        AnyHits,    ///< of rays anywhere in the image plane
    };

    /// `room`: with its rays; `rays`: of a tile of so many pixels.
    PatchTile(const TraceFrame& frame, const TileRays& rays, int cols, int rows, Wish wish,
              Counters& counters, Room& room);
    /// Fills room.best.
    void run();

private:
    /// A rectangle of pixels of the tile: up to, but not including, the last ones.
    struct Rect {
        int col, row, end_col, end_row;

        [[nodiscard]] bool empty() const { return col >= end_col || row >= end_row; }
    };
    /// What of a part of the patch is at which depths.
    struct Depths {
        double near, far;
    };

    void find_bounds();
    void visit(PatchNode& node);
    void visit_parts(PatchNode::Children& parts);
    [[nodiscard]] Depths depths_of(const PatchForm& form) const;
    [[nodiscard]] bool is_hidden(const Depths& depths) const;
    [[nodiscard]] Rect pixels_of(const PatchSight& sight, const Depths& depths) const;
    [[nodiscard]] bool is_leaf(const PatchNode& node, const PatchSight& sight,
                               const Rect& rect) const;
    /// The rays of a rectangle's pixels; of AnyHits all rays.
    [[nodiscard]] SightRays rays_of(const Rect& rect) const;
    void scan(PatchNode& node, const PatchSight& sight, const Rect& rect, double near);
    void scan_rect(std::size_t leaf, const Rect& rect, double near);
    void scan_blocks(std::size_t leaf, double near);
    void scan_pixel(std::size_t pixel, std::size_t leaf, double near);
    /// Evaluates at all candidates until each is known.
    void solve();
    void advance(bool is_last);
    bool settle(const Candidate& candidate, const ZeroTest& test, const PatchPoint& point,
                bool is_last);
    void search_rest();
    /// The width of a pixel at a depth.
    [[nodiscard]] double pixel_at(double s) const {
        return rays_.pixel() * std::max(axes_.distance + s, 0.0);
    }
    [[nodiscard]] SightRay ray_of(std::size_t pixel) const {
        return {.u = room_.u[pixel], .v = room_.v[pixel]};
    }

    const TraceFrame& frame_;
    const TileRays& rays_;
    int cols_, rows_;
    Wish wish_;
    Counters& counters_;
    Room& room_;
    SightAxes axes_;
    const PatchTree& tree_;
    Box clip_;            ///< what of the scene's clip box is in the patch's own
    RayBounds bounds_{};  ///< of all rays that are wanted
    static constexpr int block = 8;
    std::array<RayBounds, std::size_t{tile_size / block} * (tile_size / block)> blocks_{};
    Depths depths_{};  ///< of all rays, within the clip box and the region
    double limit_ = -std::numeric_limits<double>::infinity();  ///< behind it nothing is wanted
    PatchSearch search_;
};

}  // namespace zeroset
