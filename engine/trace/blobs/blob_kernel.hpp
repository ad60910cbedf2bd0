#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <optional>

namespace zeroset {

/// Code for the cells and points of a tile's whole pixels, if the frame's surface is one of soft
/// balls: forms, and values in double, by the balls near them. The same function as the frame's
/// kernel. Good for this thread, until it asks for another one; `frame` and `tile` outlive it.
std::optional<Kernel> blob_kernel(const TraceFrame& frame, const Tile& tile);

/// Tells of a tile's pixels, whose own rays have these hits, which are free of the surface, which
/// one sheet covers, and before which depths there is nothing in the others.
void mark_blob_cover(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface,
                     TileHits& hits);

}  // namespace zeroset
