// Leaves [Stolte05, sec. 2.5]. Differs from the paper:
// - f at the corners is enclosed, not computed: a sign that is not proved may be either.
// - A leaf is refused, too, where f is not 0 on the ray's stretch in it: the surface passes the
//   octant, but beside the ray. So a hit is one of the ray, at the middle of that stretch, not at
//   the octant's.
// - The paper's text calls a function monotonic where the test of its figure 4 is true; it is where
//   it is false, as figure 1 has it.
// - A hit is certified where f is proved continuous with opposite signs around it.

#include "papers/octree/leaf_tests.hpp"

#include "engine/scene/tolerance.hpp"
#include "papers/octree/slope_frustum.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace zeroset {

template <class Real>
void LeafTests<Real>::evaluate(const TraceFrame& frame, std::size_t count, Counters& counters) {
    counters.range += count;
    boxes_.pad(count);
    frame.kernel.range(boxes_.batch(padded(count), frame.scene.uniforms.template boxes<Real>()));
}

template <class Real>
int LeafTests<Real>::sign(std::size_t i) const {
    return (boxes_.f_neg_lo[i] < 0 ? 1 : 0) - (boxes_.f_hi[i] < 0 ? 1 : 0);
}

template <class Real>
void LeafTests<Real>::test_on_rays(const TraceFrame& frame, std::span<LeafCase* const> open,
                                   Counters& counters) {
    for (std::size_t i = 0; i < open.size(); ++i) {
        const OctreeRay& ray = *open[i]->ray;
        const Octant& leaf = open[i]->leaf;
        store_box(
            both(box_of_octant(ray, leaf, frame.scene.clip), box_on_ray(ray, leaf.in, leaf.out)),
            boxes_.ends, i);
    }
    evaluate(frame, open.size(), counters);
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (boxes_.excludes_zero(i)) {
            open[i]->verdict = LeafVerdict::Refused;
        } else if (boxes_.continuous[i] == 0) {
            open[i]->verdict = LeafVerdict::Passed;
        }
    }
}

template <class Real>
void LeafTests<Real>::iso_value_test(const TraceFrame& frame, std::span<LeafCase* const> open,
                                     std::span<bool> changes, Counters& counters) {
    for (std::size_t i = 0; i < open.size(); ++i) {
        const Octant& leaf = open[i]->leaf;
        const RayBox octant = box_of_octant(*open[i]->ray, leaf, frame.scene.clip);
        const double spare = slope_slant * leaf.length;
        for (unsigned corner = 0; corner < 8; ++corner) {
            RayBox at{};
            for (int axis = 0; axis < 3; ++axis) {
                const bool upper = (corner >> axis & 1U) != 0;
                const double place = upper ? octant.hi[axis] : -octant.neg_lo[axis];
                at.neg_lo[axis] = -place + spare;
                at.hi[axis] = place + spare;
            }
            store_box(at, boxes_.ends, 8 * i + corner);
        }
    }
    evaluate(frame, 8 * open.size(), counters);
    for (std::size_t i = 0; i < open.size(); ++i) {
        const int first = sign(8 * i);
        changes[i] = first == 0;
        for (std::size_t corner = 1; corner < 8; ++corner)
            changes[i] = changes[i] || sign(8 * i + corner) != first;
    }
}

template <class Real>
void LeafTests<Real>::partial_differential_test(const TraceFrame& frame,
                                                std::span<LeafCase* const> open,
                                                std::span<bool> may_vanish, Counters& counters) {
    std::ranges::fill(may_vanish, false);
    std::array<RayBox, most_leaves> octants;
    for (std::size_t i = 0; i < open.size(); ++i)
        octants[i] = box_of_octant(*open[i]->ray, open[i]->leaf, frame.scene.clip);
    const std::span<const RayBox> boxes = std::span(octants).first(open.size());
    for (int axis = 0; axis < 3; ++axis) {
        const FrustumOf<Real> frustum = slope_frustum<Real>(boxes, axis, cells_);
        counters.form += boxes.size();
        frame.kernel.form(cells_.batch(padded(boxes.size()), frustum,
                                       frame.scene.uniforms.template boxes<Real>()));
        for (std::size_t i = 0; i < open.size(); ++i) {
            const bool monotonic = cells_.slope_neg_lo[i] < 0 || cells_.slope_hi[i] < 0;
            may_vanish[i] = may_vanish[i] || !monotonic || cells_.continuous[i] == 0;
        }
    }
}

