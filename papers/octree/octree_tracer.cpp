// Ray tracing by space subdivision: ray and surface are voxelised together [Stolte05].
//   NL        level of the leaves, where the search ends; 2^-NL of the cube's edge is their size
//   T         parameter of a ray in implicit form, see octree_ray.hpp
// The surface is voxelised to level 9 before the frame (voxelisation.cpp) and kept from frame to
// frame (octree_memory.hpp); ray_walk.cpp is the traversal, ray_voxelisation.cpp how a ray passes
// an octant, leaf_tests.cpp what ends it.
//
// Differs from the paper:
// - Rays wait for each other, so that the kernel judges the octants of many at once.
// - NL follows from the stop rule; under Delta an octant in which F is narrower is a leaf.
// - Octants are clipped to the clip box, rays to what is shown of it.
// - A leaf where f is not proved continuous is never a hit; the ray goes on, undecided.
// - A ray that refuses very many leaves, as one that runs along beside a surface, ends undecided.

#include "papers/octree/octree_tracer.hpp"

#include "engine/kernel/range_boxes.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/in_precision.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/tile_rays.hpp"
#include "papers/octree/leaf_tests.hpp"
#include "papers/octree/octree.hpp"
#include "papers/octree/octree_memory.hpp"
#include "papers/octree/ray_walk.hpp"
#include "papers/octree/tile_source.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Rays begin while fewer march.
constexpr std::size_t most_marching = 32;
constexpr int most_refused_leaves = 1 << 13;

/// A surface as these tracers prepare it.
struct PreparedOctree : PreparedSurface {
    std::shared_ptr<const Octree> octree;
};

/// Rays on their ways. Method: how a ray passes an octant.
template <class Real, class Method>
class OctreeWalks {
public:
    OctreeWalks(const TraceFrame& frame, TileSource& source, Counters& counters);
    void trace();

private:
    using State = RayWalk::State;
    static constexpr std::size_t most_leaves = LeafTests<Real>::most_leaves;
    static constexpr std::size_t most_walks = most_marching + most_leaves;  ///< of both together

    [[nodiscard]] bool next_ray(RayWalk& walk, State& state);
    /// Lets walks begin while there is room; false when the tile has no more.
    bool refill();
    /// Puts a walk where it waits, or ends it.
    void sort_in(RayWalk& walk, State state);
    void judge_asked();
    [[nodiscard]] RayWalk::Keep judged(std::size_t slot) const;
    void judge_leaves();
    void take(RayWalk& walk, const LeafCase& judged);
    void end(RayWalk& walk);
    void store_asked(const RayWalk& walk, std::size_t first);
    /// Tells who asks that f was evaluated so often for a ray.
    void tell_costs(const RayWalk& walk, double evaluations) const {
        if (counters_.costs != nullptr) counters_.costs->add(walk.pixel().index(), evaluations);
    }

    const TraceFrame& frame_;
    TileSource& source_;
    Counters& counters_;
    WalkPlan plan_;
    bool certifies_;
    Real delta_;  ///< F narrower than that makes a leaf; 0: never
    std::vector<RayWalk> walks_;
    std::vector<RayWalk*> idle_, marching_, at_leaf_;
    RangeBoxes<Real, 8 * most_walks> boxes_;
    LeafTests<Real> leaf_tests_;
};

WalkPlan plan_of(const TraceFrame& frame) {
    const auto* const prepared = static_cast<const PreparedOctree*>(frame.prepared);
    WalkPlan plan{.octree = prepared == nullptr ? nullptr : prepared->octree.get(),
                  .space = octree_space(frame.scene.clip),
                  .leaf_level = 0,
                  .eye = frame.view.eye};
    const LeafLevel leaves = leaf_level(frame, plan.space);
    plan.leaf_level = leaves.level;
    if (frame.stop.rule != StopRule::Epsilon && !frame.view.parallel())
        plan.coarser = std::max(frame.depth.deeper - leaves.missed, 0);
    return plan;
}

template <class Real, class Method>
OctreeWalks<Real, Method>::OctreeWalks(const TraceFrame& frame, TileSource& source,
                                       Counters& counters)
    : frame_(frame),
      source_(source),
      counters_(counters),
      plan_(plan_of(frame)),
      certifies_(Method::proves && leaf_level(frame, plan_.space).certifies()),
      delta_(frame.stop.rule == StopRule::Delta ? static_cast<Real>(frame.stop.value) : Real{0}),
      walks_(most_walks) {
    for (RayWalk& walk : walks_)
        idle_.push_back(&walk);
}

template <class Real, class Method>
bool OctreeWalks<Real, Method>::next_ray(RayWalk& walk, State& state) {
    const auto next = source_.next(plan_.space);
    if (!next) return false;
    state = walk.begin<Method>(plan_, next->first, next->second);
    return true;
}

template <class Real, class Method>
bool OctreeWalks<Real, Method>::refill() {
    while (marching_.size() < most_marching && at_leaf_.size() < most_leaves) {
        RayWalk& walk = *idle_.back();
        State state{};
        if (!next_ray(walk, state)) return false;
        idle_.pop_back();
        sort_in(walk, state);
    }
    return true;
}

template <class Real, class Method>
void OctreeWalks<Real, Method>::sort_in(RayWalk& walk, State state) {
    switch (state) {
        case State::Asks: marching_.push_back(&walk); return;
        case State::AtLeaf: at_leaf_.push_back(&walk); return;
        case State::Ended: end(walk); return;
    }
}

