// The verification of traversals [Stolte05, sec. 2.6]: the implicit form of the same ray, its
// numbers as they are, in __float128 with its 113 bits. Differences of a ray's start and an
// octant's planes have at most 53 bits where the ray starts before the cube, products with c at
// most 106: then nothing is rounded at all.

#include "papers/octree/verification.hpp"

#include "engine/base/enum_names.hpp"
#include "engine/base/parallel.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/in_precision.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/tile_rays.hpp"
#include "papers/octree/ray_walk.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <span>

namespace zeroset {
namespace {

__extension__ using Wide = __float128;

/// The sub-octants that the ray passes with more than a point, in order, by their bits.
struct ExactOrder {
    std::size_t count = 0;
    std::array<std::uint8_t, 8> index;
};

ExactOrder exact_order(const OctreeRay& ray, const Octant& octant) {
    const Wide half = Wide{octant.length} / 2;
    std::array<std::array<Wide, 3>, 3> at;  // of the lower, middle and upper plane of each axis
    for (int axis = 0; axis < 3; ++axis) {
        for (int plane = 0; plane < 3; ++plane) {
            const Wide place = Wide{octant.corner[axis]} + half * plane;
            at[static_cast<std::size_t>(plane)][static_cast<std::size_t>(axis)] =
                Wide{ray.c[axis]} * (place - Wide{ray.start[axis]});
        }
    }
    // In the ray's axes the order of indices is one from front to back.
    ExactOrder order;
    for (unsigned index = 0; index < 8; ++index) {
        Wide in = ray.from;
        Wide out = ray.to;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t plane = index >> axis & 1U;
            in = std::max(in, at[plane][axis]);
            out = std::min(out, at[plane + 1][axis]);
        }
        if (in < out) order.index[order.count++] = static_cast<std::uint8_t>(index);
    }
    return order;
}

TraversalCheck compared(const SubOctants& passed, const ExactOrder& exact) {
    const std::span found(passed.index.data(), passed.count);
    const std::span wanted(exact.index.data(), exact.count);
    TraversalCheck check{.octants = 1, .differing = std::ranges::equal(found, wanted) ? 0U : 1U};
    for (const std::uint8_t index : wanted)
        check.missed += std::ranges::find(found, index) == found.end() ? 1U : 0U;
    for (const std::uint8_t index : found)
        check.extra += std::ranges::find(wanted, index) == wanted.end() ? 1U : 0U;
    return check;
}

/// A way that keeps account of itself.
template <class Method>
struct Verified {
    static void pass(const OctreeRay& ray, const Octant& octant, SubOctants& passed) {
        Method::pass(ray, octant, passed);
        account += compared(passed, exact_order(ray, octant));
    }
    static thread_local TraversalCheck account;
};
template <class Method>
thread_local TraversalCheck Verified<Method>::account;

/// Leaves of what a walk asks those octants that may hold the surface.
template <class Real>
void answer(const TraceFrame& frame, RayWalk& walk, RangeBoxes<Real, batch_multiple>& boxes) {
    const std::size_t count = walk.asked().count;
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i)
        store_box(box_of_octant(walk.ray(), walk.asked_octant(i), frame.scene.clip), boxes.ends, i);
    boxes.pad(count);
    frame.kernel.range(boxes.batch(padded(count), frame.scene.uniforms.template boxes<Real>()));
    walk.keep_asked([&](std::size_t i) {
        return boxes.excludes_zero(i) ? RayWalk::Keep::Drop : RayWalk::Keep::Divide;
    });
}

template <class Real, class Method>
TraversalCheck verify_tile(const TraceFrame& frame, const Tile& tile) {
    using Way = Verified<Method>;
    Way::account = {};
    const TileRays rays(frame, tile);
    WalkPlan plan{.octree = static_cast<const Octree*>(frame.prepared),
                  .space = octree_space(frame.scene.clip),
                  .leaf_level = 0};
    plan.leaf_level = leaf_level(frame, plan.space).level;
    const auto walk = std::make_unique<RayWalk>();
    RangeBoxes<Real, batch_multiple> boxes;
    std::uint64_t met = 0;
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols && !frame.stopped(); ++col) {
            const auto ray = octree_ray(frame, tile, rays, plan.space, col, row);
            if (!ray) continue;
            ++met;
            RayWalk::State state = walk->begin<Way>(plan, *ray, {});
            while (state == RayWalk::State::Asks) {
                answer(frame, *walk, boxes);
                state = walk->go_on<Way>(plan);
            }
        }
    }
    Way::account.rays = met;
    return Way::account;
}

template <class Method>
TraversalCheck verify(const TraceFrame& frame, const Tile& tile) {
    return in_precision(
        frame, [&](auto real) { return verify_tile<decltype(real), Method>(frame, tile); });
}

TraversalCheck verify(const TraceFrame& frame, const Tile& tile, Traversal traversal) {
    switch (traversal) {
        case Traversal::Octree: return verify<RoundedVoxelisation>(frame, tile);
        case Traversal::Unrounded: return verify<UnroundedVoxelisation>(frame, tile);
        case Traversal::Gargantini: return verify<GargantiniTraversal>(frame, tile);
    }
    return {};
}

}  // namespace

std::string_view name_of(Traversal traversal) {
    return enum_names<Traversal>("octree", "octree-unrounded", "gargantini").of(traversal);
}

TraversalCheck& TraversalCheck::operator+=(const TraversalCheck& other) {
    rays += other.rays;
    octants += other.octants;
    differing += other.differing;
    missed += other.missed;
    extra += other.extra;
    return *this;
}

TraversalCheck verify_traversal(const TraceFrame& surface, Traversal traversal, int threads) {
    const TileGrid grid(surface.image.width, surface.image.height);
    std::mutex mutex;
    TraversalCheck total;
    parallel_for(grid.size(), threads, [&](std::size_t i) {
        const UpwardRegisters upward;
        const TraversalCheck check = verify(surface, grid.tile(i), traversal);
        const std::scoped_lock lock(mutex);
        total += check;
    });
    return total;
}

}  // namespace zeroset
