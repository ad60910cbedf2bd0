#include "engine/trace/voxels/voxel_way.hpp"

#include "engine/trace/voxels/grid_bounds.hpp"
#include "engine/trace/voxels/isosurface.hpp"
#include "engine/trace/voxels/voxel_tile.hpp"
#include "engine/volume/spline.hpp"

#include <cstddef>
#include <type_traits>

namespace zeroset {
namespace {

/// Samples that float holds.
template <class Sample>
constexpr bool fits_float =
    std::is_same_v<Sample, float> || (std::is_integral_v<Sample> && sizeof(Sample) <= 2);

/// A tile, and what is found in it.
struct TileWork {
    const TraceFrame& frame;
    const Tile& tile;
    TileHits& hits;
    Counters& counters;
};

/// Traces a tile in a grid; false: bundles cannot go through it from here. `numbers`: the grid's,
/// with the pyramid over them.
template <std::size_t support, class Sample>
bool trace_grid(const TileWork& work, const Isosurface& surface, const Samples& numbers,
                const Pyramid<Sample>& pyramid, double error) {
    thread_local RayLines lines;
    const auto* const first = static_cast<const Sample*>(numbers.data.get());
    const LevelGrid<Sample, support> grid(pyramid, numbers.size, first, surface.level, error);
    return VoxelTile<Sample, support>(work.frame, work.tile, *surface.volume, grid, error, lines,
                                      work.hits, work.counters)
        .run();
}

bool trace_spline(const TileWork& work, const Isosurface& surface, double error) {
    const SplineData& spline = *surface.volume->spline();
    const Samples& numbers = spline.coefficients();
    if (numbers.type != SampleType::Float || spline.pyramid<float>().range().holes) return false;
    return trace_grid<4>(work, surface, numbers, spline.pyramid<float>(), error);
}

bool trace_trilinear(const TileWork& work, const Isosurface& surface, double error) {
    const VolumeData& data = surface.volume->data();
    if (data.range().holes) return false;
    return visit_samples(data.samples(), [&](const auto* samples) {
        using Sample = std::remove_cvref_t<decltype(*samples)>;
        if constexpr (fits_float<Sample>) {
            return trace_grid<2>(work, surface, data.samples(), data.pyramid<Sample>(), error);
        } else {
            return false;
        }
    });
}

}  // namespace

bool VoxelWay::is_of(const Kernel& surface) const { return volume_of(surface) != nullptr; }

bool VoxelWay::trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                          Counters& counters) const {
    const bool plain = frame.precision == Precision::Float && !frame.whole_pixels &&
                       tile.places == nullptr && frame.union_members.empty();
    if (!plain) return false;
    const auto surface = isosurface_or_spline(frame.kernel, frame.scene);
    if (!surface) return false;
    const GridBounds bounds(*surface, frame);
    if (!bounds.usable()) return false;
    const TileWork work{.frame = frame, .tile = tile, .hits = hits, .counters = counters};
    return surface->volume->spline() != nullptr ? trace_spline(work, *surface, bounds.error())
                                                : trace_trilinear(work, *surface, bounds.error());
}

}  // namespace zeroset
