#include "engine/trace/blobs/blob_cover.hpp"

#include "engine/real/scalar.hpp"
#include "engine/trace/blobs/ball_bins.hpp"

#include <cstddef>
#include <limits>

namespace zeroset {

void mark_blob_cover(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface,
                     PixelCover& cover) {
    constexpr double none = std::numeric_limits<double>::infinity();
    BallBins& bins = thread_ball_bins();
    bins.begin(frame, tile, surface);
    cover.clear();
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const double first = bins.first_depth(col, row);
            if (first == none) continue;
            const auto at = static_cast<std::size_t>(row * tile_size + col);
            cover.marked = true;
            cover.other_from[at] = -float_above(-first);
            cover.last[at] = std::numeric_limits<float>::infinity();
        }
    }
}

}  // namespace zeroset
