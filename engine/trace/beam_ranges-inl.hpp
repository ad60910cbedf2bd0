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

/// Boxes around parts of the view, and what the range kernel says of them.
template <class Real>
class RangeList {
public:
    RangeList(const TraceFrame& frame, const BeamView& view, Counters& counters)
        : frame_(frame), view_(view), counters_(counters) {}

    void clear() { size_ = 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Around the points with |u - u_i| <= u_radius, |v - v_i| <= v_radius at depths from s to t.
    void push(double u, double v, double u_radius, double v_radius, double s, double t);
    /// On a pixel's ray.
    void push(std::uint32_t pixel, double s, double t) {
        push(view_.u(pixel % tile_size), view_.v(pixel / tile_size), 0.0, 0.0, s, t);
    }
    void evaluate();

    /// Whether f is surely not 0 in the box, nor anywhere undefined to both sides.
    [[nodiscard]] bool excludes_zero(std::size_t i) const { return neg_lo_[i] < 0 || hi_[i] < 0; }
    /// +1 or -1 where f surely has that sign, else 0.
    [[nodiscard]] int sign(std::size_t i) const {
        return static_cast<int>(neg_lo_[i] < 0) - static_cast<int>(hi_[i] < 0);
    }
    [[nodiscard]] bool continuous(std::size_t i) const { return continuous_[i] != 0; }

private:
    void reserve_one();

    const TraceFrame& frame_;
    const BeamView& view_;
    Counters& counters_;
    std::size_t size_ = 0;
    std::array<std::vector<Real>, 6> ends_;  ///< -lo of x, y, z, then hi
    std::vector<Real> neg_lo_, hi_;          ///< of f
    std::vector<ContinuityMask<Real>> continuous_;
};

template <class Real>
void RangeList<Real>::reserve_one() {
    if (size_ + batch_multiple < hi_.size()) return;
    const std::size_t capacity = 2 * hi_.size() + 4 * batch_multiple;
    for (std::vector<Real>& column : ends_)
        column.resize(capacity);
    neg_lo_.resize(capacity);
    hi_.resize(capacity);
    continuous_.resize(capacity);
}

template <class Real>
void RangeList<Real>::push(double u, double v, double u_radius, double v_radius, double s,
                           double t) {
    reserve_one();
    const ViewFrame& axes = view_.axes();
    for (int k = 0; k < 3; ++k) {
        // Linear in u and v, and in the depth: extremes are at the corners.
        const double across = u * axes.right[k] + v * axes.up[k];
        const double aside = std::abs(axes.right[k]) * u_radius + std::abs(axes.up[k]) * v_radius;
        const double near = view_.base()[k] + view_.distance() * across +
                            s * (axes.forward[k] + across);
        const double far = view_.base()[k] + view_.distance() * across +
                           t * (axes.forward[k] + across);
        const double near_aside = aside * std::abs(view_.distance() + s) + view_.depth_error();
        const double far_aside = aside * std::abs(view_.distance() + t) + view_.depth_error();
        const auto axis = static_cast<std::size_t>(k);
        ends_[axis][size_] = upper_end(Real{}, std::max(near_aside - near, far_aside - far));
        ends_[axis + 3][size_] = upper_end(Real{}, std::max(near + near_aside, far + far_aside));
    }
    ++size_;
}

template <class Real>
void RangeList<Real>::evaluate() {
    if (size_ == 0) return;
    for (std::vector<Real>& column : ends_) {
        for (std::size_t i = size_; i < padded(size_); ++i)
            column[i] = column[0];
    }
    counters_.range += size_;
    frame_.kernel.range(RangeBatchOf<Real>{padded(size_),
                                           {ends_[0].data(), ends_[1].data(), ends_[2].data()},
                                           {ends_[3].data(), ends_[4].data(), ends_[5].data()},
                                           frame_.scene.uniforms.template boxes<Real>(),
                                           neg_lo_.data(),
                                           hi_.data(),
                                           continuous_.data()});
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
