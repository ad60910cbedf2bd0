#include "engine/trace/patch/patch_tile.hpp"

#include <algorithm>
#include <cstdint>

// The parts of a patch that are known by forms alone: hits by evaluating S itself.

namespace zeroset {
namespace {

/// Krawczyk's test says enough below this.
constexpr double most_norm = 0.5;
constexpr std::size_t candidates_at_once = 512;
constexpr int most_steps = 4;

}  // namespace

void PatchTile::scan(const SeenNode& part, const Rect& rect) {
    const std::size_t leaf = scratch_.leaves.size();
    scratch_.leaves.push_back({.node = part.node,
                               .sight = part.sight,
                               .contraction = contraction_of(part.sight, rays_of(rect))});
    for_each_rect(part.sight, rect,
                  [&](const Rect& some) { scan_rect(leaf, some, part.depths.near); });
    if (scratch_.candidates.size() >= candidates_at_once) solve();
}

void PatchTile::leave_jump(const SeenNode& part, const Rect& rect) {
    if (scratch_.jumps.empty()) scratch_.jumps.resize(tile_pixels);
    const glm::dvec3 spread = part.sight.spread();
    const bool is_spot = 2.0 * std::max({spread.x, spread.y, spread.z}) < pixel_at(part.sight.c.z);
    const double near = std::max(part.depths.near, depths_.near);
    const auto leave = [&](std::size_t pixel) {
        const LinearZeros zeros = linear_zeros(part.sight, axes_, ray_of(pixel));
        if (near > answer_.reach(pixel) || !zeros.any || zeros.beyond(box_share)) return;
        Jump& jump = scratch_.jumps[pixel];
        if (!is_spot) {
            jump.unsettled = std::min(jump.unsettled, near);
        } else if (part.sight.c.z < jump.s) {
            jump.s = std::max(part.sight.c.z, near);
            jump.s_radius = spread.z;
        }
    };
    for_each_rect(part.sight, rect, [&](const Rect& some) {
        for (int row = some.row; row < some.end_row; ++row) {
            for (int col = some.col; col < some.end_col; ++col)
                leave(pixel_index(col, row));
        }
    });
}

void PatchTile::put_jumps() {
    for (std::size_t pixel = 0; pixel < scratch_.jumps.size(); ++pixel) {
        const Jump& jump = scratch_.jumps[pixel];
        PatchHit hit = answer_.hit(pixel);
        const double reach = answer_.reach(pixel);
        if (std::min(jump.s, jump.unsettled) >= reach) continue;
        if (jump.s < reach)
            hit = {.s = jump.s, .s_radius = jump.s_radius, .unsettled = hit.unsettled};
        hit.unsettled = std::min(hit.unsettled, jump.unsettled);
        answer_.set(pixel, hit);
    }
    scratch_.jumps.clear();
}

void PatchTile::scan_rect(std::size_t leaf, const Rect& rect, double near) {
    for (int row = rect.row; row < rect.end_row; ++row) {
        for (int col = rect.col; col < rect.end_col; ++col)
            scan_pixel(pixel_index(col, row), leaf, near);
    }
}

void PatchTile::scan_pixel(std::size_t pixel, std::size_t leaf, double near) {
    if (near > answer_.reach(pixel)) return;
    const auto& [node, sight, contraction] = scratch_.leaves[leaf];
    const SightRay ray = ray_of(pixel);
    const LinearZeros zeros = linear_zeros(sight, axes_, ray);
    if (!zeros.any || zeros.beyond(box_share)) return;
    const bool may_solve = node->model == nullptr && node->form.continuous;
    if (may_solve && zeros.known && contraction.norm < most_norm) {
        scratch_.candidates.push_back(
            {.pixel = pixel,
             .leaf = leaf,
             .place = {.p = std::clamp(zeros.p, -1.0, 1.0), .q = std::clamp(zeros.q, -1.0, 1.0)}});
        return;
    }
    keep({.pixel = pixel, .node = node, .near = near});
}

void PatchTile::solve() {
    if (scratch_.candidates.empty()) return;
    for (int step = 1; step <= most_steps && !scratch_.candidates.empty(); ++step)
        advance(step == most_steps);
    for (const Candidate& candidate : scratch_.candidates) {
        const Leaf& leaf = scratch_.leaves[candidate.leaf];
        keep({.pixel = candidate.pixel, .node = leaf.node, .near = leaf.sight.depths().near});
    }
    scratch_.candidates.clear();
    scratch_.leaves.clear();
    find_limit();
}

void PatchTile::advance(bool is_last) {
    const std::size_t count = scratch_.candidates.size();
    scratch_.places.resize(count);
    scratch_.points.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Candidate& candidate = scratch_.candidates[i];
        const UvBox place = place_in(scratch_.leaves[candidate.leaf].node->box, candidate.place.p,
                                     candidate.place.q, 0.0);
        scratch_.places[i] = {place.u, place.v};
    }
    tree_.forms().evaluate(scratch_.places, scratch_.points);
    counters_.value += count;
    // Settle candidates, or move them on by Newton's method.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Candidate candidate = scratch_.candidates[i];
        const Leaf& leaf = scratch_.leaves[candidate.leaf];
        const PatchPoint& point = scratch_.points[i];
        const SightRay ray = ray_of(candidate.pixel);
        const glm::dvec3 at = axes_.place(point.s);
        const ZeroTest test = zero_test(leaf.sight, axes_, ray, leaf.contraction, at,
                                        candidate.place.p, candidate.place.q, box_share);
        if (settle(candidate, test, point, is_last)) continue;
        const UvBox& box = leaf.node->box;
        candidate.place =
            newton_place(test, axes_, ray, at, form_growth * box.u_radius * axes_.turned(point.su),
                         form_growth * box.v_radius * axes_.turned(point.sv), candidate.place);
        scratch_.candidates[kept++] = candidate;
    }
    scratch_.candidates.resize(kept);
}

