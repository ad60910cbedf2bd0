#pragma once

#include "engine/trace/followed_rays.hpp"
#include "engine/trace/surface_way.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

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

/// Follows blocks of rays through a plain surface of soft balls. `rays`: those of the frame's view,
/// which is parallel. `bracket`: how near to a root rays may end. False, and nothing done: it is
/// no such surface, or places are not known well enough to prove anything. In upward rounding.
bool follow_blobs(const TraceFrame& frame, const TileRays& rays, double bracket,
                  std::span<FollowedRays> blocks, Counters& counters);

}  // namespace zeroset
