#pragma once

#include "engine/trace/field_gradients.hpp"
#include "engine/trace/ray_lines.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/voxels/ray_cubic.hpp"
#include "engine/volume/geometry.hpp"

#include <glm/ext/vector_double3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Hands on what is found of a volume's isosurface on the rays of a tile.
class VoxelHits {
public:
    /// All outlive it.
    VoxelHits(const TraceFrame& frame, const TileRays& rays, const RayLines& lines,
              const IndexMap& map, TileHits& hits, Counters& counters)
        : rays_(rays), lines_(lines), map_(map), hits_(hits), gradients_(frame, hits, counters) {}

    /// A ray's root, certified if it is proved and inside the region. `slopes`: of the volume
    /// there, along the axes of its grid.
    void tell(std::uint32_t pixel, const FirstRoot& root, const std::array<double, 3>& slopes);
    /// A root that is certified, with f's gradient there.
    void tell_certified(std::uint32_t pixel, double distance,
                        const std::array<float, 3>& gradient) {
        hits_.any = true;
        hits_.depth[pixel] = static_cast<float>(distance);
        hits_.certificate[pixel] = Certificate::Certified;
        for (std::size_t c = 0; c < 3; ++c)
            hits_.gradient[c][pixel] = gradient[c];
    }
    /// The sign of f's gradient against that of the volume; 0: not known yet.
    [[nodiscard]] int sign() const { return gradients_.sign(); }
    /// Leaves a rectangle of pixels undecided from the eye on.
    void leave(int col, int row, int cols, int rows);

private:
    void tell_gradient(std::uint32_t pixel, const std::array<double, 3>& slopes);

    const TileRays& rays_;
    const RayLines& lines_;
    const IndexMap& map_;
    TileHits& hits_;
    FieldGradients gradients_;
};

}  // namespace zeroset
