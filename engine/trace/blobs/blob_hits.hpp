#pragma once

#include "engine/trace/field_gradients.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <cstdint>

namespace zeroset {

/// Hands on what is found of blobs on the rays of a tile.
class BlobHits {
public:
    /// All outlive it.
    BlobHits(const TraceFrame& frame, const TileRays& rays, TileHits& hits, Counters& counters)
        : rays_(rays), hits_(hits), gradients_(frame, hits, counters) {}

    /// A root at a depth. `slope`: of the blobs there, along the axes of the view.
    void tell(std::uint32_t pixel, double depth, bool proved, const std::array<double, 3>& slope);
    /// Leaves a pixel undecided from the eye on.
    void leave(std::uint32_t pixel);

private:
    [[nodiscard]] std::array<double, 3> place(std::uint32_t pixel, double depth) const;

    const TileRays& rays_;
    TileHits& hits_;
    FieldGradients gradients_;
};

}  // namespace zeroset
