// Natural interval extensions of f over parts of rays and over cells: sharper than forms beside
// poles and jumps.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_RANGES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_RANGES_INL
#undef ZEROSET_BEAM_RANGES_INL
#else
#define ZEROSET_BEAM_RANGES_INL
#endif

#include "engine/kernel/range_boxes.hpp"
#include "engine/trace/beam/beam_pieces-inl.hpp"
#include "engine/trace/tile_costs.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Pixels of a tile, as many across as down.
struct SquareOfPixels {
    std::uint16_t pixel;  ///< the first one, in rows of tile_size
    std::uint16_t side;
};

/// Memory that a RangeList keeps.
template <class Real>
struct RangeMemory {
    RangeBoxList<Real> boxes;
    Pieces<Real> pieces;
    RangeBoxList<Real> piece_boxes;
    std::vector<bool> left;               ///< whether a piece of a box may hold a root
    std::vector<SquareOfPixels> squares;  ///< that each box is for
};

/// Boxes around parts of the view, and enclosures of f over them.
template <class Real>
class RangeList {
public:
    RangeList(const TraceFrame& frame, const TileRays& rays, RangeMemory<Real>& memory,
              Counters& counters)
        : frame_(frame), rays_(rays), memory_(memory), boxes_(memory.boxes), counters_(counters) {}

