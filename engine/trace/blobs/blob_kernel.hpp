#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <optional>

namespace zeroset {

/// Code for the cells and points of a tile's whole pixels, if the frame's surface is one of soft
/// balls: forms, and values in double, by the balls near them. The same function as the frame's
/// kernel. Good for this thread, until it asks for another one; `frame` and `tile` outlive it.
std::optional<Kernel> blob_kernel(const TraceFrame& frame, const Tile& tile);

}  // namespace zeroset
