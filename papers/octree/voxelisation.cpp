// The static voxelisation [Stolte05, sec. 2.2], level by level, each in parallel.

#include "papers/octree/voxelisation.hpp"

#include "engine/base/parallel.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/in_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t nodes_at_once = 32;

/// Where an octant is: its number along each axis, among those of its level.
using Place = std::array<std::uint16_t, 3>;

/// The ends of the octants of a level along each axis, within the clip box.
template <class Real>
struct LevelPlanes {
    std::array<std::vector<Real>, 3> neg_lo, hi;
    std::array<std::vector<bool>, 3> outside;  ///< of octants beyond the clip box

    /// In upward rounding.
    LevelPlanes(const OctreeSpace& space, const Box& clip, int level) {
        const double length = std::ldexp(space.edge, -level);
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            for (int i = 0; i < 1 << level; ++i) {
                const double from = space.corner[axis] + i * length;
                const double to = from + length;
                outside[k].push_back(from >= clip.hi[axis] || to <= clip.lo[axis]);
                neg_lo[k].push_back(static_cast<Real>(-std::max(from, clip.lo[axis])));
                hi[k].push_back(static_cast<Real>(std::min(to, clip.hi[axis])));
            }
        }
    }
};

/// Finds which octants of nodes hold the surface. For one thread.
template <class Real>
class NodeJudge {
public:
    NodeJudge(const TraceFrame& frame, const LevelPlanes<Real>& planes)
        : frame_(frame), planes_(planes) {}

    /// `nodes`: of `places`, at most nodes_at_once. In upward rounding.
    [[gnu::noinline]] void judge(std::span<const Place> places, std::span<Octree::Node> nodes) {
        std::size_t count = 0;
        for (const Place& place : places) {
            for (unsigned octant = 0; octant < 8; ++octant)
                store(place, octant, count++);
        }
        boxes_.pad(count);
        frame_.kernel.range(
            boxes_.batch(padded(count), frame_.scene.uniforms.template boxes<Real>()));
        for (std::size_t i = 0; i < count; ++i) {
            if (is_outside_[i] || boxes_.excludes_zero(i)) continue;
            nodes[i / 8].octants |= static_cast<std::uint8_t>(1U << i % 8);
        }
    }

private:
    void store(const Place& place, unsigned octant, std::size_t i) {
        is_outside_[i] = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t at = 2 * std::size_t{place[k]} + (octant >> k & 1U);
            boxes_.ends[k][i] = planes_.neg_lo[k][at];
            boxes_.ends[k + 3][i] = planes_.hi[k][at];
            is_outside_[i] = is_outside_[i] || planes_.outside[k][at];
        }
        if (!is_outside_[i]) return;
        // Some box that there is, so that nothing is asked outside of the clip box.
        for (std::size_t k = 0; k < 3; ++k) {
            boxes_.ends[k][i] = static_cast<Real>(-frame_.scene.clip.lo[static_cast<int>(k)]);
            boxes_.ends[k + 3][i] = -boxes_.ends[k][i];
        }
    }

    const TraceFrame& frame_;
    const LevelPlanes<Real>& planes_;
    RangeBoxes<Real, 8 * nodes_at_once> boxes_;
    std::array<bool, 8 * nodes_at_once> is_outside_{};
};

/// The places of the octants of all nodes, in order; each node learns where its first one is.
std::vector<Place> places_below(const std::vector<Place>& places,
                                std::vector<Octree::Node>& nodes) {
    std::vector<Place> below;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].first = static_cast<std::uint32_t>(below.size());
        for (unsigned octant = 0; octant < 8; ++octant) {
            if ((nodes[i].octants >> octant & 1U) == 0) continue;
            Place place{};
            for (std::size_t k = 0; k < 3; ++k)
                place[k] = static_cast<std::uint16_t>(2U * places[i][k] + (octant >> k & 1U));
            below.push_back(place);
        }
    }
    return below;
}

template <class Real>
std::vector<Octree::Node> nodes_of(const TraceFrame& frame, const LevelPlanes<Real>& planes,
                                   const std::vector<Place>& places, int threads) {
    std::vector<Octree::Node> nodes(places.size());
    parallel_for((places.size() + nodes_at_once - 1) / nodes_at_once, threads, [&](std::size_t i) {
        if (frame.stopped()) return;
        const UpwardRegisters upward;
        const std::size_t first = i * nodes_at_once;
        const std::size_t count = std::min(nodes_at_once, places.size() - first);
        NodeJudge<Real>(frame, planes)
            .judge(std::span(places).subspan(first, count), std::span(nodes).subspan(first, count));
    });
    return nodes;
}

}  // namespace

std::shared_ptr<const Octree> voxelise(const TraceFrame& frame, int level, int threads) {
    auto octree = std::make_shared<Octree>();
    octree->space = octree_space(frame.scene.clip);
    std::vector<Place> places{Place{}};
    in_precision(frame, [&](auto real) {
        using Real = decltype(real);
        for (int i = 0; i < level; ++i) {
            const auto planes = [&] {
                const UpwardRegisters upward;
                return LevelPlanes<Real>(octree->space, frame.scene.clip, i + 1);
            }();
            std::vector<Octree::Node> nodes = nodes_of(frame, planes, places, threads);
            if (frame.stopped()) return;
            if (i + 1 < level) places = places_below(places, nodes);
            octree->levels.push_back(std::move(nodes));
        }
    });
    return octree;
}

}  // namespace zeroset