    void clear() { size_ = 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// A box around the rays of a tile of this size at depths from s to t.
    void push(CellTile tile, int pixels, double s, double t) {
        const double half = TileRays::middle_of(pixels);
        const double radius = rays_.radius_of(pixels) * rays_.pixel();
        push(rays_.u(tile.col() + half), rays_.v(tile.row() + half), radius, s, t,
             {tile.pixel, static_cast<std::uint16_t>(pixels)});
    }
    /// A box around a part of a pixel's ray.
    void push(std::uint32_t pixel, double s, double t) {
        push(rays_.u(pixel % tile_size), rays_.v(pixel / tile_size), 0.0, s, t,
             {static_cast<std::uint16_t>(pixel), 1});
    }
    void evaluate(const Kernel& kernel) { evaluate(kernel.template in<Real>().range); }
    void evaluate(const KernelFunction<RangeBatchOf<Real>>& range);
    /// Looks at those boxes of the evaluated list piece by piece in which switches are open.
    void evaluate_pieces(const Kernel& kernel);

    /// Whether f is surely nowhere 0 in the box, nor of both signs where jumps are drawn.
    [[nodiscard]] bool excludes_zero(std::size_t i) const {
        return boxes_.excludes_zero(i) && !(frame_.scene.jumps && in_two_parts(i));
    }
    /// A lower bound of |f| in the box, where f surely has a sign.
    [[nodiscard]] Real least_size(std::size_t i) const { return boxes_.least_size(i); }
    /// +1 or -1 where f surely has that sign, else 0.
    [[nodiscard]] int sign(std::size_t i) const { return boxes_.sign(i); }
    [[nodiscard]] bool continuous(std::size_t i) const { return boxes_.continuous[i] != 0; }
    /// Whether f is surely 0 in all of the box.
    [[nodiscard]] bool vanishes(std::size_t i) const {
        return boxes_.f_neg_lo[i] == 0 && boxes_.f_hi[i] == 0 && continuous(i);
    }

private:
    /// A box around the points with |u - u_i| <= radius, |v - v_i| <= radius at depths from s to t.
    void push(double u, double v, double radius, double s, double t, SquareOfPixels square);
    /// Tells who asks that a box was evaluated.
    void tell_cost(std::size_t i) const {
        const SquareOfPixels square = memory_.squares[i];
        counters_.costs->add(square.pixel % tile_size, square.pixel / tile_size, square.side,
                             square.side);
    }
    /// Whether f is known to be of either sign, and nowhere 0.
    [[nodiscard]] bool in_two_parts(std::size_t i) const {
        constexpr Real nowhere = -std::numeric_limits<Real>::infinity();
        return boxes_.f_neg_lo[i] < 0 && boxes_.f_hi[i] < 0 && boxes_.f_hi[i] > nowhere;
    }
    [[nodiscard]] const Real* uniforms() const {
        return frame_.scene.uniforms.template boxes<Real>();
    }

    const TraceFrame& frame_;
    const TileRays& rays_;
    RangeMemory<Real>& memory_;
    RangeBoxList<Real>& boxes_;
    Counters& counters_;
    std::size_t size_ = 0;
};

template <class Real>
void RangeList<Real>::push(double u, double v, double radius, double s, double t,
                           SquareOfPixels square) {
    boxes_.reserve(size_ + 1);
    memory_.squares.resize(std::max(memory_.squares.size(), size_ + 1));
    memory_.squares[size_] = square;
    const ViewFrame& axes = rays_.axes();
    for (int k = 0; k < 3; ++k) {
        // Linear in u and v, and in the depth: extremes are at the corners.
        const double across = u * axes.right[k] + v * axes.up[k];
        const double aside = (std::abs(axes.right[k]) + std::abs(axes.up[k])) * radius;
        const double near =
            rays_.base()[k] + rays_.distance() * across + s * (axes.forward[k] + across);
        const double far =
            rays_.base()[k] + rays_.distance() * across + t * (axes.forward[k] + across);
        const double near_aside = aside * std::abs(rays_.distance() + s) + rays_.depth_error();
        const double far_aside = aside * std::abs(rays_.distance() + t) + rays_.depth_error();
        const auto axis = static_cast<std::size_t>(k);
        boxes_.ends[axis][size_] = upper_end(Real{}, std::max(near_aside - near, far_aside - far));
        boxes_.ends[axis + 3][size_] =
            upper_end(Real{}, std::max(near + near_aside, far + far_aside));
    }
    ++size_;
}

template <class Real>
void RangeList<Real>::evaluate(const KernelFunction<RangeBatchOf<Real>>& range) {
    if (size_ == 0) return;
    counters_.range += size_;
    for (std::size_t i = 0; counters_.costs != nullptr && i < size_; ++i)
        tell_cost(i);
    range(boxes_.batch(size_, uniforms()));
}

template <class Real>
void RangeList<Real>::evaluate_pieces(const Kernel& kernel) {
    constexpr int most_switches = 5;
    if (kernel.switches == 0 || frame_.scene.jumps) return;
    const auto is_open = [&](std::size_t i) {
        return boxes_.branches_of(i).outcomes() > 0 && !boxes_.excludes_zero(i);
    };
    memory_.pieces.begin(kernel.switches);
    for (std::size_t i = 0; i < size_; ++i) {
        if (is_open(i)) memory_.pieces.push(i, boxes_.branches_of(i));
    }
    memory_.left.assign(size_, false);
    RangeBoxList<Real>& of = memory_.piece_boxes;
    const auto evaluate = [&](PieceList<Real>& list) {
        of.reserve(list.size());
        for (std::size_t k = 0; k < list.size(); ++k) {
            for (std::size_t axis = 0; axis < 6; ++axis)
                of.ends[axis][k] = boxes_.ends[axis][list.cell(k)];
        }
        counters_.range += list.size();
        for (std::size_t k = 0; counters_.costs != nullptr && k < list.size(); ++k)
            tell_cost(list.cell(k));
        kernel.template in<Real>().range(of.batch(list.size(), uniforms(), list.held()));
    };
    memory_.pieces.visit(
        most_switches, evaluate, [&](std::size_t k) { return of.excludes_zero(k); },
        [&](std::size_t k) { return of.branches_of(k); },
        [&](std::size_t box, std::size_t /*piece*/) { memory_.left[box] = true; });
    for (std::size_t i = 0; i < size_; ++i) {
        // No piece holds a root: f is of either sign, but not 0.
        if (is_open(i) && !memory_.left[i]) boxes_.f_neg_lo[i] = boxes_.f_hi[i] = -1;
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
