#pragma once

#include "engine/antialias/cover_light.hpp"
#include "engine/antialias/cover_sample.hpp"
#include "engine/appearance/frame_light.hpp"
#include "engine/light/encode.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/caps.hpp"
#include "engine/trace/frame_kernels.hpp"
#include "engine/trace/frame_union.hpp"
#include "engine/trace/nearest.hpp"
#include "engine/trace/open_view.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace zeroset {

/// Memory that a thread keeps from tile to tile.
struct Workspace {
    std::vector<TileHits> hits;  ///< of each surface
    NearestSurfaces nearest;
    LitTile lit;
    CapFinder caps;
    std::vector<float> cover_limits;  ///< Tile::limits of whole pixels
    std::vector<UnionMember> union_members;
    std::vector<MixedPixel> mixed;
    std::vector<CoverSample> samples;
    CoverLight cover_light;
    TileCosts costs;
};

/// The state of a tile.
enum class TileState : std::uint8_t {
    Waiting,  ///< nothing is drawn
    Cut,      ///< some of its rays were not searched to their end
    Rough,    ///< shadows or smooth edges are missing
    Finished,
};

/// How the scene is antialiased. Beams know neither of caps, nor of jumps, nor of surfaces
/// that are no level sets: there 16 rays do it.
Antialias antialias_of(const Scene& scene, const TraceSettings& settings);

/// A scene at one resolution, tile by tile.
class TilePainter {
public:
    /// `fineness`: pixels of `image` across one of the picture.
    TilePainter(const Scene& scene, const ViewFrame& view, const TraceSettings& settings,
                const ImageSize& image, int fineness, const TimeLimit& limit);
    /// In upward rounding.
    TileState paint(Tile tile, const TimeLimit& limit, Workspace& workspace, const Canvas& out,
                    Counters& counters) const;

private:
    /// Prepares a surface (TraceFrame::prepared) by the tracer, or by the way of its kind.
    [[nodiscard]] std::shared_ptr<const PreparedSurface> prepare(const TraceFrame& surface,
                                                                 const TraceSettings& settings,
                                                                 const TimeLimit& limit) const;
    /// Fills workspace.hits with what each surface shows.
    void trace(Tile tile, const TimeLimit& limit, Workspace& workspace, Counters& counters) const;
    /// Traces surface i part by part and finds its gradients; false where that cannot be.
    bool trace_union(std::size_t i, const Tile& tile, const TimeLimit& limit, Workspace& workspace,
                     Counters& counters) const;
    /// Draws again, by their parts, pixels that may show more than one smooth sheet.
    void smooth(const Tile& tile, const TimeLimit& limit, Workspace& workspace, const Canvas& out,
                Counters& counters) const;
    /// Traces surface i.
    void trace_surface(std::size_t i, const Tile& tile, const TimeLimit& limit,
                       Workspace& workspace, Counters& counters) const;

    /// Surface i with the kernel for the tile.
    [[nodiscard]] TraceFrame frame_of(std::size_t i, const Tile& tile,
                                      const TimeLimit& limit) const {
        const TraceFrame& whole = surfaces_[i];
        const Kernel& kernel = kernels_[i] == nullptr ? whole.kernel : kernels_[i]->of(tile);
        return whole.with(kernel, limit);
    }

    const Tracer& tracer_;
    FrameLight light_;
    bool beams_;  ///< pixels that show more than one smooth sheet are drawn part by part
    std::vector<TraceFrame> surfaces_;
    std::vector<std::unique_ptr<FrameKernels>> kernels_;  ///< nullptr: of all tiles the same
    std::vector<std::unique_ptr<FrameUnion>> unions_;     ///< nullptr: no union is known
    std::vector<std::unique_ptr<OpenView>> open_views_;   ///< nullptr: not known
    std::vector<std::shared_ptr<const PreparedSurface>> prepared_;  ///< of the surfaces; or nullptr
    std::vector<int> solid_signs_;  ///< of the surfaces; empty: nothing is capped
};

}  // namespace zeroset
