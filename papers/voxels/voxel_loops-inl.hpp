// Loops over the rays of a tile and over given voxels, by any method in packets: a packet's lanes
// walk each for itself, and are intersected together when each of them has come to a voxel that
// holds the level.
// Differs from the paper: its packets are 2 x 2 rays in one voxel, those that miss it masked; here
// each lane has a voxel of its own, and a lane whose ray has ended takes another ray.

#if defined(ZEROSET_VOXEL_LOOPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_VOXEL_LOOPS_INL
#undef ZEROSET_VOXEL_LOOPS_INL
#else
#define ZEROSET_VOXEL_LOOPS_INL
#endif

#include "engine/trace/tile_costs.hpp"
#include "papers/along_rays/hit_writer.hpp"
#include "papers/voxels/voxel_lanes-inl.hpp"
#include "papers/voxels/voxel_tracers.hpp"
#include "papers/voxels/voxel_walk.hpp"

#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Method>
class VoxelTracer {
    using D = Tag<float>;

public:
    explicit VoxelTracer(const VoxelTask& tile) : tile_(tile), open_(tile.lines.pixels()) {
        for (auto& column : columns_)
            column.fill(1.0F);
    }

    void run() {
        while (!stopped()) {
            bool any = false;
            for (std::size_t lane = 0; lane < lanes; ++lane)
                any |= find_voxel(lane);
            if (!any) return;
            intersect();
        }
        leave_all();
    }

private:
    static constexpr std::size_t lanes = hn::MaxLanes(D());
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// Looked at for a tile's part of rays at a time.
    bool stopped() {
        constexpr std::size_t rays_between = 64;
        if (next_ < next_look_) return false;
        next_look_ = next_ + rays_between;
        return tile_.frame.stopped();
    }
    /// Gives the lane the next voxel of its ray, or of another ray; false: there is none left.
    bool find_voxel(std::size_t lane) {
        Lane& ray = rays_[lane];
        for (;;) {
            if (ray.pixel == none && !begin_ray(ray)) return false;
            VoxelRay voxel;
            const bool found = tile_.walk.next(ray.walk, voxel);
            tell_looks(ray);
            if (found) {
                put(voxel, lane);
                return true;
            }
            tile_.writer.leave_unsettled(ray.pixel, tile_.lines.of(ray.pixel).from);
            ray.pixel = none;
        }
    }
    struct Lane {
        std::uint32_t pixel = none;
        WalkingRay walk;
    };
    bool begin_ray(Lane& ray) {
        for (; next_ < open_.size(); ++next_) {
            const std::uint32_t pixel = open_[next_];
            const RayLine& line = tile_.lines.of(pixel);
            if (tile_.walk.begin(line, ray.walk)) {
                ray.pixel = pixel;
                ++next_;
                return true;
            }
            tile_.writer.leave_unsettled(pixel, line.from);
        }
        return false;
    }
    void tell_looks(Lane& ray) {
        const std::uint32_t looks = std::exchange(ray.walk.looks, 0);
        tile_.counters.range += looks;
        if (tile_.counters.costs != nullptr) tile_.counters.costs->add(ray.pixel, looks);
    }
    void put(const VoxelRay& voxel, std::size_t lane) {
        for (std::size_t i = 0; i < 8; ++i)
            columns_[i][lane] = voxel.rho[i];
        for (std::size_t i = 0; i < 3; ++i) {
            columns_[8 + i][lane] = voxel.a[i];
            columns_[11 + i][lane] = voxel.b[i];
        }
        columns_[14][lane] = voxel.t_out;
    }
    void intersect() {
        const D tag;
        HWY_ALIGN float t[lanes];
        const auto voxels =
            load_voxels(tag, [&](std::size_t column) { return columns_[column].data(); });
        hn::Store(Method::first_hit(tag, voxels), tag, t);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            Lane& ray = rays_[lane];
            if (ray.pixel == none) continue;
            ++tile_.counters.value;
            if (tile_.counters.costs != nullptr) tile_.counters.costs->add(ray.pixel);
            if (!(t[lane] < std::numeric_limits<float>::infinity())) continue;
            tile_.writer.push(ray.pixel, ray.walk.voxel_from + static_cast<double>(t[lane]), false);
            ray.pixel = none;
        }
    }
    void leave_all() {
        for (const Lane& ray : rays_) {
            if (ray.pixel != none)
                tile_.writer.leave_unsettled(ray.pixel, tile_.lines.of(ray.pixel).from);
        }
        for (; next_ < open_.size(); ++next_)
            tile_.writer.leave_unsettled(open_[next_], tile_.lines.of(open_[next_]).from);
    }

    const VoxelTask& tile_;
    std::span<const std::uint32_t> open_;
    std::size_t next_ = 0, next_look_ = 0;
    std::array<Lane, lanes> rays_;
    std::array<std::array<float, lanes>, voxel_columns> columns_{};
};

/// The first hits in the voxels, as many at once as D has lanes; `t` is as long as their columns.
template <class D, class Method>
void find_hits_of(const VoxelRays& voxels, float* t) {
    const D tag;
    constexpr std::size_t lanes_at_once = hn::MaxLanes(D());
    for (std::size_t i = 0; i < voxels.count(); i += lanes_at_once) {
        const auto rays =
            load_voxels(tag, [&](std::size_t column) { return voxels.column(column) + i; });
        hn::StoreU(Method::first_hit(tag, rays), tag, t + i);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
