#include "engine/trace/patch/patch_search.hpp"

#include "engine/trace/patch/seen_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// The most divisions into sixteen boxes for a ray; one that needs more is undecided.
constexpr int most_divisions = 600;
/// Boxes are not divided further below this: there are few doubles in them.
constexpr double least_radius = 0x1p-46;
/// Boxes where S is not continuous are not divided below this: they have nothing to certify.
constexpr double least_of_jumps = 0x1p-30;

/// The part of [-box_share, box_share] in which zeros may be, as middle and radius.
struct Share {
    double middle, radius;
};

Share part_of(double middle, double radius) {
    const double lo = std::max(-box_share, middle - radius);
    const double hi = std::min(box_share, middle + radius);
    return {.middle = 0.5 * lo + 0.5 * hi, .radius = std::max(0.5 * hi - 0.5 * lo, 0x1p-52)};
}

}  // namespace

InSquare in_square(const UvBox& box) {
    const auto inside = [](double middle, double radius) {
        return middle - radius >= 0.0 && middle + radius <= 1.0;
    };
    const auto outside = [](double middle, double radius) {
        return middle + radius < 0.0 || middle - radius > 1.0;
    };
    if (outside(box.u, box.u_radius) || outside(box.v, box.v_radius)) return InSquare::Outside;
    return inside(box.u, box.u_radius) && inside(box.v, box.v_radius) ? InSquare::Inside
                                                                      : InSquare::Unknown;
}

InSquare in_box(const Box& box, const glm::dvec3& at, const glm::dvec3& error) {
    const auto below = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::all(glm::lessThanEqual(a, b));
    };
    if (below(box.lo + error, at) && below(at, box.hi - error)) return InSquare::Inside;
    const bool may_be = below(box.lo - error, at) && below(at, box.hi + error);
    return may_be ? InSquare::Unknown : InSquare::Outside;
}

InSquare in_own_box(const PatchTree& tree, const PatchForm& form, const ZeroTest& test,
                    const BoxPlace& at, const PatchPoint& point) {
    if (!tree.box()) return InSquare::Inside;
    const double by_p = std::abs(test.p - at.p) + test.radius;
    const double by_q = std::abs(test.q - at.q) + test.radius;
    const glm::dvec3 moved =
        by_p * (glm::abs(form.du) + form.du_radius) + by_q * (glm::abs(form.dv) + form.dv_radius);
    const glm::dvec3 error = moved * (1.0 + 0x1p-40) + form.value_error;
    return in_box(*tree.box(), point.s, error);
}

InSquare both(InSquare a, InSquare b) {
    if (a == InSquare::Outside || b == InSquare::Outside) return InSquare::Outside;
    return a == InSquare::Inside ? b : a;
}

UvBox place_in(const UvBox& box, double p, double q, double radius) {
    const double u_radius = form_growth * box.u_radius;
    const double v_radius = form_growth * box.v_radius;
    return {.u = box.u + p * u_radius,
            .v = box.v + q * v_radius,
            .u_radius = radius * u_radius + 0x1p-52,
            .v_radius = radius * v_radius + 0x1p-52};
}

void PatchSearch::push(const PatchQuest& quest, const UvBox& box, const PatchForm& whole,
                       PatchNode* node) {
    const FormWithin within(whole, quest.clip);
    if (!within) return;
    const PatchSight sight = place_of(*within, quest.axes);
    const SightDepths depths = sight.depths();
    const double near = std::max(depths.near, quest.from);
    if (near >= std::min(best_.s, quest.to) || depths.far < quest.from) return;
    open_.push_back({.box = box, .form = *within, .sight = sight, .node = node, .near = near});
}

