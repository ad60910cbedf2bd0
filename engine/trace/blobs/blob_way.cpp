#include "engine/trace/blobs/blob_way.hpp"

#include "engine/trace/blobs/blob_kernel.hpp"
#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/blob_tile.hpp"

#include <memory>

namespace zeroset {

bool BlobWay::is_of(const Kernel& surface) const { return blobs_of(surface) != nullptr; }

bool BlobWay::trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                         Counters& counters) const {
    const bool plain = tile.places == nullptr && frame.union_members.empty();
    if (!plain) return false;
    const auto surface = blob_surface(frame);
    if (!surface) return false;
    thread_local const auto kept = std::make_unique<BlobScratch>();
    BlobScratch& scratch = *kept;
    if (!BlobTile(frame, tile, *surface, scratch, hits, counters).run()) return false;
    if (frame.whole_pixels) mark_blob_cover(frame, tile, *surface, hits);
    return true;
}

std::optional<Kernel> BlobWay::kernel_for(const TraceFrame& frame, const Tile& tile) const {
    return blob_kernel(frame, tile);
}

bool BlobWay::follows(const TraceFrame& frame) const { return blob_surface(frame).has_value(); }

bool BlobWay::follow(const TraceFrame& frame, const TileRays& rays, double bracket,
                     std::span<FollowedRays> blocks, Counters& counters) const {
    return follow_blobs(frame, rays, bracket, blocks, counters);
}

}  // namespace zeroset