/// Certifies roots as K-bisection does: by the sign at the leaf's beginning, and the opposite one
/// at its end, or up to extra_slices leaves behind it.
template <class Real>
void LeafTests<Real>::certify(const TraceFrame& frame, std::span<LeafCase* const> open,
                              Counters& counters) {
    std::array<int, most_leaves> before{};
    for (std::size_t i = 0; i < open.size(); ++i) {
        const OctreeRay& ray = *open[i]->ray;
        const double in = open[i]->from;
        const double earlier = std::max(ray.from, in - ray.step(open[i]->leaf.length));
        store_box(box_on_ray(ray, earlier, earlier), boxes_.ends, 3 * i);
        store_box(box_on_ray(ray, earlier, in), boxes_.ends, 3 * i + 1);
        store_box(box_on_ray(ray, open[i]->to, open[i]->to), boxes_.ends, 3 * i + 2);
    }
    evaluate(frame, 3 * open.size(), counters);
    Open left{};
    std::size_t count = 0;
    const auto look = [&](LeafCase* one, int sign_before, int sign_behind) {
        if (sign_before == 0 || one->from < one->ray->sure_from) return;
        if (one->to > one->ray->sure_to) return;
        if (sign_behind == -sign_before) {
            one->verdict = LeafVerdict::Certified;
            return;
        }
        before[count] = sign_before;
        left[count++] = one;
    };
    for (std::size_t i = 0; i < open.size(); ++i) {
        // Before the leaf there is no root, so where f is continuous it keeps its sign.
        const int kept = boxes_.continuous[3 * i + 1] != 0 ? sign(3 * i) : 0;
        look(open[i], sign(3 * i + 1) != 0 ? sign(3 * i + 1) : kept, sign(3 * i + 2));
    }
    for (int slice = 0; slice < extra_slices && count > 0; ++slice) {
        for (std::size_t i = 0; i < count; ++i) {
            const OctreeRay& ray = *left[i]->ray;
            const double next = left[i]->to + ray.step(left[i]->leaf.length);
            store_box(box_on_ray(ray, left[i]->to, next), boxes_.ends, 2 * i);
            store_box(box_on_ray(ray, next, next), boxes_.ends, 2 * i + 1);
        }
        evaluate(frame, 2 * count, counters);
        const std::size_t looked = std::exchange(count, 0);
        for (std::size_t i = 0; i < looked; ++i) {
            LeafCase* const one = left[i];
            if (boxes_.continuous[2 * i] == 0) continue;
            one->to += one->ray->step(one->leaf.length);
            look(one, before[i], sign(2 * i + 1));
        }
    }
    for (LeafCase* const one : open) {
        if (one->verdict != LeafVerdict::Certified) one->to = one->leaf.out;
    }
}

/// Refuses leaves where neither test of the paper finds a reason to stop.
template <class Real>
void LeafTests<Real>::test_octants(const TraceFrame& frame, std::span<LeafCase* const> open,
                                   Counters& counters) {
    std::array<bool, most_leaves> changes{};
    std::array<bool, most_leaves> may_vanish{};
    iso_value_test(frame, open, changes, counters);
    Open same{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (!changes[i]) same[count++] = open[i];
    }
    if (count == 0) return;
    const auto doubtful = std::span<LeafCase* const>(same).first(count);
    partial_differential_test(frame, doubtful, std::span(may_vanish).first(count), counters);
    for (std::size_t i = 0; i < count; ++i) {
        if (!may_vanish[i]) doubtful[i]->verdict = LeafVerdict::Refused;
    }
}

template <class Real>
void LeafTests<Real>::judge(const TraceFrame& frame, bool certifies, std::span<LeafCase> cases,
                            Counters& counters) {
    Open list{};
    std::size_t count = 0;
    for (LeafCase& one : cases) {
        one.verdict = LeafVerdict::Hit;
        one.from = one.leaf.in;
        one.to = one.leaf.out;
        list[count++] = &one;
    }
    // Keeps those in the list that may still be hits.
    const auto hits = [&] {
        const auto left =
            std::remove_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count),
                           [](const LeafCase* one) { return one->verdict != LeafVerdict::Hit; });
        count = static_cast<std::size_t>(left - list.begin());
        return std::span<LeafCase* const>(list).first(count);
    };
    if (count > 0) test_octants(frame, hits(), counters);
    if (const auto open = hits(); !open.empty()) test_on_rays(frame, open, counters);
    if (const auto open = hits(); certifies && !open.empty()) certify(frame, open, counters);
}

template class LeafTests<float>;
template class LeafTests<double>;

}  // namespace zeroset
