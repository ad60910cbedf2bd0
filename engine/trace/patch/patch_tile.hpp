#pragma once

#include "engine/trace/patch/patch_found.hpp"
#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/patch/patch_look.hpp"
#include "engine/trace/patch/patch_outline.hpp"
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

/// Whether a part of the patch is on one side of a plane through the eye that bounds rays.
bool is_beside(const PatchSight& sight, const SightAxes& axes, const RayBounds& bounds);

/// No part is divided further for many rays at once.
inline constexpr int most_levels = 14;

/// A tile whose patch is searched: parts of the patch that are flat enough, from front to back, and
/// in each the pixels that it may cover; what that leaves open, ray by ray.
class PatchTile final : private LeafTaker {
public:
    /// A part of the patch without a model as this tile sees it.
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
    /// Memory that a thread keeps from tile to tile. Numbers of each ray are in rows of tile_size.
    struct Room {
        /// Where rays are, as TileRays has it: of FirstHits each column's u and each row's v.
        std::vector<double> u, v;
        /// The depth behind which nothing is wanted on a ray, -inf where it is not wanted itself.
        /// Empty: all is wanted, of FirstHits on all pixels of the tile.
        std::vector<double> to;
        std::vector<double> reach;     ///< of the first hit so far, or `to`: what is nearer counts
        std::vector<LeafFound> found;  ///< whose depths are in `reach`
        /// A bit for each block of pixels for which something was found since these were cleared.
        std::uint64_t touched = ~std::uint64_t{0};
        std::vector<PatchHit> best;  ///< of RayState::Kept

        /// Whether `reach` was last set for a whole tile without limits: outside of `touched` it
        /// still is +inf.
        bool is_whole = false;

        /// Forgets what was found, but for the reaches.
        void clear() {
            found.resize(std::size_t{tile_size} * tile_size);
            best.resize(found.size());
            fill_blocks(found.data(), touched, {.normal = {}, .state = RayState::Open});
            touched = 0;
        }
        [[nodiscard]] double limit(std::size_t pixel) const {
            return to.empty() ? std::numeric_limits<double>::infinity() : to[pixel];
        }
        [[nodiscard]] PatchHit hit(std::size_t pixel) const {
            const LeafFound& leaf = found[pixel];
            if (leaf.state == RayState::Open) return {};
            if (leaf.state == RayState::Kept) return best[pixel];
            return {.s = reach[pixel],
                    .is_proved = leaf.state == RayState::Proved,
                    .normal = {leaf.normal[0], leaf.normal[1], leaf.normal[2]}};
        }
        void set(std::size_t pixel, const PatchHit& hit) {
            touched |= std::uint64_t{1} << block_of(pixel);
            best[pixel] = hit;
            found[pixel].state = RayState::Kept;
            reach[pixel] = std::min(hit.s, limit(pixel));
        }
        LeafLists lists;
        std::vector<TileRect> rects;
        std::vector<std::size_t> left;  ///< pixels for which a leaf's model is too coarse
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

    /// `room`: with its rays and reaches; `rays`: of a tile of so many pixels.
    PatchTile(const TraceFrame& frame, const TileRays& rays, int cols, int rows, Wish wish,
              Counters& counters, Room& room);
    /// Searches all rays; Room::hit tells what was found.
    void run();

private:
    using Rect = TileRect;
    /// A part of the patch that rays of the tile may meet.
    struct Part {
        PatchNode* node;
        SightDepths depths;
        PatchSight sight;
    };
    using Parts = std::array<Part, PatchForms::at_once>;
    using Order = std::array<std::pair<double, std::size_t>, PatchForms::at_once>;

