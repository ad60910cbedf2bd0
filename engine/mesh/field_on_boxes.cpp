#include "engine/mesh/field_on_boxes.hpp"

#include "engine/kernel/range_boxes.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace zeroset {
namespace {

constexpr std::size_t boxes_at_once = 256;

struct Boxes : RangeBoxes<double, boxes_at_once> {
    alignas(64) ContinuityMask<double> branches[boxes_at_once];

    void set(std::size_t i, const Box& box) {
        for (int axis = 0; axis < 3; ++axis) {
            ends[axis][i] = -box.lo[axis];
            ends[axis + 3][i] = box.hi[axis];
        }
    }
    void evaluate(const KernelFunction<RangeBatchOf<double>>& range, std::size_t count,
                  const Uniforms& uniforms, bool asks_branches) {
        pad(count);
        RangeBatchOf<double> boxes = batch(padded(count), uniforms.boxes<double>());
        if (asks_branches) boxes.branches = branches;
        range(boxes);
    }
};

/// Boxes for a thread's work, as they are too large for a stack.
Boxes& boxes_of_thread() {
    thread_local const auto kept = std::make_unique<Boxes>();
    Boxes& boxes = *kept;
    return boxes;
}

/// An enclosure of a cut's function over a box, in upward rounding, widened by a few ulp.
std::pair<double, double> range_of(const SolidCut& cut, const Box& box) {
    double lo = 0.0;
    double hi = 0.0;
    double size = std::abs(cut.reach);
    for (int axis = 0; axis < 3; ++axis) {
        if (cut.is_ball) {
            const double a = box.lo[axis] - cut.place[axis];
            const double b = box.hi[axis] - cut.place[axis];
            const double far = std::max(a * a, b * b);
            hi += far;
            lo += a < 0 && b > 0 ? 0.0 : std::min(a * a, b * b);
            size += far;
        } else {
            const double a = cut.place[axis] * box.lo[axis];
            const double b = cut.place[axis] * box.hi[axis];
            lo += std::min(a, b);
            hi += std::max(a, b);
            size += std::max(std::abs(a), std::abs(b));
        }
    }
    if (cut.is_ball) {
        lo = (lo - cut.reach * cut.reach) / (2.0 * cut.reach);
        hi = (hi - cut.reach * cut.reach) / (2.0 * cut.reach);
        size = size / cut.reach + cut.reach;
    } else {
        lo -= cut.reach;
        hi -= cut.reach;
    }
    const double rounding = 0x1p-48 * size;
    return {lo - rounding, hi + rounding};
}

GradientBox gradient_of(const SolidCut& cut, const Box& box) {
    if (!cut.is_ball) return {.lo = cut.place, .hi = cut.place};
    const glm::dvec3 rounding(0x1p-48 * (glm::length(cut.place) / cut.reach + 1.0));
    return {.lo = (box.lo - cut.place) / cut.reach - rounding,
            .hi = (box.hi - cut.place) / cut.reach + rounding};
}

}  // namespace

void BoxFacts::add(const GradientBox& gradient, std::size_t of_part) {
    part = static_cast<std::uint32_t>(of_part);
    if (count < most_gradients) {
        gradients[count++] = gradient;
        return;
    }
    GradientBox& last = gradients.back();
    last.lo = glm::min(last.lo, gradient.lo);
    last.hi = glm::max(last.hi, gradient.hi);
}

void BoxFacts::take(const GradientBox& gradient, std::size_t of_part, double sign) {
    for (int axis = 0; axis < 3; ++axis) {
        graded = graded && std::isfinite(gradient.lo[axis]) && std::isfinite(gradient.hi[axis]) &&
                 gradient.lo[axis] <= gradient.hi[axis];
    }
    add(sign > 0 ? gradient : GradientBox{.lo = -gradient.hi, .hi = -gradient.lo}, of_part);
}

void FieldOnBoxes::find_ranges(std::span<const Box> boxes) {
    Boxes& batch = boxes_of_thread();
    count_ = boxes.size();
    ranges_.resize(solid_.parts.size() * count_);
    for (std::size_t p = 0; p < solid_.parts.size(); ++p) {
        const SolidPart& part = solid_.parts[p];
        for (std::size_t i = 0; i < count_; ++i)
            batch.set(i, boxes[i]);
        batch.evaluate(part.range, count_, solid_.uniforms, part.branches);
        for (std::size_t i = 0; i < count_; ++i) {
            const double neg_lo = batch.f_neg_lo[i];
            const double hi = batch.f_hi[i];
            PartRange& range = ranges_[p * count_ + i];
            range.nowhere = neg_lo == -unbounded && hi == -unbounded;
            // Two stretches beside 0, or what is not known: anything.
            const bool known = !std::isnan(neg_lo) && !std::isnan(hi) && !(neg_lo < 0 && hi < 0);
            range.lo = known ? -neg_lo : -unbounded;
            range.hi = known ? hi : unbounded;
            range.continuous = batch.continuous[i] != 0;
            range.kink = part.branches &&
                         BranchBits{static_cast<std::uint32_t>(batch.branches[i])}.may_hold_kink();
        }
    }
}

