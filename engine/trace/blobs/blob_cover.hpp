#pragma once

#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/tile_hits.hpp"

namespace zeroset {

/// Tells of a tile's pixels, whose own rays have these hits, which are free of the surface, which
/// one sheet covers, and before which depths there is nothing in the others.
void mark_blob_cover(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface,
                     TileHits& hits);

}  // namespace zeroset
