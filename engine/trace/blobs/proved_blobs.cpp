#include "engine/trace/blobs/proved_blobs.hpp"

#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/blob_tile.hpp"

namespace zeroset {

bool trace_tile_proved_blobs(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters) {
    const bool plain = !frame.whole_pixels && tile.places == nullptr && frame.union_members.empty();
    if (!plain) return false;
    const auto surface = blob_surface(frame);
    if (!surface) return false;
    thread_local BlobRoom room;
    return BlobTile(frame, tile, *surface, room, hits, counters).run();
}

}  // namespace zeroset
