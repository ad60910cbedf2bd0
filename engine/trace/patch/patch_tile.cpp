#include "engine/trace/patch/patch_tile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
/// How much of a box its form stands for.
constexpr double inner = 1.0 / form_growth;
/// Leaves are so flat that two or three steps of Newton's method find a zero.
constexpr double flat_norm = 0.4;
/// Parts as small as this, in pixels, are leaves, whatever they are like.
constexpr double least_pixels = 5.0;
/// No part is divided further for many rays at once.
constexpr int most_levels = 14;
/// Nor where S is not continuous: such parts may be as many as there are along a line.
constexpr int most_levels_of_jumps = 4;
/// Krawczyk's test says enough below this.
constexpr double most_norm = 0.5;
constexpr std::size_t candidates_at_once = 512;
constexpr int most_steps = 4;
constexpr std::size_t tile_pixels = static_cast<std::size_t>(tile_size) * tile_size;

std::size_t index_of(int col, int row) { return static_cast<std::size_t>(row * tile_size + col); }

}  // namespace

bool is_beside(const PatchSight& sight, const SightAxes& axes, const RayBounds& bounds) {
    if (bounds.u_lo > bounds.u_hi) return true;
    const auto side = [&](double sign, int axis, double edge) {
        const double spread = std::abs(sight.kp[axis] - edge * sight.kp.z) +
                              std::abs(sight.kq[axis] - edge * sight.kq.z) + sight.e[axis] +
                              std::abs(edge) * sight.e.z;
        const double middle = sight.c[axis] - edge * axes.distance - edge * sight.c.z;
        return sign * middle > spread * (1.0 + 0x1p-40);
    };
    return side(-1.0, 0, bounds.u_lo) || side(1.0, 0, bounds.u_hi) || side(-1.0, 1, bounds.v_lo) ||
           side(1.0, 1, bounds.v_hi);
}

SightAxes axes_of(const TileRays& rays) {
    return {.right = rays.axes().right,
            .up = rays.axes().up,
            .forward = rays.axes().forward,
            .base = rays.base(),
            .distance = rays.distance(),
            .error = rays.depth_error()};
}

PatchTile::PatchTile(const TraceFrame& frame, const TileRays& rays, int cols, int rows, Wish wish,
                     Counters& counters, Room& room)
    : frame_(frame),
      rays_(rays),
      cols_(cols),
      rows_(rows),
      wish_(wish),
      counters_(counters),
      room_(room),
      axes_(axes_of(rays)),
      tree_(tree_of(frame)),
      clip_(tree_.within(frame.scene.clip)),
      search_(tree_, frame.limit, counters) {
    room_.leaves.clear();
    room_.candidates.clear();
    room_.rest.clear();
    room_.best.resize(tile_pixels);
    room_.is_set.assign(tile_pixels, 0);
    room_.reach = room_.to;
    find_bounds();
    const DepthRange range =
        rays_.depths(0.5 * (bounds_.u_lo + bounds_.u_hi), 0.5 * (bounds_.v_lo + bounds_.v_hi),
                     0.5 * (bounds_.u_hi - bounds_.u_lo), 0.5 * (bounds_.v_hi - bounds_.v_lo));
    depths_ = {.near = std::max(range.enter_lo, rays_.first_depth()), .far = range.exit_hi};
    limit_ = std::min(limit_, depths_.far);
}

void PatchTile::find_bounds() {
    constexpr RayBounds none{
        .u_lo = unbounded, .u_hi = -unbounded, .v_lo = unbounded, .v_hi = -unbounded};
    const auto widen = [](RayBounds& bounds, double u, double v) {
        bounds = {.u_lo = std::min(bounds.u_lo, u),
                  .u_hi = std::max(bounds.u_hi, u),
                  .v_lo = std::min(bounds.v_lo, v),
                  .v_hi = std::max(bounds.v_hi, v)};
    };
    bounds_ = none;
    blocks_.fill(none);
    for (int row = 0; row < rows_; ++row) {
        for (int col = 0; col < cols_; ++col) {
            const std::size_t pixel = index_of(col, row);
            if (room_.to[pixel] == -unbounded) continue;
            limit_ = std::max(limit_, room_.to[pixel]);
            const auto at =
                static_cast<std::size_t>(row / block * (tile_size / block) + col / block);
            if (wish_ == Wish::AnyHits) widen(blocks_[at], room_.u[pixel], room_.v[pixel]);
            widen(bounds_, room_.u[pixel], room_.v[pixel]);
        }
    }
}

