#include "engine/trace/patch/patch_tile.hpp"

#include <algorithm>
#include <limits>

// The parts of a patch that are known by their models.

namespace zeroset {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t tile_pixels = static_cast<std::size_t>(tile_size) * tile_size;

}  // namespace

bool PatchTile::is_fine(const PatchNode& node, const PatchSight& sight) const {
    return node.model == nullptr || 6.0 * sight.value_error <= rays_.tolerance();
}

bool PatchTile::is_inside(const PatchForm& form, const SightDepths& depths) const {
    const Region& region = frame_.scene.region;
    if (!region.is_whole() || depths.near < rays_.first_depth()) return false;
    const Box& clip = clip_;
    const glm::dvec3 reach = form.spread() + axes_.error;
    for (int k = 0; k < 3; ++k) {
        if (form.c[k] - reach[k] < clip.lo[k] || form.c[k] + reach[k] > clip.hi[k]) return false;
    }
    return true;
}

void PatchTile::trace_model(const Part& part, const LeafPixels& pixels) {
    leaf_ = part.node;
    is_leaf_inside_ = is_inside(part.node->form, part.depths);
    const LeafRays rays{.u = room_.u.data(),
                        .v = room_.v.data(),
                        .reach = room_.reach.data(),
                        .row_size = tile_size};
    const LeafSight leaf{.terms = turned_terms(*part.node->model, axes_),
                         .value_error = part.sight.value_error,
                         .box = part.node->box.grown(form_growth)};
    room_.left.clear();
    counters_.value += trace_leaf(leaf, axes_, rays, pixels, rays_.tolerance(), room_.lists, *this);
    if (!room_.left.empty()) {
        const std::vector<std::size_t> left = room_.left;
        trace_parts(*part.node, left);
    }
    if (new_hits_ >= tile_pixels / 8) find_limit();
}

void PatchTile::trace_parts(PatchNode& node, std::span<const std::size_t> pixels) {
    PatchNode::Children* const children = node.level < most_levels ? tree_.parts(node) : nullptr;
    if (children == nullptr) {
        for (const std::size_t pixel : pixels)
            room_.rest.push_back({.pixel = pixel, .node = &node, .near = depths_.near});
        return;
    }
    Parts parts;
    Order order;
    const std::size_t count = order_parts(*children, parts, order);
    for (std::size_t i = 0; i < count && !frame_.stopped(); ++i) {
        Part& part = parts[order[i].second];
        if (part.node->model != nullptr) {
            add_slopes(part.sight, part.node->form, axes_);
            trace_model(part, {.rects = {}, .others = pixels});
            continue;
        }
        for (const std::size_t pixel : pixels)
            room_.rest.push_back({.pixel = pixel, .node = part.node, .near = part.depths.near});
    }
}

void PatchTile::leave(std::size_t pixel, double near, LeafLeft why) {
    if (why == LeafLeft::Coarse) {
        room_.left.push_back(pixel);
    } else {
        room_.rest.push_back({.pixel = pixel, .node = leaf_, .near = near});
    }
}

InSquare PatchTile::side_of_own_box(const LeafHit& hit) const {
    if (!tree_.box()) return InSquare::Inside;
    const SightRay ray = ray_of(hit.pixel);
    const glm::dvec3 across = ray.u * axes_.right + ray.v * axes_.up;
    const glm::dvec3 along = axes_.forward + across;
    const glm::dvec3 at = axes_.base + axes_.distance * across + hit.s * along;
    const glm::dvec3 error = (hit.s_radius * (1.0 + 0x1p-40)) * glm::abs(along) + 8.0 * axes_.error;
    return in_box(*tree_.box(), at, error);
}

void PatchTile::take(const LeafHit& hit) {
    if (hit.s > room_.reach[hit.pixel]) return;
    if (!is_leaf_inside_) {
        const SightRay ray = ray_of(hit.pixel);
        const DepthRange range = rays_.depths(ray.u, ray.v, 0.0, 0.0);
        if (hit.s < range.enter_lo || hit.s > range.exit_hi || hit.s < rays_.first_depth()) return;
    }
    const InSquare in_box = is_leaf_inside_ ? InSquare::Inside : side_of_own_box(hit);
    if (in_box == InSquare::Outside) return;
    const bool is_proved = hit.is_inside && in_box == InSquare::Inside;
    // Number by number: whole hits that are copied would wait for these to be written.
    PatchHit& best = room_.best[hit.pixel];
    if (room_.is_set[hit.pixel] == 0) best.unsettled = unbounded;
    room_.is_set[hit.pixel] = 1;
    best.s = hit.s;
    best.s_radius = hit.s_radius;
    best.is_proved = is_proved;
    best.normal.x = hit.normal[0];
    best.normal.y = hit.normal[1];
    best.normal.z = hit.normal[2];
    room_.reach[hit.pixel] = std::min(hit.s, room_.to[hit.pixel]);
    ++new_hits_;
    const std::size_t row = hit.pixel / tile_size;
    const std::size_t col = hit.pixel % tile_size;
    changed_blocks_ |= std::uint64_t{1} << (row / block * (tile_size / block) + col / block);
    if (wish_ == Wish::AnyHits && is_proved) {
        room_.to[hit.pixel] = -unbounded;
        room_.reach[hit.pixel] = -unbounded;
    }
}

}  // namespace zeroset
