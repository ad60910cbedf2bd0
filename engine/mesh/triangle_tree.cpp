#include "engine/mesh/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace zeroset {
namespace {

constexpr std::size_t most_in_leaf = 4;

Box box_of(const TriangleMesh& mesh, const Triangle& t) {
    const glm::dvec3& a = mesh.vertices[t[0]].point;
    const glm::dvec3& b = mesh.vertices[t[1]].point;
    const glm::dvec3& c = mesh.vertices[t[2]].point;
    return {.lo = glm::min(a, glm::min(b, c)), .hi = glm::max(a, glm::max(b, c))};
}

int longest_axis(const glm::dvec3& size) {
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

/// Where a ray enters a box; unbounded: it misses it, or does so beyond `most`.
double entry(const Box& box, const glm::dvec3& from, const glm::dvec3& inverse, double most) {
    double near = 0.0;
    double far = most;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::isinf(inverse[axis])) {
            if (from[axis] < box.lo[axis] || from[axis] > box.hi[axis]) return unbounded;
            continue;
        }
        const double a = (box.lo[axis] - from[axis]) * inverse[axis];
        const double b = (box.hi[axis] - from[axis]) * inverse[axis];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    constexpr double rounding = 1e-12;
    return near <= far * (1.0 + rounding) ? near : unbounded;
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    std::vector<Box> boxes;
    boxes.reserve(order_.size());
    for (const Triangle& t : mesh.triangles)
        boxes.push_back(box_of(mesh, t));
    nodes_.reserve(order_.size());
    if (!order_.empty()) build(0, order_.size(), boxes);
}

void TriangleTree::build(std::size_t first, std::size_t count, std::span<const Box> boxes) {
    const auto own = std::span(order_).subspan(first, count);
    Node node{.box = boxes[own[0]]};
    Box middles{.lo = boxes[own[0]].centre(), .hi = boxes[own[0]].centre()};
    for (const std::uint32_t t : own) {
        node.box = {.lo = glm::min(node.box.lo, boxes[t].lo),
                    .hi = glm::max(node.box.hi, boxes[t].hi)};
        middles = {.lo = glm::min(middles.lo, boxes[t].centre()),
                   .hi = glm::max(middles.hi, boxes[t].centre())};
    }
    const std::size_t number = nodes_.size();
    nodes_.push_back(node);
    if (count <= most_in_leaf) {
        nodes_[number].first = static_cast<std::uint32_t>(first);
        nodes_[number].count = static_cast<std::uint32_t>(count);
        return;
    }
    const int axis = longest_axis(middles.hi - middles.lo);
    const std::size_t half = count / 2;
    std::ranges::nth_element(
        own, own.begin() + static_cast<std::ptrdiff_t>(half), {},
        [&](std::uint32_t t) { return boxes[t].lo[axis] + boxes[t].hi[axis]; });
    build(first, half, boxes);
    nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
    build(first + half, count - half, boxes);
}

/// Takes a triangle that the ray leaves by, nearer than the nearest so far [MoellerTrumbore97].
void TriangleTree::meet(std::uint32_t triangle, const glm::dvec3& from, const glm::dvec3& direction,
                        std::optional<Hit>& nearest) const {
    // Rays that pass an edge so closely meet both its triangles.
    constexpr double rounding = 1e-9;
    const Triangle& t = mesh_.triangles[triangle];
    const glm::dvec3& a = mesh_.vertices[t[0]].point;
    const glm::dvec3 ab = mesh_.vertices[t[1]].point - a;
    const glm::dvec3 ac = mesh_.vertices[t[2]].point - a;
    const glm::dvec3 across = glm::cross(direction, ac);
    const double volume = -glm::dot(ab, across);  // above 0: from behind
    if (!(volume > 0)) return;
    const glm::dvec3 way = from - a;
    const double u = -glm::dot(way, across) / volume;
    const glm::dvec3 other = glm::cross(way, ab);
    const double v = -glm::dot(direction, other) / volume;
    if (!(u >= -rounding && v >= -rounding && u + v <= 1.0 + rounding)) return;
    const double distance = -glm::dot(ac, other) / volume;
    if (!(distance >= 0) || (nearest && distance >= nearest->distance)) return;
    nearest = {.distance = std::abs(distance), .triangle = triangle};
}

std::optional<TriangleTree::Hit> TriangleTree::way_out(const glm::dvec3& from,
                                                       const glm::dvec3& direction,
                                                       std::uint32_t own, double most) const {
    constexpr std::size_t deepest = 64;
    std::optional<Hit> nearest;
    if (nodes_.empty()) return nearest;
    const glm::dvec3 inverse = 1.0 / direction;
    std::array<std::uint32_t, deepest> open{};
    std::size_t count = 1;
    while (count > 0) {
        const std::uint32_t number = open[--count];
        const Node& node = nodes_[number];
        if (nearest) most = std::min(most, nearest->distance);
        if (entry(node.box, from, inverse, most) == unbounded) continue;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const std::uint32_t triangle = order_[node.first + i];
            if (triangle != own) meet(triangle, from, direction, nearest);
        }
        if (node.count > 0) continue;
        // The node that is asked first lies on top: the nearer of the two, as the ray runs.
        const Node& first = nodes_[number + 1];
        const Node& second = nodes_[node.second];
        const bool swapped =
            glm::dot(direction, second.box.centre()) < glm::dot(direction, first.box.centre());
        open[count++] = swapped ? number + 1 : node.second;
        open[count++] = swapped ? node.second : number + 1;
    }
    return nearest;
}

}  // namespace zeroset