void PatchTile::run() {
    if (!(depths_.near <= limit_)) return;
    visit(tree_.root());
    solve();
    search_rest();
}

PatchTile::Depths PatchTile::depths_of(const PatchForm& form) const {
    const double middle = glm::dot(axes_.forward, form.c - axes_.base);
    const double radius = glm::dot(glm::abs(axes_.forward), form.e) +
                          std::abs(glm::dot(axes_.forward, form.ku)) +
                          std::abs(glm::dot(axes_.forward, form.kv));
    if (!(radius < unbounded)) return {.near = -unbounded, .far = unbounded};
    const double spare = axes_.error + 0x1p-44 * (std::abs(middle) + radius);
    return {.near = middle - radius - spare, .far = middle + radius + spare};
}

bool PatchTile::is_hidden(const Depths& depths) const {
    return depths.near > limit_ || depths.far < depths_.near;
}

PatchTile::Rect PatchTile::pixels_of(const PatchSight& sight, const Depths& depths) const {
    const Rect all{.col = 0, .row = 0, .end_col = cols_, .end_row = rows_};
    const double near = axes_.distance + depths.near;
    const double far = axes_.distance + depths.far;
    if (wish_ == Wish::AnyHits || !(near > 0.0) || !(far < unbounded)) return all;
    const glm::dvec3 spread = sight.spread();
    const auto quotients = [&](double middle, double radius) {
        const double lo = middle - radius;
        const double hi = middle + radius;
        return std::pair(std::min(lo / near, lo / far), std::max(hi / near, hi / far));
    };
    const auto [u_lo, u_hi] = quotients(sight.c.x, spread.x);
    const auto [v_lo, v_hi] = quotients(sight.c.y, spread.y);
    // More than rounding may shift a ray.
    constexpr double spare = 0x1p-10;
    const auto pixel = [&](double pixels, int size) {
        return static_cast<int>(std::clamp(pixels, -1.0, static_cast<double>(size)));
    };
    const double per_pixel = 1.0 / rays_.pixel();
    return {.col = pixel(std::ceil((u_lo - rays_.u(0.0)) * per_pixel - spare), cols_),
            .row = pixel(std::ceil((rays_.v(0.0) - v_hi) * per_pixel - spare), rows_),
            .end_col = pixel(std::floor((u_hi - rays_.u(0.0)) * per_pixel + spare) + 1.0, cols_),
            .end_row = pixel(std::floor((rays_.v(0.0) - v_lo) * per_pixel + spare) + 1.0, rows_)};
}

bool PatchTile::is_leaf(const PatchNode& node, const PatchSight& sight, const Rect& rect) const {
    if (node.level >= (node.form.continuous ? most_levels : most_levels_of_jumps)) return true;
    const glm::dvec3 spread = sight.spread();
    const double pixel = pixel_at(sight.c.z);
    if (2.0 * std::max(spread.x, spread.y) < least_pixels * pixel) return true;
    if (!node.form.continuous) return false;
    return contraction_of(sight, rays_of(rect)).norm <= flat_norm;
}

SightRays PatchTile::rays_of(const Rect& rect) const {
    if (wish_ == Wish::AnyHits) {
        return {.middle = {.u = 0.5 * (bounds_.u_lo + bounds_.u_hi),
                           .v = 0.5 * (bounds_.v_lo + bounds_.v_hi)},
                .u_radius = 0.5 * (bounds_.u_hi - bounds_.u_lo),
                .v_radius = 0.5 * (bounds_.v_hi - bounds_.v_lo)};
    }
    const double col = 0.5 * (rect.col + rect.end_col - 1);
    const double row = 0.5 * (rect.row + rect.end_row - 1);
    // Half a pixel more than where rays are.
    return {.middle = {.u = rays_.u(col), .v = rays_.v(row)},
            .u_radius = 0.5 * (rect.end_col - rect.col) * rays_.pixel(),
            .v_radius = 0.5 * (rect.end_row - rect.row) * rays_.pixel()};
}

