#pragma once

#include "engine/trace/surface_way.hpp"

namespace zeroset {

/// Plain surfaces of soft balls: roots on rays by the balls that are near. Tiles that ask for what
/// only beams know, and surfaces whose level is known badly, are left to the beams.
class BlobWay final : public SurfaceWay {
public:
    [[nodiscard]] bool is_of(const Kernel& surface) const override;
    bool trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                    Counters& counters) const override;
    [[nodiscard]] std::optional<Kernel> kernel_for(const TraceFrame& frame,
                                                   const Tile& tile) const override;
    [[nodiscard]] bool follows(const TraceFrame& frame) const override;
    bool follow(const TraceFrame& frame, const TileRays& rays, double bracket,
                std::span<FollowedRays> blocks, Counters& counters) const override;
};

}  // namespace zeroset
