#include "engine/trace/blobs/blob_surface.hpp"

#include "engine/kernel/surface_facts.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// Limits of sizes whose squares, and their reciprocals, are far within float's range.
constexpr double least = 1e-12, most = 1e12;

/// The largest relative error of a level; beyond it beams tell more than rays at one level would.
constexpr double most_unknown = 0x1p-30;

/// Whether places and balls are neither so small nor so large that floats overflow.
bool fits(const TraceFrame& frame, const BlobSet& set) {
    const double reach = 0x1p46 * place_error(frame);
    return reach < most && reach > least && set.least_radius() > least &&
           set.total().size() < most && set.total().per_radius < most;
}

}  // namespace

const Blobs* blobs_of(const Kernel& surface) {
    const auto* const field =
        dynamic_cast<const BlobsField*>(surface_facts(surface).field.field.get());
    return field == nullptr ? nullptr : &field->function();
}

std::optional<BlobSurface> blob_surface(const TraceFrame& frame) {
    const Blobs* const found = blobs_of(frame.kernel);
    if (found == nullptr) return std::nullopt;
    const Blobs& blobs = *found;
    const FieldLevel::Value level = surface_facts(frame.kernel).field.at(frame.scene.uniforms);
    const double size = std::abs(level.middle);
    // Where no ball is, f is known to less than this.
    const double unsure = 0x1p-40 * (1 + blobs.set().total().size());
    if (!(level.error <= most_unknown * size) || size <= unsure || size > most ||
        !fits(frame, blobs.set()))
        return std::nullopt;
    return BlobSurface{.blobs = &blobs, .level = level.middle, .level_error = level.error};
}

}  // namespace zeroset
