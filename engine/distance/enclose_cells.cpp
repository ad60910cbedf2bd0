#include "engine/distance/enclose_cells.hpp"

#include "engine/base/parallel.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>

// In a cell with middle c and half edges h, and with G an enclosure of the gradient, f(x) is in
// f(c) + G (x - c). With m the middle of G, and r its half widths, so
//   |f(x) - f(c) - m (x - c)| <= e,  e = dot(r, h),
// and the zeros lie in the slab |f(c) + m (x - c)| <= e.

namespace zeroset {
namespace {

constexpr std::size_t cells_at_once = 256;

using Boxes = RangeBoxes<double, cells_at_once>;

/// Boxes for a thread's work, as they are too large for a stack.
Boxes& boxes_of_thread() {
    thread_local const auto kept = std::make_unique<Boxes>();
    Boxes& boxes = *kept;
    return boxes;
}

/// Enclosures of a function over some boxes, in upward rounding. The batch is good until the next.
const Boxes& enclosures(const KernelFunction<RangeBatchOf<double>>& function,
                        std::span<const Box> of, const Uniforms& uniforms) {
    Boxes& boxes = boxes_of_thread();
    for (std::size_t i = 0; i < of.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            boxes.ends[axis][i] = -of[i].lo[axis];
            boxes.ends[axis + 3][i] = of[i].hi[axis];
        }
    }
    boxes.pad(of.size());
    function(boxes.batch(padded(of.size()), uniforms.boxes<double>()));
    return boxes;
}

struct Ends {
    double lo = -std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();

    Ends() = default;
    Ends(const Boxes& boxes, std::size_t i) : lo(-boxes.f_neg_lo[i]), hi(boxes.f_hi[i]) {}
    [[nodiscard]] bool is_bounded() const {
        return std::isfinite(lo) && std::isfinite(hi) && lo <= hi;
    }
};

/// A cell that may hold zeros.
struct Cell {
    SurfacePiece piece;
    bool continuous = false;
    Ends middle;                   ///< f at the cell's middle
    std::array<Ends, 3> gradient;  ///< over the cell
};

glm::dvec3 middle_of(const Box& box) { return 0.5 * (box.lo + box.hi); }

class CellWork {
public:
    CellWork(const SurfaceFunction& function, const SlabLimits& limits)
        : function_(function), limits_(limits) {}

    /// In upward rounding.
    void enclose(std::span<const Box> cells, EnclosedCells& out) {
        find_cells(cells);
        find_slopes();
        for (Cell& cell : cells_)
            cut(cell);
        std::erase_if(cells_, [](const Cell& cell) { return cell.piece.is_empty(); });
        for (const Cell& cell : cells_) {
            if (is_flat(cell.piece)) {
                out.pieces.push_back(cell.piece);
            } else if (diagonal(cell.piece.box) <= limits_.smallest) {
                out.pieces.push_back(cell.piece);
                out.pieces.back().has_zero = cell.continuous && changes_sign(cell.piece.box);
            } else {
                out.open.push_back(cell.piece.box);
            }
        }
    }

private:
    static double diagonal(const Box& box) { return glm::length(box.hi - box.lo); }
    void find_cells(std::span<const Box> boxes);
    void find_slopes();
    void cut(Cell& cell) const;
    [[nodiscard]] bool is_flat(const SurfacePiece& piece) const;
    [[nodiscard]] bool changes_sign(const Box& box) const;

    const SurfaceFunction& function_;
    const SlabLimits& limits_;
    std::vector<Cell> cells_;
};

/// The cells that are not free of zeros.
void CellWork::find_cells(std::span<const Box> boxes) {
    cells_.clear();
    const Boxes& found = enclosures(function_.range, boxes, function_.uniforms);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (found.excludes_zero(i)) continue;
        Cell& cell = cells_.emplace_back();
        cell.piece.box = boxes[i];
        cell.continuous = found.continuous[i] != 0;
    }
}

/// f at the middles, and its gradients.
void CellWork::find_slopes() {
    if (cells_.empty()) return;
    std::array<Box, cells_at_once> boxes;
    const std::span<const Box> all(boxes.data(), cells_.size());
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const glm::dvec3 middle = middle_of(cells_[i].piece.box);
        boxes[i] = {.lo = middle, .hi = middle};
    }
    const Boxes& at_middles = enclosures(function_.range, all, function_.uniforms);
    for (std::size_t i = 0; i < cells_.size(); ++i)
        cells_[i].middle = {at_middles, i};
    for (std::size_t i = 0; i < cells_.size(); ++i)
        boxes[i] = cells_[i].piece.box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Boxes& slopes = enclosures(function_.gradient[axis], all, function_.uniforms);
        for (std::size_t i = 0; i < cells_.size(); ++i)
            cells_[i].gradient[axis] = {slopes, i};
    }
}