/// Takes in those of a node's parts that the ray may meet: it misses most of them.
void PatchSearch::push_parts(const PatchQuest& quest, PatchNode::Children& parts) {
    const RayBounds alone{
        .u_lo = quest.ray.u, .u_hi = quest.ray.u, .v_lo = quest.ray.v, .v_hi = quest.ray.v};
    const PartWindow window{.axes = quest.axes,
                            .rays = alone,
                            .clip = quest.clip,
                            .depths = {.near = quest.from, .far = std::min(best_.s, quest.to)}};
    SeenParts seen;
    const std::uint32_t known = parts.forms.known;
    const std::uint32_t met = see_parts(parts.forms, window, seen) | ~known;
    for (std::size_t i = 0; i < parts.nodes.size(); ++i) {
        PatchNode& part = parts.nodes[i];
        if ((met >> i & 1U) == 0) continue;
        if ((known >> i & 1U) == 0) {
            push(quest, part.box, part.form, &part);
            continue;
        }
        const PatchSight sight = seen.sight(i);
        const LinearZeros zeros = linear_zeros(sight, quest.axes, quest.ray);
        if (!zeros.any || zeros.beyond(box_share)) continue;
        open_.push_back({.box = part.box,
                         .form = part.form,
                         .sight = sight,
                         .node = &part,
                         .near = std::max(sight.depths().near, quest.from)});
    }
}

void PatchSearch::take(const PatchQuest& quest, const ZeroTest& test, InSquare where,
                       const PatchPoint& point) {
    if (where == InSquare::Outside) return;
    if (test.s < quest.from || test.s > quest.to || !(test.s < best_.s)) return;
    best_.s = test.s;
    best_.s_radius = test.s_radius;
    best_.is_proved = where == InSquare::Inside;
    best_.normal = glm::cross(point.su, point.sv);
}

PatchPoint PatchSearch::evaluate(const Item& item, double p, double q) {
    ++counters_.value;
    if (item.node != nullptr && item.node->model != nullptr)
        return value_of(*item.node->model, p, q);
    const UvBox place = place_in(item.box, p, q, 0.0);
    const std::array<glm::dvec2, 1> places{glm::dvec2(place.u, place.v)};
    std::array<PatchPoint, 1> points;
    tree_.forms().evaluate(places, points);
    points[0].su *= form_growth * item.box.u_radius;
    points[0].sv *= form_growth * item.box.v_radius;
    return points[0];
}

PatchSearch::Outcome PatchSearch::certify(const PatchQuest& quest, const Item& item,
                                          const PatchSight& sight, const LinearZeros& zeros) {
    constexpr double most_norm = 0.5;
    constexpr int most_steps = 6;
    if (!item.form.continuous || !zeros.known) return Outcome::Open;
    // A hit cannot be narrower than what is evaluated.
    if (sight.value_error > quest.tolerance) return Outcome::Open;
    // Go on only where Krawczyk's test contracts.
    const Contraction contraction = contraction_of(sight, {.middle = quest.ray});
    if (!(contraction.norm < most_norm)) return Outcome::Open;
    double p = std::clamp(zeros.p, -1.0, 1.0);
    double q = std::clamp(zeros.q, -1.0, 1.0);
    for (int step = 0; step < most_steps; ++step) {
        // Test the box by an evaluation at (p, q).
        const PatchPoint point = evaluate(item, p, q);
        const glm::dvec3 at = quest.axes.place(point.s);
        const ZeroTest test =
            zero_test(sight, quest.axes, quest.ray, contraction, at, p, q, box_share);
        if (test.found == ZeroTest::Found::None) return Outcome::Done;
        const bool is_last = step + 1 == most_steps;
        // Take a narrow hit once it is known to be inside or outside, or at last.
        if (test.found == ZeroTest::Found::One && 2.0 * test.s_radius <= quest.tolerance) {
            const InSquare where =
                both(in_square(place_in(item.box, test.p, test.q, test.radius)),
                     in_own_box(tree_, item.form, test, {.p = p, .q = q}, point));
            if (where != InSquare::Unknown || is_last) {
                take(quest, test, where, point);
                return Outcome::Done;
            }
        }
        const BoxPlace next =
            newton_place(test, quest.axes, quest.ray, at, quest.axes.turned(point.su),
                         quest.axes.turned(point.sv), {.p = p, .q = q});
        p = next.p;
        q = next.q;
    }
    return Outcome::Open;
}

void PatchSearch::give_up(const PatchQuest& quest, const Item& item) {
    if (!item.form.continuous) {
        best_.unsettled = std::min(best_.unsettled, item.near);
        return;
    }
    const double s = item.sight.c.z;
    const double at = std::clamp(s, item.near, std::max(item.near, quest.to));
    if (!(at < best_.s) || !std::isfinite(at)) return;
    best_.s = at;
    best_.s_radius = item.sight.spread().z;
    best_.is_proved = false;
    best_.normal = glm::cross(item.form.du, item.form.dv);
}

