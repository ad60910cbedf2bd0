#pragma once

#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/patch/patch_outline.hpp"
#include "engine/trace/patch/patch_search.hpp"
#include "engine/trace/patch/patch_sight.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/patch/seen_parts.hpp"
#include "engine/trace/patch/tile_quest.hpp"
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
class PatchTile {
public:
    /// `rays`: of the tile. `answer` is begun here.
    PatchTile(const TraceFrame& frame, const TileRays& rays, const TileQuest& quest,
              TileAnswer& answer, Counters& counters);
    /// Searches all rays.
    void run();
    /// The most items that were kept for the end at one time.
    [[nodiscard]] std::size_t most_kept() const { return most_kept_; }

private:
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
    /// Where on a ray parts beside jumps are: small ones at `s`, others from `unsettled` on.
    struct Jump {
        double s = std::numeric_limits<double>::infinity();
        double s_radius = 0.0;
        double unsettled = std::numeric_limits<double>::infinity();
    };
    /// Memory that a thread keeps from tile to tile.
    struct Scratch {
        LeafLists lists;
        std::vector<TileRect> rects;
        std::vector<Leaf> leaves;
        std::vector<Candidate> candidates;
        std::vector<Rest> rest;
        std::vector<Jump> jumps;  ///< one for each pixel, or none
        std::vector<glm::dvec2> places;
        std::vector<PatchPoint> points;
    };
    static Scratch& kept_scratch();
    class PartTaker;
    using Wish = TileQuest::Wish;
    using Rect = TileRect;
    /// A part of the patch that rays of the tile may meet.
    struct SeenNode {
        PatchNode* node;
        SightDepths depths;
        PatchSight sight;
    };
    using SeenNodes = std::array<SeenNode, PatchForms::at_once>;
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
    bool see(PatchNode& node, SeenNode& part) const;
    void visit(SeenNode& part);
    void visit_parts(PatchNode::Children& children);
    [[nodiscard]] bool is_hidden(const SightDepths& depths) const;
    /// Whether all pixels of a rectangle have hits before a depth.
    [[nodiscard]] bool is_covered(const Rect& rect, double near);
    /// The pixels of an outline; all where there is none.
    [[nodiscard]] Rect pixels_of(const PatchOutline* outline) const;
    enum class Refinement : std::uint8_t { None, Quarters, Parts };
    /// How a part is to be divided whose pixels are in a rectangle.
    [[nodiscard]] Refinement refinement_of(const SeenNode& part, const Rect& rect) const;
    /// The parts of a node that is so divided; nullptr: there are none.
    PatchNode::Children* divided(PatchNode& node, Refinement refinement);
    /// Whether a node's model is so good that its hits are as narrow as they should be.
    [[nodiscard]] bool is_fine(const PatchNode& node, const PatchSight& sight) const;
    /// The rays of a rectangle's pixels; of AnyHits all rays.
    [[nodiscard]] SightRays rays_of(const Rect& rect) const;
    /// Calls a function for those pixels of a rectangle whose rays may meet a leaf.
    template <class Scan>
    void for_each_rect(const PatchSight& sight, const Rect& rect, Scan scan) const;
    /// Finds the hits on a part that is known by its model.
    void trace_model(const SeenNode& part, const LeafPixels& pixels);
    /// Finds the hits of pixels for which a node's model is too coarse, on the parts of the node.
    void trace_parts(PatchNode& node, std::span<const std::size_t> pixels);
    /// The state that a hit of a leaf gives to its ray (LeafTaker::judge).
    [[nodiscard]] RayState judge(const LeafHit& hit) const;
    /// Whether a hit is in the box that the patch itself is cut to.
    [[nodiscard]] InSquare side_of_own_box(const LeafHit& hit) const;
    /// The parts that rays of the tile may meet, with their order from front to back.
    std::size_t order_parts(PatchNode::Children& children, SeenNodes& parts, Order& order) const;
    /// Which hits of a part count.
    [[nodiscard]] LeafWindow window_of(const PatchForm& form, const SightDepths& depths) const;
    void scan(const SeenNode& part, const Rect& rect);
    /// Notes a part beside a jump on the rays that may meet it, and puts what is noted where
    /// nothing nearer was found: what is smaller than a pixel is drawn, undecided, the rest
    /// unsettled.
    void leave_jump(const SeenNode& part, const Rect& rect);
    void put_jumps();
    void scan_rect(std::size_t leaf, const Rect& rect, double near);
    void scan_pixel(std::size_t pixel, std::size_t leaf, double near);
    /// Evaluates at all candidates until each is known.
    void solve();
    void advance(bool is_last);
    bool settle(const Candidate& candidate, const ZeroTest& test, const PatchPoint& point,
                bool is_last);
    /// Finds behind which depth nothing is wanted any more.
    void find_limit();
    /// Keeps a ray's search of a part for the end.
    void keep(const Rest& rest) { scratch_.rest.push_back(rest); }
    /// Searches what is kept for the end now, so that it does not grow too long.
    void empty_rest();
    void search_rest();
    /// The width of a pixel at a depth.
    [[nodiscard]] double pixel_at(double s) const {
        return rays_.pixel() * std::max(axes_.distance + s, 0.0);
    }
    [[nodiscard]] SightRay ray_of(std::size_t pixel) const {
        if (quest_.wish == Wish::AnyHits) return {.u = quest_.u[pixel], .v = quest_.v[pixel]};
        return {.u = quest_.u[pixel % tile_size], .v = quest_.v[pixel / tile_size]};
    }

    const TraceFrame& frame_;
    const TileRays& rays_;
    const TileQuest& quest_;
    TileAnswer& answer_;
    Counters& counters_;
    Scratch& scratch_;
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
    std::size_t new_hits_ = 0;  ///< since limit_ was found
    std::size_t most_kept_ = 0;
    SightDepths depths_{};  ///< of all rays, within the clip box and the region
    double limit_ = -std::numeric_limits<double>::infinity();  ///< behind it nothing is wanted
    PatchSearch search_;
};

template <class Scan>
void PatchTile::for_each_rect(const PatchSight& sight, const Rect& rect, Scan scan) const {
    if (quest_.wish == Wish::FirstHits) return scan(rect);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (is_beside(sight, axes_, blocks_[i])) continue;
        const int col = static_cast<int>(i) % (tile_size / block) * block;
        const int row = static_cast<int>(i) / (tile_size / block) * block;
        scan(Rect{.col = col,
                  .row = row,
                  .end_col = std::min(col + block, quest_.cols),
                  .end_row = std::min(row + block, quest_.rows)});
    }
}

}  // namespace zeroset