template <class Real, class Method>
void OctreeWalks<Real, Method>::end(RayWalk& walk) {
    if (!Method::proves) source_.leave(walk.pixel(), walk.ray(), walk.ray().from);
    idle_.push_back(&walk);
}

template <class Real, class Method>
void OctreeWalks<Real, Method>::store_asked(const RayWalk& walk, std::size_t first) {
    for (std::size_t i = 0; i < walk.asked().count; ++i)
        store_box(box_of_octant(walk.ray(), walk.asked_octant(i), frame_.scene.clip), boxes_.ends,
                  first + i);
}

template <class Real, class Method>
RayWalk::Keep OctreeWalks<Real, Method>::judged(std::size_t slot) const {
    if (boxes_.excludes_zero(slot)) return RayWalk::Keep::Drop;
    const bool narrow = boxes_.f_neg_lo[slot] + boxes_.f_hi[slot] < delta_;
    return narrow && boxes_.continuous[slot] != 0 ? RayWalk::Keep::Stop : RayWalk::Keep::Divide;
}

template <class Real, class Method>
void OctreeWalks<Real, Method>::judge_asked() {
    std::size_t count = 0;
    for (const RayWalk* const walk : marching_) {
        store_asked(*walk, count);
        count += walk->asked().count;
    }
    if (count > 0) {
        counters_.range += count;
        for (const RayWalk* const walk : marching_)
            tell_costs(*walk, static_cast<double>(walk->asked().count));
        boxes_.pad(count);
        frame_.kernel.range(
            boxes_.batch(padded(count), frame_.scene.uniforms.template boxes<Real>()));
    }
    // Walks that go on are put in again.
    std::array<RayWalk*, most_walks> judged_walks{};
    const std::size_t walks = marching_.size();
    std::ranges::copy(marching_, judged_walks.begin());
    marching_.clear();
    std::size_t first = 0;
    for (std::size_t i = 0; i < walks; ++i) {
        RayWalk& walk = *judged_walks[i];
        const std::size_t asked = walk.asked().count;
        walk.keep_asked([&](std::size_t octant) { return judged(first + octant); });
        first += asked;
        sort_in(walk, walk.go_on<Method>(plan_));
    }
}

template <class Real, class Method>
void OctreeWalks<Real, Method>::take(RayWalk& walk, const LeafCase& judged) {
    const OctreeRay& ray = walk.ray();
    if (judged.verdict == LeafVerdict::Refused || judged.verdict == LeafVerdict::Passed) {
        const bool too_many = ++walk.refused_leaves > most_refused_leaves;
        if (judged.verdict == LeafVerdict::Passed || too_many) {
            source_.leave(walk.pixel(), ray, judged.leaf.in);
            walk.unsettled = true;
        }
        return too_many ? end(walk) : sort_in(walk, walk.go_on<Method>(plan_));
    }
    const bool certified = judged.verdict == LeafVerdict::Certified && !walk.unsettled;
    source_.hit(walk.pixel(), ray, judged, certified);
    end(walk);
}

template <class Real, class Method>
void OctreeWalks<Real, Method>::judge_leaves() {
    std::array<LeafCase, most_leaves> cases;
    std::array<RayWalk*, most_leaves> walks{};
    const std::size_t count = std::min(at_leaf_.size(), most_leaves);
    for (std::size_t i = 0; i < count; ++i) {
        walks[i] = at_leaf_[i];
        cases[i] = {.ray = &walks[i]->ray(), .leaf = walks[i]->leaf()};
    }
    at_leaf_.erase(at_leaf_.begin(), at_leaf_.begin() + static_cast<std::ptrdiff_t>(count));
    const std::uint64_t before = counters_.range + counters_.form;
    leaf_tests_.judge(frame_, certifies_, std::span(cases).first(count), counters_);
    const auto asked = static_cast<double>(counters_.range + counters_.form - before);
    for (const RayWalk* const walk : std::span(walks).first(count))
        tell_costs(*walk, asked / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
        take(*walks[i], cases[i]);
}

template <class Real, class Method>
void OctreeWalks<Real, Method>::trace() {
    bool more = true;
    while (!frame_.stopped()) {
        more = more && refill();
        if (marching_.empty() && at_leaf_.empty()) {
            if (!more) return;
            continue;
        }
        // Leaves wait until they are many, or nothing else is to be done.
        if (at_leaf_.size() >= most_leaves || marching_.empty()) {
            judge_leaves();
        } else {
            judge_asked();
        }
    }
    source_.stop();
}

template <class Method>
void trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters) {
    TileSource source(frame, tile, hits);
    in_precision(frame, [&](auto real) {
        const auto work =
            std::make_unique<OctreeWalks<decltype(real), Method>>(frame, source, counters);
        work->trace();
    });
}

}  // namespace

void trace_tile_octree(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters) {
    trace_tile<RoundedVoxelisation>(frame, tile, hits, counters);
}

void trace_tile_octree_unrounded(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                                 Counters& counters) {
    trace_tile<UnroundedVoxelisation>(frame, tile, hits, counters);
}

void trace_tile_gargantini(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                           Counters& counters) {
    trace_tile<GargantiniTraversal>(frame, tile, hits, counters);
}

std::shared_ptr<const PreparedSurface> prepare_octree_tracer(const TraceFrame& surface,
                                                             int threads) {
    auto octree = std::static_pointer_cast<const Octree>(prepare_octree(surface, threads));
    if (octree == nullptr) return nullptr;
    auto prepared = std::make_shared<PreparedOctree>();
    prepared->octree = std::move(octree);
    return prepared;
}

}  // namespace zeroset
