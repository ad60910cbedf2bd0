#include "engine/trace/patch/patch_tile.hpp"

#include "engine/real/unbounded.hpp"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

namespace zeroset {
namespace {

/// Leaves are so flat that two or three steps of Newton's method find a zero.
constexpr double leaf_norm = 0.4;
/// Leaves with a model need not be flatter than this: trace_leaf halves them.
constexpr double model_norm = 1.0;
/// Leaves with a model below large_pixels need not be flatter than this: larger ones are halved
/// again in each tile.
constexpr double small_model_norm = 2.0;
constexpr double large_pixels = 64.0;
/// Parts with a model that are as small as this, in pixels, are leaves.
constexpr double small_pixels = 16.0;
/// Parts as small as this, in pixels, are leaves, whatever they are like.
constexpr double least_pixels = 5.0;
/// Parts beside a jump or an edge without a slope are divided down to this, in pixels, or until
/// they are thin and no longer than this in the unit square.
constexpr double least_pixels_of_jumps = 0x1p-4;
constexpr double shortest_jump = 0x1p-6;
/// The deepest level where S is not continuous and not bounded: such parts may be as many as fit
/// along a line.
constexpr int most_levels_of_jumps = 4;
/// The most parts and pixels that are kept for the end; on a patch that is undefined everywhere,
/// but not proved to be, each part may be at each pixel.
constexpr std::size_t most_rest = std::size_t{1} << 18U;

/// Says early that a node is going to be read.
void fetch(const PatchNode& node) {
    constexpr std::size_t line = 64;
    const auto* const bytes = reinterpret_cast<const std::byte*>(&node);
    for (std::size_t i = 0; i < sizeof(PatchNode); i += line)
        hwy::Prefetch(bytes + i);
}

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

PatchTile::Scratch& PatchTile::kept_scratch() {
    thread_local Scratch scratch;
    return scratch;
}

PatchTile::PatchTile(const TraceFrame& frame, const TileRays& rays, const TileQuest& quest,
                     TileAnswer& answer, Counters& counters)
    : frame_(frame),
      rays_(rays),
      quest_(quest),
      answer_(answer),
      counters_(counters),
      scratch_(kept_scratch()),
      axes_(axes_of(rays)),
      grid_{.u = rays.u(0.0), .v = rays.v(0.0), .pixel = rays.pixel()},
      tree_(tree_of(frame)),
      clip_(tree_.within(frame.scene.clip)),
      search_(tree_, frame.limit, counters) {
    scratch_.leaves.clear();
    scratch_.candidates.clear();
    scratch_.rest.clear();
    scratch_.jumps.clear();
    answer_.begin(quest_);
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
    // Bound the rays through the pixels' centres by the tile.
    if (quest_.wish == Wish::FirstHits) {
        bounds_ = {.u_lo = rays_.u(0.0),
                   .u_hi = rays_.u(quest_.cols - 1),
                   .v_lo = rays_.v(quest_.rows - 1),
                   .v_hi = rays_.v(0.0)};
        if (quest_.to.empty()) open_blocks();
        find_reaches();
        limit_ = *std::ranges::max_element(block_reach_);
        return;
    }
    // Bound rays that are anywhere by those wanted, block by block.
    blocks_.fill(none);
    for (int row = 0; row < quest_.rows; ++row) {
        for (int col = 0; col < quest_.cols; ++col) {
            const std::size_t pixel = pixel_index(col, row);
            if (quest_.to[pixel] == -unbounded) continue;
            limit_ = std::max(limit_, quest_.to[pixel]);
            const auto at =
                static_cast<std::size_t>(row / block * (tile_size / block) + col / block);
            widen(blocks_[at], quest_.u[pixel], quest_.v[pixel]);
            widen(bounds_, quest_.u[pixel], quest_.v[pixel]);
        }
    }
}

void PatchTile::open_blocks() {
    changed_blocks_ = 0;
    block_reach_.fill(-unbounded);
    for (int row = 0; row * block < quest_.rows; ++row) {
        for (int col = 0; col * block < quest_.cols; ++col)
            block_reach_[static_cast<std::size_t>(row * (tile_size / block) + col)] = unbounded;
    }
}

void PatchTile::run() {
    if (!(depths_.near <= limit_)) return;
    if (SeenNode root; see(tree_.root(), root)) visit(root);
    solve();
    search_rest();
    put_jumps();
}

bool PatchTile::is_hidden(const SightDepths& depths) const {
    return depths.near > limit_ || depths.far < depths_.near;
}

void PatchTile::find_reaches() {
    find_largest(answer_.reaches(), changed_blocks_, block_reach_);
    changed_blocks_ = 0;
}

bool PatchTile::is_covered(const Rect& rect, double near) {
    find_reaches();
    for (int row = rect.row / block; row * block < rect.end_row; ++row) {
        for (int col = rect.col / block; col * block < rect.end_col; ++col) {
            if (near <= block_reach_[static_cast<std::size_t>(row * (tile_size / block) + col)])
                return false;
        }
    }
    return true;
}

PatchTile::Rect PatchTile::pixels_of(const PatchOutline* outline) const {
    const Rect all{.col = 0, .row = 0, .end_col = quest_.cols, .end_row = quest_.rows};
    return outline == nullptr ? all : outline->within(all);
}

PatchTile::Refinement PatchTile::refinement_of(const SeenNode& part, const Rect& rect) const {
    const auto& [node, depths, sight] = part;
    const bool is_jump = node->form.is_bounded_jump();
    const bool may_shrink = node->form.continuous || is_jump;
    if (node->level >= (may_shrink ? most_levels : most_levels_of_jumps)) return Refinement::None;
    const glm::dvec3 spread = sight.spread();
    const double pixels = 2.0 * std::max(spread.x, spread.y) / pixel_at(sight.c.z);
    if (pixels < (is_jump ? least_pixels_of_jumps : least_pixels)) return Refinement::None;
    if (is_jump && is_thin(node->box) &&
        std::max(node->box.u_radius, node->box.v_radius) < shortest_jump)
        return Refinement::None;
    if (!node->form.continuous || !is_fine(*node, sight)) return Refinement::Parts;
    if (node->model != nullptr && pixels < small_pixels) return Refinement::None;
    PatchSight with_slopes = sight;
    add_slopes(with_slopes, node->form, axes_);
    const double norm = contraction_of(with_slopes, rays_of(rect)).norm;
    if (node->model == nullptr) return norm <= leaf_norm ? Refinement::None : Refinement::Parts;
    const auto most = [](double size) {
        return size < large_pixels ? small_model_norm : model_norm;
    };
    if (norm <= most(pixels)) return Refinement::None;
    // Quarters bend half as much.
    return norm <= 2.0 * most(0.5 * pixels) ? Refinement::Quarters : Refinement::Parts;
}

PatchNode::Children* PatchTile::divided(PatchNode& node, Refinement refinement) {
    if (refinement == Refinement::None) return nullptr;
    const auto count_new = [&](const std::atomic<PatchNode::Children*>& at, auto make) {
        const bool is_new = at.load(std::memory_order_acquire) == nullptr;
        PatchNode::Children* const parts = make();
        if (is_new && parts != nullptr) counters_.form += parts->nodes.size();
        return parts;
    };
    if (refinement == Refinement::Quarters) {
        if (auto* const quarters = count_new(node.quarters, [&] { return tree_.quarters(node); }))
            return quarters;
    }
    return count_new(node.children, [&] { return tree_.parts(node); });
}

SightRays PatchTile::rays_of(const Rect& rect) const {
    if (quest_.wish == Wish::AnyHits) {
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

bool PatchTile::see(PatchNode& node, SeenNode& part) const {
    const FormWithin form(node.form, clip_);
    if (!form) return false;
    part.node = &node;
    part.sight = place_of(*form, axes_);
    part.depths = part.sight.depths();
    return !is_hidden(part.depths) && !is_beside(part.sight, axes_, bounds_);
}

void PatchTile::visit(SeenNode& part) {
    if (frame_.stopped() || is_hidden(part.depths)) return;
    if (scratch_.rest.size() >= most_rest) empty_rest();
    PatchNode& node = *part.node;
    std::optional<PatchOutline> outline;
    if (quest_.wish == Wish::FirstHits)
        outline.emplace(without_growth(part.sight), axes_.distance, grid_);
    const PatchOutline* const seen = outline ? &*outline : nullptr;
    const Rect rect = pixels_of(seen);
    if (rect.empty() || (quest_.wish == Wish::FirstHits && is_covered(rect, part.depths.near)))
        return;
    add_value_error(part.sight, node.form);
    if (PatchNode::Children* const parts = divided(node, refinement_of(part, rect)))
        return visit_parts(*parts);
    if (node.form.is_bounded_jump()) return leave_jump(part, rect);
    if (node.model == nullptr || !is_fine(node, part.sight)) {
        add_slopes(part.sight, node.form, axes_);
        return scan(part, rect);
    }
    scratch_.rects.clear();
    for_each_rect(part.sight, rect, [&](const Rect& some) { scratch_.rects.push_back(some); });
    trace_model(part, {.rects = scratch_.rects, .outline = seen, .others = {}});
}

std::size_t PatchTile::order_parts(PatchNode::Children& children, SeenNodes& parts,
                                   Order& order) const {
    SeenParts seen;
    const PartWindow window{.axes = axes_,
                            .rays = bounds_,
                            .clip = clip_,
                            .depths = {.near = depths_.near, .far = limit_}};
    const std::uint32_t met = see_parts(children.forms, window, seen);
    std::size_t count = 0;
    for (std::size_t i = 0; i < children.nodes.size(); ++i) {
        PatchNode& node = children.nodes[i];
        SeenNode& part = parts[count];
        if ((children.forms.known >> i & 1U) == 0) {
            if (!see(node, part)) continue;
        } else {
            if ((met >> i & 1U) == 0) continue;
            part.node = &node;
            part.sight = seen.sight(i);
            part.depths = part.sight.depths();
        }
        order[count] = {part.sight.c.z, count};
        ++count;
    }
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
}

void PatchTile::visit_parts(PatchNode::Children& children) {
    SeenNodes parts;
    Order order;
    const std::size_t count = order_parts(children, parts, order);
    const auto fetch_part = [&](std::size_t i) {
        if (i < count) fetch(*parts[order[i].second].node);
    };
    fetch_part(0);
    for (std::size_t i = 0; i < count; ++i) {
        fetch_part(i + 1);
        visit(parts[order[i].second]);
    }
}

void PatchTile::find_limit() {
    new_hits_ = 0;
    find_reaches();
    limit_ = std::min(limit_, *std::ranges::max_element(block_reach_));
}

void PatchTile::empty_rest() {
    solve();
    scratch_.leaves.clear();  // no candidate is left that names one
    search_rest();
    scratch_.rest.clear();
}

void PatchTile::search_rest() {
    most_kept_ = std::max(most_kept_, scratch_.rest.size());
    // Several pieces of a leaf may leave the same ray.
    const auto what = [](const Rest& rest) { return std::tuple(rest.pixel, rest.node, rest.near); };
    std::ranges::sort(scratch_.rest, {}, what);
    const auto is_same = [](const Rest& a, const Rest& b) {
        return a.pixel == b.pixel && a.node == b.node;
    };
    const auto others = std::ranges::unique(scratch_.rest, is_same);
    scratch_.rest.erase(others.begin(), others.end());
    std::ranges::sort(scratch_.rest, {}, &Rest::near);
    for (const Rest& rest : scratch_.rest) {
        if (frame_.stopped()) return;
        if (rest.near > answer_.reach(rest.pixel)) continue;
        const SightRay ray = ray_of(rest.pixel);
        const DepthRange range = rays_.depths(ray.u, ray.v, 0.0, 0.0);
        const PatchQuest quest{.axes = axes_,
                               .ray = ray,
                               .from = std::max(range.enter_lo, rays_.first_depth()),
                               .to = std::min(range.exit_hi, answer_.limit(rest.pixel)),
                               .tolerance = rays_.tolerance(),
                               .pixel = 0.5 * pixel_at(rest.near),
                               .clip = clip_,
                               .any = quest_.wish == Wish::AnyHits};
        if (!(quest.from <= quest.to)) continue;
        answer_.set(rest.pixel, search_.search(quest, *rest.node, answer_.hit(rest.pixel)));
    }
}

}  // namespace zeroset