    void find_bounds();
    /// Sets block_reach_ where all is wanted.
    void open_blocks();
    /// Updates block_reach_ in the blocks with new hits.
    void find_reaches();
    /// Marks the blocks of a rectangle, or all blocks, as having new hits.
    void change(const Rect& rect);
    void change_all();
    /// Sets a part; false where no ray meets it.
    bool look_at(PatchNode& node, Part& part) const;
    void visit(Part& part);
    void visit_parts(PatchNode::Children& children);
    [[nodiscard]] bool is_hidden(const SightDepths& depths) const;
    /// Whether all pixels of a rectangle have hits before a depth.
    [[nodiscard]] bool is_covered(const Rect& rect, double near);
    /// The pixels of an outline; all where there is none.
    [[nodiscard]] Rect pixels_of(const PatchOutline* outline) const;
    enum class Division : std::uint8_t { None, Quarters, Parts };
    /// How a part is to be divided whose pixels are in a rectangle.
    [[nodiscard]] Division division_of(const Part& part, const Rect& rect) const;
    /// The parts of a node in such a division; nullptr: there are none.
    PatchNode::Children* divided(PatchNode& node, Division division);
    /// Whether a node's model is so good that its hits are as narrow as they should be.
    [[nodiscard]] bool is_fine(const PatchNode& node, const PatchSight& sight) const;
    /// The rays of a rectangle's pixels; of AnyHits all rays.
    [[nodiscard]] SightRays rays_of(const Rect& rect) const;
    /// Calls a function for those pixels of a rectangle whose rays may meet a leaf.
    template <class Scan>
    void for_each_rect(const PatchSight& sight, const Rect& rect, Scan scan) const;
    /// Finds the hits on a part that is known by its model.
    void trace_model(const Part& part, const LeafPixels& pixels);
    /// Finds the hits of pixels for which a node's model is too coarse, on the parts of the node.
    void trace_parts(PatchNode& node, std::span<const std::size_t> pixels);
    RayState judge(const LeafHit& hit) override;
    void leave(std::size_t pixel, double near, LeafLeft why) override;
    /// Whether a hit is in the box that the patch itself is cut to.
    [[nodiscard]] InSquare side_of_own_box(const LeafHit& hit) const;
    /// The parts that rays of the tile may meet, with their order from front to back.
    std::size_t order_parts(PatchNode::Children& children, Parts& parts, Order& order) const;
    /// Which hits of a part count.
    [[nodiscard]] LeafWindow window_of(const PatchForm& form, const SightDepths& depths) const;
    void scan(const Part& part, const Rect& rect);
    void scan_rect(std::size_t leaf, const Rect& rect, double near);
    void scan_pixel(std::size_t pixel, std::size_t leaf, double near);
    /// Evaluates at all candidates until each is known.
    void solve();
    void advance(bool is_last);
    bool settle(const Candidate& candidate, const ZeroTest& test, const PatchPoint& point,
                bool is_last);
    /// Finds behind which depth nothing is wanted any more.
    void find_limit();
    /// Searches what is kept for the end now, to have room.
    void empty_rest();
    void search_rest();
    /// The width of a pixel at a depth.
    [[nodiscard]] double pixel_at(double s) const {
        return rays_.pixel() * std::max(axes_.distance + s, 0.0);
    }
    [[nodiscard]] SightRay ray_of(std::size_t pixel) const {
        if (wish_ == Wish::AnyHits) return {.u = room_.u[pixel], .v = room_.v[pixel]};
        return {.u = room_.u[pixel % tile_size], .v = room_.v[pixel / tile_size]};
    }

    const TraceFrame& frame_;
    const TileRays& rays_;
    int cols_, rows_;
    Wish wish_;
    Counters& counters_;
    Room& room_;
    SightAxes axes_;
    PixelGrid grid_;  ///< of FirstHits
    const PatchTree& tree_;
    Box clip_;            ///< the part of the scene's clip box that is in the patch's own
    RayBounds bounds_{};  ///< of all rays that are wanted
    static constexpr int block = tile_block;
    static constexpr std::size_t block_count = tile_blocks;
    std::array<RayBounds, block_count> blocks_{};
    /// The largest reach of each block's pixels, but for those with new hits: a bit for each block.
    std::array<double, block_count> block_reach_{};
    std::uint64_t changed_blocks_ = ~std::uint64_t{0};
    std::size_t new_hits_ = 0;   ///< since limit_ was found
    PatchNode* leaf_ = nullptr;  ///< the one with a model that is looked at
    SightDepths depths_{};       ///< of all rays, within the clip box and the region
    double limit_ = -std::numeric_limits<double>::infinity();  ///< behind it nothing is wanted
    PatchSearch search_;
};

template <class Scan>
void PatchTile::for_each_rect(const PatchSight& sight, const Rect& rect, Scan scan) const {
    if (wish_ == Wish::FirstHits) return scan(rect);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (is_beside(sight, axes_, blocks_[i])) continue;
        const int col = static_cast<int>(i) % (tile_size / block) * block;
        const int row = static_cast<int>(i) / (tile_size / block) * block;
        scan(Rect{.col = col,
                  .row = row,
                  .end_col = std::min(col + block, cols_),
                  .end_row = std::min(row + block, rows_)});
    }
}

}  // namespace zeroset