/// Where the box lies by the tree of nodes and the cuts; leaves the nodes' ranges behind.
void FieldOnBoxes::find_side(const Box& box, std::size_t i, BoxFacts& facts) {
    bool defined = true;
    for (std::size_t p = 0; p < solid_.parts.size(); ++p) {
        defined = defined && (range(p, i).continuous || solid_.parts[p].defined_everywhere);
        if (range(p, i).nowhere) facts.side = BoxSide::Outside;
    }
    for (std::size_t n = 0; n < solid_.nodes.size(); ++n) {
        const SolidNode& node = solid_.nodes[n];
        if (node.kind == SolidNode::Kind::Leaf) {
            const PartRange& part = range(node.a, i);
            node_ranges_[n] = node.sign > 0 ? Range{.lo = part.lo, .hi = part.hi}
                                            : Range{.lo = -part.hi, .hi = -part.lo};
            continue;
        }
        const Range& a = node_ranges_[node.a];
        const Range& b = node_ranges_[node.b];
        node_ranges_[n] = node.kind == SolidNode::Kind::Max
                              ? Range{.lo = std::max(a.lo, b.lo), .hi = std::max(a.hi, b.hi)}
                              : Range{.lo = std::min(a.lo, b.lo), .hi = std::min(a.hi, b.hi)};
    }
    if (node_ranges_.back().lo > 0) facts.side = BoxSide::Outside;
    bool inside = defined && node_ranges_.back().hi < 0;
    for (const SolidCut& cut : solid_.cuts) {
        const auto [lo, hi] = range_of(cut, box);
        if (lo > 0) facts.side = BoxSide::Outside;
        inside = inside && hi < 0;
    }
    if (inside) facts.side = BoxSide::Inside;
}

/// Adds the leaves below a node, which is neither surely above nor below 0, whose zeros may be its.
void FieldOnBoxes::find_touches(std::uint32_t node, std::uint32_t box) {
    const SolidNode& own = solid_.nodes[node];
    if (own.kind == SolidNode::Kind::Leaf) {
        touches_.push_back({.box = box, .part = own.a, .sign = own.sign});
        return;
    }
    for (const std::uint32_t below : {own.a, own.b}) {
        const Range& range = node_ranges_[below];
        if (range.lo <= 0 && range.hi >= 0) find_touches(below, box);
    }
}

/// Asks for the gradients of the leaves in `touches_` and gives them to their boxes.
void FieldOnBoxes::take_gradients(std::span<const Box> boxes, std::span<BoxFacts> facts) {
    Boxes& batch = boxes_of_thread();
    std::ranges::stable_sort(touches_, {}, &Touch::part);
    std::array<std::array<double, 6>, boxes_at_once> ends{};
    for (std::size_t first = 0; first < touches_.size();) {
        const SolidPart& part = solid_.parts[touches_[first].part];
        std::size_t count = 0;
        while (first + count < touches_.size() && count < boxes_at_once &&
               touches_[first + count].part == touches_[first].part)
            ++count;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t n = 0; n < count; ++n)
                batch.set(n, boxes[touches_[first + n].box]);
            batch.evaluate(part.gradient[axis], count, solid_.uniforms, false);
            for (std::size_t n = 0; n < count; ++n) {
                ends[n][axis] = -batch.f_neg_lo[n];
                ends[n][axis + 3] = batch.f_hi[n];
            }
        }
        for (std::size_t n = 0; n < count; ++n) {
            const Touch& touch = touches_[first + n];
            const GradientBox gradient{.lo = {ends[n][0], ends[n][1], ends[n][2]},
                                       .hi = {ends[n][3], ends[n][4], ends[n][5]}};
            facts[touch.box].take(gradient, touch.part, touch.sign);
        }
        first += count;
    }
}

void FieldOnBoxes::evaluate_some(std::span<const Box> boxes, std::span<BoxFacts> facts) {
    find_ranges(boxes);
    touches_.clear();
    for (std::uint32_t i = 0; i < count_; ++i) {
        facts[i] = {};
        find_side(boxes[i], i, facts[i]);
        if (facts[i].side != BoxSide::Unknown) continue;
        const std::size_t first = touches_.size();
        const auto root = static_cast<std::uint32_t>(solid_.nodes.size() - 1);
        if (node_ranges_[root].hi >= 0) find_touches(root, i);
        facts[i].graded = true;
        for (std::size_t t = first; t < touches_.size(); ++t) {
            const PartRange& part = range(touches_[t].part, i);
            facts[i].graded = facts[i].graded && part.continuous;
            facts[i].kinked = facts[i].kinked || part.kink;
        }
        if (!facts[i].graded) touches_.resize(first);
    }
    take_gradients(boxes, facts);
    for (std::size_t i = 0; i < count_; ++i) {
        if (!facts[i].graded) continue;
        for (std::size_t c = 0; c < solid_.cuts.size(); ++c) {
            const SolidCut& cut = solid_.cuts[c];
            if (range_of(cut, boxes[i]).second >= 0)
                facts[i].add(gradient_of(cut, boxes[i]), solid_.parts.size() + c);
        }
        facts[i].kinked = facts[i].kinked || facts[i].count > 1;
    }
}

void FieldOnBoxes::evaluate(std::span<const Box> boxes, std::span<BoxFacts> facts) {
    assert(boxes.size() == facts.size());
    for (std::size_t i = 0; i < boxes.size(); i += boxes_at_once) {
        const std::size_t count = std::min(boxes_at_once, boxes.size() - i);
        evaluate_some(boxes.subspan(i, count), facts.subspan(i, count));
    }
}

}  // namespace zeroset
