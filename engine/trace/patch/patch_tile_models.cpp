#include "engine/trace/patch/patch_tile.hpp"

#include <algorithm>

// The parts of a patch that are known by their models.

namespace zeroset {

/// Takes what a leaf tells of single rays.
class PatchTile::PartTaker final : public LeafTaker {
public:
    PartTaker(PatchTile& tile, PatchNode& node) : tile_(tile), node_(node) {}

    RayState judge(const LeafHit& hit) override { return tile_.judge(hit); }
    void leave(std::size_t pixel, double near, LeafLeft why) override {
        if (why == LeafLeft::Coarse) {
            left_.push_back(pixel);
        } else {
            tile_.keep({.pixel = pixel, .node = &node_, .near = near});
        }
    }
    /// The pixels for which the leaf's model is too coarse.
    [[nodiscard]] const std::vector<std::size_t>& left() const { return left_; }

private:
    PatchTile& tile_;
    PatchNode& node_;
    std::vector<std::size_t> left_;
};

bool PatchTile::is_fine(const PatchNode& node, const PatchSight& sight) const {
    return node.model == nullptr || 6.0 * sight.value_error <= rays_.tolerance();
}

LeafWindow PatchTile::window_of(const PatchForm& form, const SightDepths& depths) const {
    if (tree_.box() || !frame_.scene.region.is_whole()) return LeafWindow::Judged;
    if (depths.near < rays_.first_depth()) return LeafWindow::Box;
    const Box& clip = clip_;
    const glm::dvec3 reach = form.spread() + axes_.error;
    for (int k = 0; k < 3; ++k) {
        if (form.c[k] - reach[k] < clip.lo[k] || form.c[k] + reach[k] > clip.hi[k])
            return LeafWindow::Box;
    }
    return LeafWindow::All;
}

void PatchTile::trace_model(const SeenNode& part, const LeafPixels& pixels) {
    const LeafSight leaf{.model = *part.node->model,
                         .near = part.depths.near,
                         .sizes = part.node->sizes,
                         .box = part.node->box.grown(form_growth),
                         .value_error = part.sight.value_error};
    const LeafClip clip{.window = window_of(part.node->form, part.depths),
                        .box = clip_,
                        .first = rays_.first_depth()};
    PartTaker taker(*this, *part.node);
    const LeafCount count = trace_leaf(leaf, axes_, answer_.rays(quest_, rays_.tolerance(), grid_),
                                       pixels, clip, scratch_.lists, taker);
    counters_.value += count.evaluations;
    new_hits_ += count.hits;
    if (count.hits > 0) {
        std::ranges::for_each(pixels.rects, [&](const Rect& rect) { change(rect); });
        if (!pixels.others.empty()) change_all();
    }
    if (!taker.left().empty()) trace_parts(*part.node, taker.left());
    if (new_hits_ >= tile_pixels / 8) find_limit();
}

void PatchTile::change(const Rect& rect) {
    std::uint64_t blocks = 0;
    for (int row = rect.row / block; row * block < rect.end_row; ++row) {
        for (int col = rect.col / block; col * block < rect.end_col; ++col)
            blocks |= std::uint64_t{1} << (row * (tile_size / block) + col);
    }
    changed_blocks_ |= blocks;
    answer_.touch(blocks);
}

void PatchTile::change_all() {
    changed_blocks_ = ~std::uint64_t{0};
    answer_.touch(changed_blocks_);
}

void PatchTile::trace_parts(PatchNode& node, std::span<const std::size_t> pixels) {
    PatchNode::Children* const children = node.level < most_levels ? tree_.parts(node) : nullptr;
    if (children == nullptr) {
        for (const std::size_t pixel : pixels)
            keep({.pixel = pixel, .node = &node, .near = depths_.near});
        return;
    }
    SeenNodes parts;
    Order order;
    const std::size_t count = order_parts(*children, parts, order);
    for (std::size_t i = 0; i < count && !frame_.stopped(); ++i) {
        SeenNode& part = parts[order[i].second];
        if (part.node->model != nullptr) {
            add_value_error(part.sight, part.node->form);
            trace_model(part, {.rects = {}, .outline = nullptr, .others = pixels});
            continue;
        }
        for (const std::size_t pixel : pixels)
            keep({.pixel = pixel, .node = part.node, .near = part.depths.near});
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

RayState PatchTile::judge(const LeafHit& hit) const {
    const SightRay ray = ray_of(hit.pixel);
    const DepthRange range = rays_.depths(ray.u, ray.v, 0.0, 0.0);
    if (hit.s < range.enter_lo || hit.s > range.exit_hi || hit.s < rays_.first_depth())
        return RayState::Open;
    const InSquare in_box = side_of_own_box(hit);
    if (in_box == InSquare::Outside) return RayState::Open;
    return hit.is_inside && in_box == InSquare::Inside ? RayState::Proved : RayState::Drawn;
}

}  // namespace zeroset