/// Gives the cell's piece its slab, where f is continuous and all is bounded.
void CellWork::cut(Cell& cell) const {
    if (!cell.continuous || !cell.middle.is_bounded()) return;
    const Box& box = cell.piece.box;
    glm::dvec3 slope(0.0);
    double error = 0.5 * (cell.middle.hi - cell.middle.lo);
    double size = 0.0;  // of the numbers that are rounded here
    for (int axis = 0; axis < 3; ++axis) {
        const Ends& ends = cell.gradient[static_cast<std::size_t>(axis)];
        if (!ends.is_bounded()) return;
        slope[axis] = 0.5 * (ends.lo + ends.hi);
        // The middle is off by a rounding of the box's coordinates.
        const double half = 0.5 * (box.hi[axis] - box.lo[axis]) +
                            0x1p-50 * (std::abs(box.lo[axis]) + std::abs(box.hi[axis]));
        error += std::max(ends.hi - slope[axis], slope[axis] - ends.lo) * half;
        size += std::max(std::abs(ends.lo), std::abs(ends.hi)) * half +
                0x1p-6 * std::abs(slope[axis]) * (std::abs(box.lo[axis]) + std::abs(box.hi[axis]));
    }
    const double level = 0.5 * (cell.middle.lo + cell.middle.hi);
    const double length = glm::length(slope);
    if (!(length > 0) || !std::isfinite(length)) return;
    error += 0x1p-42 * (size + std::abs(level));
    const double half_width = error / length;
    if (!std::isfinite(half_width)) return;
    cell.piece.normal = slope / length;
    cell.piece.offset = -level / length;
    cell.piece.half_width = half_width;
    cell.piece.crosses = true;
}

/// Whether the slab is thin, for what is asked and for the box: a plane through the box's middle
/// has room for both of its sides.
bool CellWork::is_flat(const SurfacePiece& piece) const {
    const glm::dvec3 edges = piece.box.hi - piece.box.lo;
    return piece.crosses && piece.half_width <= limits_.half_width &&
           8 * piece.half_width <= std::min({edges.x, edges.y, edges.z});
}

/// Whether f surely has both signs at the corners.
bool CellWork::changes_sign(const Box& box) const {
    std::array<Box, 8> corners;
    for (int n = 0; n < 8; ++n) {
        const glm::dvec3 corner((n & 1) != 0 ? box.hi.x : box.lo.x,
                                (n & 2) != 0 ? box.hi.y : box.lo.y,
                                (n & 4) != 0 ? box.hi.z : box.lo.z);
        corners[static_cast<std::size_t>(n)] = {.lo = corner, .hi = corner};
    }
    const Boxes& found = enclosures(function_.range, corners, function_.uniforms);
    bool above = false;
    bool below = false;
    for (std::size_t n = 0; n < 8; ++n) {
        above = above || -found.f_neg_lo[n] > 0;
        below = below || found.f_hi[n] < 0;
    }
    return above && below;
}

}  // namespace

EnclosedCells enclose_cells(const SurfaceFunction& function, const std::vector<Box>& cells,
                            const SlabLimits& limits) {
    const std::size_t parts = (cells.size() + cells_at_once - 1) / cells_at_once;
    std::vector<EnclosedCells> found(parts);
    parallel_for(parts, 0, [&](std::size_t part) {
        const UpwardRegisters upward;
        const std::size_t first = part * cells_at_once;
        const std::size_t count = std::min(cells_at_once, cells.size() - first);
        CellWork(function, limits).enclose(std::span(cells).subspan(first, count), found[part]);
    });
    EnclosedCells all;
    for (const EnclosedCells& part : found) {
        all.pieces.insert(all.pieces.end(), part.pieces.begin(), part.pieces.end());
        all.open.insert(all.open.end(), part.open.begin(), part.open.end());
    }
    return all;
}

std::vector<Box> divided(const std::vector<Box>& cells) {
    std::vector<Box> parts;
    parts.reserve(8 * cells.size());
    for (const Box& cell : cells) {
        const glm::dvec3 middle = middle_of(cell);
        for (int n = 0; n < 8; ++n) {
            Box part = cell;
            for (int axis = 0; axis < 3; ++axis)
                ((n >> axis & 1) != 0 ? part.lo : part.hi)[axis] = middle[axis];
            parts.push_back(part);
        }
    }
    return parts;
}

}  // namespace zeroset
