// Natural interval extensions of f over parts of rays and over cells: sharper than forms beside
// poles and jumps.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_RANGES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_RANGES_INL
#undef ZEROSET_BEAM_RANGES_INL
#else
#define ZEROSET_BEAM_RANGES_INL
#endif

#include "engine/trace/beam_cells-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// What a RangeList keeps: RangeBatchOf's arrays.
template <class Real>
struct RangeMemory {
    std::array<std::vector<Real>, 6> ends;  ///< -lo of x, y, z, then hi
    std::vector<Real> neg_lo, hi;           ///< of f
    std::vector<ContinuityMask<Real>> continuous;

    [[nodiscard]] std::size_t capacity() const { return hi.size(); }
    void resize(std::size_t capacity) {
        for (std::vector<Real>& column : ends)
            column.resize(capacity);
        neg_lo.resize(capacity);
        hi.resize(capacity);
        continuous.resize(capacity);
    }
};

/// Boxes around parts of the view, and what the range kernel says of them.
template <class Real>
class RangeList {
public:
    RangeList(const TraceFrame& frame, const BeamView& view, RangeMemory<Real>& memory,
              Counters& counters)
        : frame_(frame), view_(view), memory_(memory), counters_(counters) {}

    void clear() { size_ = 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Around the points with |u - u_i| <= u_radius, |v - v_i| <= v_radius at depths from s to t.
    void push(double u, double v, double u_radius, double v_radius, double s, double t);
    /// On a pixel's ray.
    void push(std::uint32_t pixel, double s, double t) {
        push(view_.u(pixel % tile_size), view_.v(pixel / tile_size), 0.0, 0.0, s, t);
    }
    void evaluate(const Kernel& kernel);

    /// Whether f is surely nowhere 0 in the box.
    [[nodiscard]] bool excludes_zero(std::size_t i) const {
        return memory_.neg_lo[i] < 0 || memory_.hi[i] < 0;
    }
    /// +1 or -1 where f surely has that sign, else 0.
    [[nodiscard]] int sign(std::size_t i) const {
        return static_cast<int>(memory_.neg_lo[i] < 0) - static_cast<int>(memory_.hi[i] < 0);
    }
    [[nodiscard]] bool continuous(std::size_t i) const { return memory_.continuous[i] != 0; }

private:
    const TraceFrame& frame_;
    const BeamView& view_;
    RangeMemory<Real>& memory_;
    Counters& counters_;
    std::size_t size_ = 0;
};

template <class Real>
void RangeList<Real>::push(double u, double v, double u_radius, double v_radius, double s,
                           double t) {
    if (size_ + batch_multiple >= memory_.capacity())
        memory_.resize(2 * memory_.capacity() + 4 * batch_multiple);
    const ViewFrame& axes = view_.axes();
    for (int k = 0; k < 3; ++k) {
        // Linear in u and v, and in the depth: extremes are at the corners.
        const double across = u * axes.right[k] + v * axes.up[k];
        const double aside = std::abs(axes.right[k]) * u_radius + std::abs(axes.up[k]) * v_radius;
        const double near =
            view_.base()[k] + view_.distance() * across + s * (axes.forward[k] + across);
        const double far =
            view_.base()[k] + view_.distance() * across + t * (axes.forward[k] + across);
        const double near_aside = aside * std::abs(view_.distance() + s) + view_.depth_error();
        const double far_aside = aside * std::abs(view_.distance() + t) + view_.depth_error();
        const auto axis = static_cast<std::size_t>(k);
        memory_.ends[axis][size_] = upper_end(Real{}, std::max(near_aside - near, far_aside - far));
        memory_.ends[axis + 3][size_] =
            upper_end(Real{}, std::max(near + near_aside, far + far_aside));
    }
    ++size_;
}

template <class Real>
void RangeList<Real>::evaluate(const Kernel& kernel) {
    if (size_ == 0) return;
    for (std::vector<Real>& column : memory_.ends) {
        for (std::size_t i = size_; i < padded(size_); ++i)
            column[i] = column[0];
    }
    counters_.range += size_;
    kernel.range(
        RangeBatchOf<Real>{padded(size_),
                           {memory_.ends[0].data(), memory_.ends[1].data(), memory_.ends[2].data()},
                           {memory_.ends[3].data(), memory_.ends[4].data(), memory_.ends[5].data()},
                           frame_.scene.uniforms.template boxes<Real>(),
                           memory_.neg_lo.data(),
                           memory_.hi.data(),
                           memory_.continuous.data()});
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
