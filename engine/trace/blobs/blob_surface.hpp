#pragma once

#include "engine/blobs/blobs.hpp"
#include "engine/trace/trace_frame.hpp"

#include <optional>

namespace zeroset {

/// A surface blobs(x, y, z) = level.
struct BlobSurface {
    const Blobs* blobs;
    double level;
};

/// The frame's surface, for its uniforms, in upward rounding; nothing where it is none, where no
/// side of the level is known away from all balls, or where its numbers are beyond those of floats.
std::optional<BlobSurface> blob_surface(const TraceFrame& frame);

}  // namespace zeroset
