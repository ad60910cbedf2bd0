#include "engine/distance/near_surface.hpp"

#include "engine/distance/enclose_cells.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace zeroset {
namespace {

constexpr std::uint32_t pieces_a_node = 4;

}  // namespace

std::expected<NearSurface, std::size_t> NearSurface::make(const SurfaceFunction& function,
                                                          const Box& box,
                                                          const SlabLimits& limits) {
    NearSurface surface;
    std::vector<Box> cells{box};
    while (!cells.empty()) {
        EnclosedCells next = enclose_cells(function, cells, limits);
        surface.pieces_.insert(surface.pieces_.end(), next.pieces.begin(), next.pieces.end());
        if (next.open.size() * 8 > limits.most_cells) return std::unexpected(next.open.size() * 8);
        cells = std::move(next.open);
        cells = divided(cells);
    }
    if (surface.pieces_.empty()) return surface;
    surface.has_zero_ = std::ranges::any_of(
        surface.pieces_, [](const SurfacePiece& piece) { return piece.crosses || piece.has_zero; });
    surface.nodes_.emplace_back();
    surface.arrange(0, 0, static_cast<std::uint32_t>(surface.pieces_.size()));
    return surface;
}

/// Puts the pieces from `first` to `last` below a node, near ones together.
void NearSurface::arrange(std::uint32_t node, std::uint32_t first, std::uint32_t last) {
    const std::span<const SurfacePiece> pieces(&pieces_[first], last - first);
    const SurfacePiece hull = hull_of(pieces);
    if (pieces.size() <= pieces_a_node) {
        nodes_[node] = {.hull = hull, .first = first, .count = last - first};
        return;
    }
    const glm::dvec3 size = hull.box.hi - hull.box.lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    const auto at = [&](std::uint32_t i) {
        return pieces_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(first), at(middle), at(last),
                     [&](const SurfacePiece& a, const SurfacePiece& b) {
                         return a.box.lo[axis] + a.box.hi[axis] < b.box.lo[axis] + b.box.hi[axis];
                     });
    const auto below = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node] = {.hull = hull, .first = below, .count = 0};
    nodes_.resize(nodes_.size() + 2);
    arrange(below, first, middle);
    arrange(below + 1, middle, last);
}

DistanceBounds NearSurface::distance(const glm::dvec3& point, double known) const {
    struct Task {
        std::uint32_t node;
        double from;
    };
    DistanceBounds bounds{.hi = known};
    if (nodes_.empty()) return bounds;
    std::array<Task, 128> tasks;  // two a level, of at most 32
    std::size_t count = 0;
    // A node farther away than a zero that is proved changes neither bound, and one farther away
    // than the lower bound does not change that.
    const auto is_far = [&](double from) { return from > (has_zero_ ? bounds.hi : bounds.lo); };
    const auto task_of = [&](std::uint32_t node) {
        const SurfacePiece& hull = nodes_[node].hull;
        const double from = distance_below(hull.box, point);
        return Task{.node = node, .from = is_far(from) ? from : hull.distance(point).lo};
    };
    tasks[count++] = task_of(0);
    while (count > 0) {
        const Task task = tasks[--count];
        if (is_far(task.from)) continue;
        const Node& node = nodes_[task.node];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            if (is_far(distance_below(pieces_[i].box, point))) continue;
            const DistanceBounds own = pieces_[i].distance(point);
            bounds.lo = std::min(bounds.lo, own.lo);
            bounds.hi = std::min(bounds.hi, own.hi);
        }
        if (node.count > 0) continue;
        Task near = task_of(node.first);
        Task far = task_of(node.first + 1);
        if (far.from < near.from) std::swap(near, far);
        tasks[count++] = far;
        tasks[count++] = near;
    }
    bounds.lo = std::min(bounds.lo, bounds.hi);
    return bounds;
}

}  // namespace zeroset
