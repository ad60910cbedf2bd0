#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/trace/followed_rays.hpp"
#include "engine/trace/scene_ray.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"
#include "engine/view/box.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// The way in which a kind of surface is searched; way_of (engine/trace/ways/surface_ways.hpp)
/// tells that of a surface. This one is that of formulas: all is done by searching f, which the
/// kernel tells. Others answer some of the questions by what they know of the surface. Where a
/// level set's way gives no answer (false, or nothing), f is searched for it.
///
/// Without state: any thread. All but is_of and is_level_set in upward rounding.
class SurfaceWay {
public:
    SurfaceWay() = default;
    SurfaceWay(const SurfaceWay&) = delete;
    SurfaceWay& operator=(const SurfaceWay&) = delete;
    virtual ~SurfaceWay() = default;

    /// Whether a surface is of this kind, by its facts (engine/kernel/surface_facts.hpp).
    [[nodiscard]] virtual bool is_of(const Kernel&) const { return true; }
    /// Whether the surface is where a function f is 0. Else its kernel's functions know nothing of
    /// any place, it has no inside, and no tracer draws it but its way.
    [[nodiscard]] virtual bool is_level_set() const { return true; }

    /// Data of the surface that all views of it share (TraceFrame::prepared), kept from frame to
    /// frame; nullptr: there is none.
    [[nodiscard]] virtual std::shared_ptr<const PreparedSurface> prepare(const Kernel&,
                                                                         const Uniforms&) const {
        return nullptr;
    }
    /// The first hits in a tile, as Tracer::trace_tile.
    virtual bool trace_tile(const TraceFrame&, const Tile&, TileHits&, Counters&) const {
        return false;
    }
    /// Code for cells and points of a tile's whole pixels: the same function as the frame's kernel,
    /// by what is near. Good for this thread, until it asks for another one; frame and tile outlive
    /// it.
    [[nodiscard]] virtual std::optional<Kernel> kernel_for(const TraceFrame&, const Tile&) const {
        return std::nullopt;
    }

    /// Takes the surface's first hits that are nearer than those so far, which are of any surface.
    /// The rays go anywhere, and are clipped; `number`: of the surface.
    virtual bool find_first(const TraceFrame&, std::uint8_t /*number*/, std::span<const SceneRay>,
                            std::span<RayHit>, Counters&) const {
        return false;
    }
    /// Marks those of the rays that are not blocked yet on which the surface is, or may be.
    virtual bool find_blocked(const TraceFrame&, std::uint8_t /*number*/, std::span<const SceneRay>,
                              std::span<std::uint8_t> /*blocked*/, Counters&) const {
        return false;
    }

    /// Whether follow() can be asked for this frame.
    [[nodiscard]] virtual bool follows(const TraceFrame&) const { return false; }
    /// Follows rays of the frame's view, which is parallel: the blocks of a tile, row by row.
    /// `bracket`: how near to a root of a level set they may end. False: places are not known well
    /// enough to prove anything.
    virtual bool follow(const TraceFrame&, const TileRays&, double /*bracket*/,
                        std::span<FollowedRays>, Counters&) const {
        return false;
    }

    /// Boxes in the world that hold the surface together; nothing: where f may be 0.
    [[nodiscard]] virtual std::optional<std::vector<Box>> boxes(const Kernel&,
                                                                const Uniforms&) const {
        return std::nullopt;
    }
    /// The first hit on a ray, without a frame; `tolerance`: a bracket's width that is narrow
    /// enough. RayHit::surface is 0 where there is a hit.
    [[nodiscard]] virtual std::optional<RayHit> hit_on(const Kernel&, const Uniforms&,
                                                       const SceneRay&,
                                                       double /*tolerance*/) const {
        return std::nullopt;
    }
};

}  // namespace zeroset