bool PatchTile::settle(const Candidate& candidate, const ZeroTest& test, const PatchPoint& point,
                       bool is_last) {
    if (test.found == ZeroTest::Found::None) return true;
    const PatchHit best = answer_.hit(candidate.pixel);
    if (test.s - test.s_radius > best.s) return true;
    if (test.found != ZeroTest::Found::One || !(2.0 * test.s_radius <= rays_.tolerance()))
        return false;
    // Test whether the zero is in the ranges and in the patch's own box.
    const UvBox& box = scratch_.leaves[candidate.leaf].node->box;
    const PatchForm& form = scratch_.leaves[candidate.leaf].node->form;
    const InSquare where = both(in_square(place_in(box, test.p, test.q, test.radius)),
                                in_own_box(tree_, form, test, candidate.place, point));
    if (where == InSquare::Outside) return true;
    if (where == InSquare::Unknown && !is_last) return false;
    if (!(test.s < best.s)) return true;
    const SightRay ray = ray_of(candidate.pixel);
    // Drop a hit outside of what is wanted on the ray.
    const DepthRange range = rays_.depths(ray.u, ray.v, 0.0, 0.0);
    if (test.s < range.enter_lo ||
        test.s > std::min(range.exit_hi, answer_.limit(candidate.pixel)) ||
        test.s < rays_.first_depth())
        return true;
    change_all();
    answer_.set(candidate.pixel, {.s = test.s,
                                  .s_radius = test.s_radius,
                                  .is_proved = where == InSquare::Inside,
                                  .normal = glm::cross(point.su, point.sv),
                                  .unsettled = best.unsettled});
    if (quest_.wish == Wish::AnyHits && where == InSquare::Inside) {
        answer_.close(candidate.pixel);
    }
    return true;
}

}  // namespace zeroset
