#pragma once

#include "engine/trace/patch/patch_found.hpp"
#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/patch/patch_search.hpp"
#include "engine/trace/tile.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// The question to PatchTile about the rays of a tile, and its answer.
// Numbers of each ray are in rows of tile_size.

namespace zeroset {

/// The rays of a tile, and what is wanted on them.
struct TileQuest {
    enum class Wish : std::uint8_t {
        FirstHits,  ///< of rays through the pixels' centres
        AnyHits,    ///< of rays anywhere in the image plane
    };
    Wish wish = Wish::FirstHits;
    int cols = tile_size, rows = tile_size;
    /// Where rays are, as TileRays has it: of FirstHits each column's u and each row's v.
    std::vector<double> u, v;
    /// The depth behind which nothing is wanted on a ray, -inf where it is not wanted itself.
    /// Empty: all is wanted, of FirstHits on all pixels of the tile.
    std::vector<double> to;
};

/// The hits on the rays of a tile. A thread's keeps its memory from tile to tile.
class TileAnswer {
public:
    /// Forgets all hits: those of `quest` are wanted.
    void begin(const TileQuest& quest);

    [[nodiscard]] PatchHit hit(std::size_t pixel) const {
        const LeafFound& leaf = found_[pixel];
        if (leaf.state == RayState::Open) return {};
        if (leaf.state == RayState::Kept) return best_[pixel];
        return {.s = reach_[pixel],
                .is_proved = leaf.state == RayState::Proved,
                .normal = {leaf.normal[0], leaf.normal[1], leaf.normal[2]}};
    }
    /// Hits as leaves write them down, whose depths are the reaches.
    [[nodiscard]] const LeafFound* found() const { return found_.data(); }
    /// The depth of the first hit so far, or where nothing is wanted any more: what is nearer
    /// counts.
    [[nodiscard]] double reach(std::size_t pixel) const { return reach_[pixel]; }
    [[nodiscard]] const double* reaches() const { return reach_.data(); }
    /// The depth behind which nothing was wanted from the beginning.
    [[nodiscard]] double limit(std::size_t pixel) const {
        return to_.empty() ? std::numeric_limits<double>::infinity() : to_[pixel];
    }
    /// The blocks in which something was found, a bit for each.
    [[nodiscard]] std::uint64_t touched() const { return touched_; }

    void set(std::size_t pixel, const PatchHit& hit);
    /// Wants nothing more on a ray.
    void close(std::size_t pixel);
    void touch(std::uint64_t blocks) { touched_ |= blocks; }
    /// The rays as leaves see them, which write hits down themselves, but touch no blocks.
    LeafRays rays(const TileQuest& quest, double tolerance, const PixelGrid& grid);

private:
    std::vector<double> to_;
    std::vector<double> reach_;
    std::vector<LeafFound> found_;  ///< whose depths are in `reach_`
    std::vector<PatchHit> best_;    ///< of RayState::Kept
    std::uint64_t touched_ = ~std::uint64_t{0};
    /// Whether all was wanted on a whole tile: outside of `touched_` reaches still are +inf.
    bool is_whole_ = false;
};

}  // namespace zeroset
