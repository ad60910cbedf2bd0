#pragma once

#include "engine/blobs/blobs.hpp"
#include "engine/trace/trace_frame.hpp"

#include <optional>

namespace zeroset {

/// A surface blobs(x, y, z) = level, which is known to an error.
struct BlobSurface {
    const Blobs* blobs;
    double level, level_error;

    /// How far f may be from the sum of the balls that reach a place less the level.
    [[nodiscard]] double tail() const {
        return blob_facts(blobs->kind()).tail * blobs->set().total().size() + level_error;
    }
};

/// The balls whose sum the surface is a level of; nullptr: it is none of such.
const Blobs* blobs_of(const Kernel& surface);

/// The frame's surface, for its uniforms, in upward rounding; nothing where it is none, where no
/// side of the level is known away from all balls, where the level is known badly, or where its
/// numbers are beyond those of floats.
std::optional<BlobSurface> blob_surface(const TraceFrame& frame);

}  // namespace zeroset
