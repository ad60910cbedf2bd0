#include "engine/mesh/vertex_clusters.hpp"

#include "engine/mesh/place_index.hpp"

#include <algorithm>
#include <numeric>

namespace zeroset {

VertexClusters::VertexClusters(std::span<const Triangle> triangles, std::size_t vertices)
    : triangles_(triangles), roots_(vertices), sizes_(vertices, 1) {
    std::iota(roots_.begin(), roots_.end(), 0U);
}

std::uint32_t VertexClusters::find(std::uint32_t v) {
    while (roots_[v] != v)
        v = roots_[v] = roots_[roots_[v]];
    return v;
}

void VertexClusters::join(std::span<const std::uint64_t> labels, const Set& set) {
    for (std::uint32_t v = 0; v < roots_.size(); ++v) {
        if (set[v] == 0) continue;
        roots_[v] = v;
        sizes_[v] = 0;
    }
    for (const Triangle& t : triangles_) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            // Each side runs both ways.
            if (a > b || (set[a] & set[b]) == 0) continue;
            if (labels[a] == labels[b] && labels[a] != alone) roots_[find(a)] = find(b);
        }
    }
    for (std::uint32_t v = 0; v < roots_.size(); ++v) {
        if (set[v] != 0) ++sizes_[roots_[v] = find(v)];
    }
}

/// Adds groups of a set that cannot be drawn together to a point.
void VertexClusters::find_holed(const Set& set, std::vector<std::uint32_t>& found) const {
    // V - E + F of each group, doubled: a side is half in each of its two triangles.
    std::vector<std::int32_t> twice(roots_.size());
    for (const std::uint32_t root : roots_)
        twice[root] += 2;
    for (const Triangle& t : triangles_) {
        const Triangle r = roots_of(t);
        if (!touches(t, set) || is_left(r)) continue;
        for (std::size_t k = 0; k < 3; ++k)
            twice[r[k]] -= r[k] == r[(k + 1) % 3] ? 1 : 0;
        if (r[0] == r[1] && r[1] == r[2]) twice[r[0]] += 2;
    }
    for (std::uint32_t v = 0; v < roots_.size(); ++v) {
        if (roots_[v] == v && set[v] != 0 && twice[v] != 2) found.push_back(v);
    }
}

std::vector<std::uint32_t> VertexClusters::defects(const Set& set) const {
    std::vector<std::uint32_t> found;
    find_holed(set, found);
    std::vector<Triangle> left;
    for (const Triangle& t : triangles_) {
        const Triangle r = roots_of(t);
        if (touches(t, set) && is_left(r)) left.push_back(r);
    }
    std::vector<std::uint32_t> uses(roots_.size());
    PairIndex sides(roots_.size());
    for (const Triangle& t : left) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t end = t[(k + 1) % 3];
            ++uses[t[k]];
            const std::size_t before = sides.keys().size();
            if (sides.add(t[k], end) < before) found.insert(found.end(), {t[k], end});
        }
    }
    // A closed piece that is two groups would have no triangle left.
    for (const Triangle& t : triangles_) {
        const Triangle r = roots_of(t);
        const bool lost =
            std::ranges::any_of(r, [&](std::uint32_t v) { return set[v] != 0 && uses[v] == 0; });
        if (touches(t, set) && lost) found.insert(found.end(), r.begin(), r.end());
    }
    // Two triangles back to back are no mesh.
    for (const Triangle& t : left) {
        const bool flat =
            std::ranges::any_of(t, [&](std::uint32_t v) { return set[v] != 0 && uses[v] < 3; });
        if (flat) found.insert(found.end(), t.begin(), t.end());
    }
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
}

}  // namespace zeroset
