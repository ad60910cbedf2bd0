#pragma once

#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/tile_hits.hpp"

namespace zeroset {

/// Tells which of a tile's pixels balls may reach, and before which depths none does.
void mark_blob_cover(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface,
                     PixelCover& cover);

}  // namespace zeroset