void PatchSearch::divide(const PatchQuest& quest, const Item& item, const PatchSight& sight,
                         const LinearZeros& zeros) {
    // Use the tree's parts; it makes new ones for boxes larger than a pixel.
    if (item.node != nullptr) {
        const glm::dvec3 spread = sight.spread();
        const bool keeps = std::max(spread.x, spread.y) > quest.pixel;
        PatchNode::Children* const parts =
            keeps ? tree_.parts(*item.node) : item.node->children.load(std::memory_order_acquire);
        if (parts != nullptr) return push_parts(quest, *parts);
    }
    // Else divide the share of the box in which zeros may be.
    const Share p = zeros.known ? part_of(zeros.p, zeros.p_radius) : part_of(0.0, box_share);
    const Share q = zeros.known ? part_of(zeros.q, zeros.q_radius) : part_of(0.0, box_share);
    const UvBox whole = place_in(item.box, p.middle, q.middle, 0.0);
    const Division division = division_of(p.radius * glm::length(sight.kp + sight.dp),
                                          q.radius * glm::length(sight.kq + sight.dq));
    const double u_radius = p.radius * form_growth * item.box.u_radius;
    const double v_radius = q.radius * form_growth * item.box.v_radius;
    // Wider by more than what rounding may take from them.
    const double part_u = u_radius / static_cast<double>(division.cols) * (1.0 + 0x1p-20) + 0x1p-52;
    const double part_v = v_radius / static_cast<double>(division.rows) * (1.0 + 0x1p-20) + 0x1p-52;
    PatchForms::Boxes boxes{};
    PatchForms::Boxes grown{};
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto along = [&](std::size_t at, std::size_t count) {
            return (2.0 * static_cast<double>(at) + 1.0) / static_cast<double>(count) - 1.0;
        };
        boxes[i] = {.u = whole.u + along(i % division.cols, division.cols) * u_radius,
                    .v = whole.v + along(i / division.cols, division.rows) * v_radius,
                    .u_radius = part_u,
                    .v_radius = part_v};
        grown[i] = boxes[i].grown(form_growth);
    }
    // Evaluate the parts' forms, and take in the parts that the ray may meet.
    PatchForms::Forms forms;
    tree_.forms().evaluate(grown, forms);
    counters_.form += boxes.size();
    for (std::size_t i = 0; i < boxes.size(); ++i)
        push(quest, boxes[i], forms[i], nullptr);
}

PatchHit PatchSearch::search(const PatchQuest& quest, PatchNode& node, const PatchHit& known) {
    open_.clear();
    best_ = known;
    push(quest, node.box, node.form, &node);
    int divisions = 0;
    while (!open_.empty() && !limit_.over()) {
        const auto first = std::ranges::min_element(open_, {}, &Item::near);
        Item item = *first;
        *first = open_.back();
        open_.pop_back();
        if (item.near >= best_.s) break;
        if (quest.any && best_.is_hit() && best_.is_proved) break;
        const PatchSight& sight = item.sight;
        // Reject the box by its linear form, or certify what it holds.
        const LinearZeros zeros = linear_zeros(sight, quest.axes, quest.ray);
        if (!zeros.any || zeros.beyond(box_share)) continue;
        add_slopes(item.sight, item.form, quest.axes);
        add_value_error(item.sight, item.form);
        if (certify(quest, item, sight, zeros) == Outcome::Done) continue;
        // Give up on a box that is too small; divide others.
        const glm::dvec3 spread = sight.spread();
        const double least = item.form.continuous ? least_radius : least_of_jumps;
        const bool is_small = 4.0 * std::max({spread.x, spread.y, spread.z}) <= quest.tolerance ||
                              std::max(item.box.u_radius, item.box.v_radius) < least;
        if (is_small || ++divisions > most_divisions) {
            give_up(quest, item);
            continue;
        }
        divide(quest, item, sight, zeros);
    }
    if (limit_.over()) best_.unsettled = std::min(best_.unsettled, quest.from);
    return best_;
}

}  // namespace zeroset
