#include "engine/trace/blobs/slab_balls.hpp"

#include <cmath>

namespace zeroset {

bool SlabBalls::list(const BlobSurface& surface, double tail, const TileRays& rays,
                     BlockBeam beam) {
    const auto slab = near.balls();
    beam.distance = rays.distance();
    const double sizes = 0x1p46 * rays.depth_error() * (1 + std::abs(beam.u) + std::abs(beam.v));
    beam.spare = 0x1p-20 * sizes;
    list_near(columns, slab.size(), beam, listed);
    balls.clear();
    double most = 0;
    for (const std::uint32_t at : listed) {
        balls.push_back(slab[at]);
        if ((slab[at].strength > 0) == (surface.level > 0)) most += std::abs(slab[at].strength);
    }
    const double top = blob_facts(surface.blobs->kind()).top;
    return (1 + 0x1p-40) * top * most + tail >= std::abs(surface.level);
}

}  // namespace zeroset