void PatchTile::visit(PatchNode& node) {
    if (frame_.stopped()) return;
    const auto form = form_within(node.form, clip_);
    if (!form) return;
    const Depths depths = depths_of(*form);
    if (is_hidden(depths)) return;
    const PatchSight sight = sight_of(*form, axes_);
    if (is_beside(sight, axes_, bounds_)) return;
    Rect rect = pixels_of(sight, depths);
    rect.col = std::max(rect.col, 0);
    rect.row = std::max(rect.row, 0);
    if (rect.empty()) return;
    if (!is_leaf(node, sight, rect)) {
        const bool is_new = node.children.load(std::memory_order_acquire) == nullptr;
        if (PatchNode::Children* const parts = tree_.parts(node)) {
            if (is_new) counters_.form += parts->nodes.size();
            return visit_parts(*parts);
        }
    }
    scan(node, sight, rect, depths.near);
}

void PatchTile::visit_parts(PatchNode::Children& parts) {
    std::array<std::pair<double, PatchNode*>, PatchForms::at_once> order;
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = {glm::dot(axes_.forward, parts.nodes[i].form.c), &parts.nodes[i]};
    std::ranges::sort(order, {}, &std::pair<double, PatchNode*>::first);
    for (const auto& [near, node] : order)
        visit(*node);
}

void PatchTile::scan(PatchNode& node, const PatchSight& sight, const Rect& rect, double near) {
    const std::size_t leaf = room_.leaves.size();
    room_.leaves.push_back(
        {.node = &node, .sight = sight, .contraction = contraction_of(sight, rays_of(rect))});
    if (wish_ == Wish::FirstHits) {
        scan_rect(leaf, rect, near);
    } else {
        scan_blocks(leaf, near);
    }
    if (room_.candidates.size() >= candidates_at_once) solve();
}

void PatchTile::scan_rect(std::size_t leaf, const Rect& rect, double near) {
    for (int row = rect.row; row < rect.end_row; ++row) {
        for (int col = rect.col; col < rect.end_col; ++col)
            scan_pixel(index_of(col, row), leaf, near);
    }
}

void PatchTile::scan_blocks(std::size_t leaf, double near) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (is_beside(room_.leaves[leaf].sight, axes_, blocks_[i])) continue;
        const int col = static_cast<int>(i) % (tile_size / block) * block;
        const int row = static_cast<int>(i) / (tile_size / block) * block;
        scan_rect(leaf,
                  {.col = col,
                   .row = row,
                   .end_col = std::min(col + block, cols_),
                   .end_row = std::min(row + block, rows_)},
                  near);
    }
}

void PatchTile::scan_pixel(std::size_t pixel, std::size_t leaf, double near) {
    if (near > room_.reach[pixel]) return;
    const auto& [node, sight, contraction] = room_.leaves[leaf];
    const SightRay ray = ray_of(pixel);
    const LinearZeros zeros = linear_zeros(sight, axes_, ray);
    if (!zeros.any || zeros.beyond(inner)) return;
    if (node->form.continuous && zeros.known && contraction.norm < most_norm) {
        room_.candidates.push_back(
            {.pixel = pixel,
             .leaf = leaf,
             .place = {.p = std::clamp(zeros.p, -1.0, 1.0), .q = std::clamp(zeros.q, -1.0, 1.0)}});
        return;
    }
    room_.rest.push_back({.pixel = pixel, .node = node, .near = near});
}

void PatchTile::solve() {
    for (int step = 1; step <= most_steps && !room_.candidates.empty(); ++step)
        advance(step == most_steps);
    for (const Candidate& candidate : room_.candidates) {
        PatchNode* const node = room_.leaves[candidate.leaf].node;
        room_.rest.push_back(
            {.pixel = candidate.pixel, .node = node, .near = depths_of(node->form).near});
    }
    room_.candidates.clear();
    room_.leaves.clear();
    double farthest = -unbounded;
    for (int row = 0; row < rows_; ++row) {
        for (int col = 0; col < cols_; ++col)
            farthest = std::max(farthest, room_.reach[index_of(col, row)]);
    }
    limit_ = std::min(limit_, farthest);
}

