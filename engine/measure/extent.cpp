#include "engine/measure/extent.hpp"

#include "engine/kernel/kernel.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/ways/surface_ways.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace zeroset {
namespace {

/// Cells that are no longer than this part of what is found are not halved any more.
constexpr double finest_share = 1.0 / 64.0;
constexpr std::size_t most_cells = 200'000;
/// Surfaces are looked for as far away as this, in sizes of the clip box.
constexpr double farthest_reach = extent_reach * extent_reach * extent_reach;
/// Cells of one face that are halved at a time: those are enough to settle most faces.
constexpr std::size_t face_cells_at_once = 64;
/// Cells smaller than their coordinates times this are enclosed in double.
constexpr double finest_in_float = 0x1p-16;

/// Marks the cells that meet a box.
void mark(const std::vector<Box>& boxes, const std::vector<Box>& cells, std::vector<bool>& may) {
    const auto meet = [](const Box& a, const Box& b) {
        return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        may[i] = may[i] ||
                 std::ranges::any_of(boxes, [&](const Box& box) { return meet(cells[i], box); });
    }
}

/// Tells of each cell whether one of the surfaces may be in it. In upward rounding, which must not
/// be left to the caller's optimizer.
template <class Real>
[[gnu::noinline]] std::vector<bool> may_hold_surface(const Scene& scene,
                                                     const std::vector<Box>& cells) {
    RangeBoxList<Real> ranges;
    ranges.resize(padded(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            ranges.ends[k][i] = upper_end(Real{}, -cells[i].lo[axis]);
            ranges.ends[k + 3][i] = upper_end(Real{}, cells[i].hi[axis]);
        }
    }
    std::vector<bool> may(cells.size(), false);
    for (const Surface& surface : scene.surfaces) {
        const Kernel& kernel = surface.kernel;
        if (const auto boxes = way_of(kernel).boxes(kernel, scene.uniforms)) {
            mark(*boxes, cells, may);
            continue;
        }
        kernel.range(ranges.batch(cells.size(), scene.uniforms.boxes<Real>()));
        for (std::size_t i = 0; i < cells.size(); ++i)
            may[i] = may[i] || !ranges.excludes_zero(i);
    }
    return may;
}

bool needs_double(const Box& cell) {
    double reach = 0.0;
    for (int i = 0; i < 3; ++i)
        reach = std::max({reach, std::abs(cell.lo[i]), std::abs(cell.hi[i])});
    return cell.size() < finest_in_float * reach;
}

void push_octants(const Box& cell, std::vector<Box>& out) {
    const glm::dvec3 middle = cell.centre();
    for (int octant = 0; octant < 8; ++octant) {
        Box& part = out.emplace_back(cell);
        for (int i = 0; i < 3; ++i)
            ((octant >> i & 1) != 0 ? part.lo : part.hi)[i] = middle[i];
    }
}

/// Halves the cells at the faces of their bounding box until each face has a small one.
class ExtentSearch {
public:
    ExtentSearch(const Scene& scene, const Box& domain) : scene_(scene) { keep({domain}); }
    std::optional<Box> run(const TimeLimit& limit) {
        while (!cells_.empty() && seen_ < most_cells && !limit.over() && halve_faces()) {
        }
        if (cells_.empty()) return std::nullopt;
        return bounds();
    }

private:
    [[nodiscard]] Box bounds() const {
        Box box = cells_.front();
        for (const Box& cell : cells_) {
            box.lo = glm::min(box.lo, cell.lo);
            box.hi = glm::max(box.hi, cell.hi);
        }
        return box;
    }

    void keep(const std::vector<Box>& cells) {
        seen_ += cells.size();
        const bool in_double = std::ranges::any_of(cells, needs_double);
        const UpwardRounding upward;
        const std::vector<bool> may = in_double ? may_hold_surface<double>(scene_, cells)
                                                : may_hold_surface<float>(scene_, cells);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (may[i]) cells_.push_back(cells[i]);
        }
    }

    /// Marks cells to be halved; none where one of the face's cells is small.
    void pick_from_face(const Box& all, int axis, bool upper, std::vector<bool>& picked) const {
        const double small = finest_share * all.size();
        std::vector<std::size_t> at_face;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            const Box& cell = cells_[i];
            const bool touches =
                upper ? cell.hi[axis] == all.hi[axis] : cell.lo[axis] == all.lo[axis];
            if (!touches) continue;
            if (cell.hi[axis] - cell.lo[axis] <= small) return;
            at_face.push_back(i);
        }
        // The smallest first: one of them may settle the face.
        const std::size_t count = std::min(at_face.size(), face_cells_at_once);
        std::ranges::partial_sort(at_face, at_face.begin() + static_cast<std::ptrdiff_t>(count), {},
                                  [this](std::size_t i) { return cells_[i].size(); });
        for (std::size_t i = 0; i < count; ++i)
            picked[at_face[i]] = true;
    }

    /// Whether there was something to halve.
    bool halve_faces() {
        const Box all = bounds();
        std::vector<bool> picked(cells_.size(), false);
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool upper : {false, true})
                pick_from_face(all, axis, upper, picked);
        }
        std::vector<Box> halves;
        std::vector<Box> rest;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            picked[i] ? push_octants(cells_[i], halves) : rest.push_back(cells_[i]);
        }
        if (halves.empty()) return false;
        cells_.swap(rest);
        keep(halves);
        return true;
    }

    const Scene& scene_;
    std::vector<Box> cells_;  ///< in which a surface may be
    std::size_t seen_ = 0;
};

bool strictly_inside(const Box& box, const Box& domain) {
    return glm::all(glm::greaterThan(box.lo, domain.lo)) &&
           glm::all(glm::lessThan(box.hi, domain.hi));
}

/// A box that holds all of surfaces of which nothing is within extent_reach; nothing where they go
/// on beyond all of it.
std::optional<Box> far_box(const Scene& scene, const TimeLimit& limit) {
    for (double reach = extent_reach * extent_reach; reach <= farthest_reach;
         reach *= extent_reach) {
        const Box domain = scaled(scene.clip, reach);
        const auto all = enclosing_box(scene, domain, limit);
        if (all && strictly_inside(*all, domain)) return all;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Box> enclosing_box(const Scene& scene, const Box& domain, const TimeLimit& limit) {
    return ExtentSearch(scene, domain).run(limit);
}

Extent find_extent(const Scene& scene, const TimeLimit& limit) {
    Extent extent;
    const Box domain = scaled(scene.clip, extent_reach);
    const std::optional<Box> all = enclosing_box(scene, domain, limit);
    if (!all) {
        extent.whole = far_box(scene, limit);
        return extent;
    }
    if (strictly_inside(*all, domain)) extent.whole = all;
    extent.inside = enclosing_box(scene, scene.clip, limit);
    for (double factor = 2.0; !extent.inside && !extent.reached && factor <= extent_reach;
         factor *= 2.0) {
        const Box larger = scaled(scene.clip, factor);
        if (enclosing_box(scene, larger, limit)) extent.reached = larger;
    }
    return extent;
}

}  // namespace zeroset
