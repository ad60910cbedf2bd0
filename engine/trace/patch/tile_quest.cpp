#include "engine/trace/patch/tile_quest.hpp"

#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {

void TileAnswer::begin(const TileQuest& quest) {
    to_ = quest.to;
    // Reset only the blocks that were touched before, where both tiles are whole.
    const bool is_whole = to_.empty() && quest.cols == tile_size && quest.rows == tile_size;
    const bool was_whole = std::exchange(is_whole_, is_whole);
    if (is_whole && was_whole) {
        fill_blocks(reach_.data(), touched_, unbounded);
    } else if (!to_.empty()) {
        reach_ = to_;
    } else {
        reach_.assign(tile_pixels, -unbounded);
        for (int row = 0; row < quest.rows; ++row)
            std::fill_n(reach_.begin() + static_cast<std::ptrdiff_t>(pixel_index(0, row)),
                        quest.cols, unbounded);
    }
    found_.resize(tile_pixels);
    best_.resize(tile_pixels);
    fill_blocks(found_.data(), touched_, {.normal = {}, .state = RayState::Open});
    touched_ = 0;
}

void TileAnswer::set(std::size_t pixel, const PatchHit& hit) {
    touched_ |= std::uint64_t{1} << block_of(pixel);
    best_[pixel] = hit;
    found_[pixel].state = RayState::Kept;
    reach_[pixel] = std::min(hit.s, limit(pixel));
}

void TileAnswer::close(std::size_t pixel) {
    to_[pixel] = -unbounded;
    reach_[pixel] = -unbounded;
}

LeafRays TileAnswer::rays(const TileQuest& quest, double tolerance, const PixelGrid& grid) {
    const bool any = quest.wish == TileQuest::Wish::AnyHits;
    return {.u = quest.u.data(),
            .v = quest.v.data(),
            .reach = reach_.data(),
            .found = found_.data(),
            .to = any ? to_.data() : nullptr,
            .row_size = tile_size,
            .tolerance = tolerance,
            .grid = any ? nullptr : &grid};
}

}  // namespace zeroset