void PatchTile::advance(bool is_last) {
    const std::size_t count = room_.candidates.size();
    room_.places.resize(count);
    room_.points.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Candidate& candidate = room_.candidates[i];
        const UvBox place = place_in(room_.leaves[candidate.leaf].node->box, candidate.place.p,
                                     candidate.place.q, 0.0);
        room_.places[i] = {place.u, place.v};
    }
    tree_.forms().evaluate(room_.places, room_.points);
    counters_.value += count;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Candidate candidate = room_.candidates[i];
        const Leaf& leaf = room_.leaves[candidate.leaf];
        const PatchPoint& point = room_.points[i];
        const SightRay ray = ray_of(candidate.pixel);
        const glm::dvec3 at = axes_.place(point.s);
        const ZeroTest test = zero_test(leaf.sight, axes_, ray, leaf.contraction, at,
                                        candidate.place.p, candidate.place.q, inner);
        if (settle(candidate, test, point, is_last)) continue;
        const UvBox& box = leaf.node->box;
        candidate.place =
            newton_place(test, axes_, ray, at, form_growth * box.u_radius * axes_.turned(point.su),
                         form_growth * box.v_radius * axes_.turned(point.sv), candidate.place);
        room_.candidates[kept++] = candidate;
    }
    room_.candidates.resize(kept);
}

bool PatchTile::settle(const Candidate& candidate, const ZeroTest& test, const PatchPoint& point,
                       bool is_last) {
    if (test.found == ZeroTest::Found::None) return true;
    const PatchHit& best = room_.hit(candidate.pixel);
    if (test.s - test.s_radius > best.s) return true;
    if (test.found != ZeroTest::Found::One || !(2.0 * test.s_radius <= rays_.tolerance()))
        return false;
    const UvBox& box = room_.leaves[candidate.leaf].node->box;
    const PatchForm& form = room_.leaves[candidate.leaf].node->form;
    const InSquare where = both(in_square(place_in(box, test.p, test.q, test.radius)),
                                in_own_box(tree_, form, test, candidate.place, point));
    if (where == InSquare::Outside) return true;
    if (where == InSquare::Unknown && !is_last) return false;
    if (!(test.s < best.s)) return true;
    const SightRay ray = ray_of(candidate.pixel);
    const DepthRange range = rays_.depths(ray.u, ray.v, 0.0, 0.0);
    if (test.s < range.enter_lo || test.s > std::min(range.exit_hi, room_.to[candidate.pixel]) ||
        test.s < rays_.first_depth())
        return true;
    room_.set(candidate.pixel, {.s = test.s,
                                .s_radius = test.s_radius,
                                .is_proved = where == InSquare::Inside,
                                .normal = glm::cross(point.su, point.sv),
                                .unsettled = best.unsettled});
    if (wish_ == Wish::AnyHits && where == InSquare::Inside) {
        room_.to[candidate.pixel] = -unbounded;
        room_.reach[candidate.pixel] = -unbounded;
    }
    return true;
}

void PatchTile::search_rest() {
    std::ranges::sort(room_.rest, {}, &Rest::near);
    for (const Rest& rest : room_.rest) {
        if (frame_.stopped()) return;
        if (rest.near > room_.reach[rest.pixel]) continue;
        const SightRay ray = ray_of(rest.pixel);
        const DepthRange range = rays_.depths(ray.u, ray.v, 0.0, 0.0);
        const PatchQuest quest{.axes = axes_,
                               .ray = ray,
                               .from = std::max(range.enter_lo, rays_.first_depth()),
                               .to = std::min(range.exit_hi, room_.to[rest.pixel]),
                               .tolerance = rays_.tolerance(),
                               .pixel = 0.5 * pixel_at(rest.near),
                               .clip = clip_,
                               .any = wish_ == Wish::AnyHits};
        if (!(quest.from <= quest.to)) continue;
        room_.set(rest.pixel, search_.search(quest, *rest.node, room_.hit(rest.pixel)));
    }
}

}  // namespace zeroset
