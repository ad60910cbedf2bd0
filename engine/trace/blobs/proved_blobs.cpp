#include "engine/trace/blobs/proved_blobs.hpp"

#include "engine/trace/blobs/blob_cover.hpp"
#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/blob_tile.hpp"

#include <memory>

namespace zeroset {

bool trace_tile_proved_blobs(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters) {
    const bool plain = tile.places == nullptr && frame.union_members.empty();
    if (!plain) return false;
    const auto surface = blob_surface(frame);
    if (!surface) return false;
    thread_local const auto kept = std::make_unique<BlobRoom>();
    BlobRoom& room = *kept;
    if (!BlobTile(frame, tile, *surface, room, hits, counters).run()) return false;
    if (frame.whole_pixels) mark_blob_cover(frame, tile, *surface, hits);
    return true;
}

}  // namespace zeroset
