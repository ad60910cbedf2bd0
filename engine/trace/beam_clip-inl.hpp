// Where rays are inside the clip box.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_CLIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_CLIP_INL
#undef ZEROSET_BEAM_CLIP_INL
#else
#define ZEROSET_BEAM_CLIP_INL
#endif

#include "engine/trace/beam_cells-inl.hpp"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

using ClipTag = hn::CappedTag<double, 4>;
constexpr int clip_lanes = hn::MaxLanes(ClipTag());

/// Where some rays enter and leave the part of the clip box in front of the eye, as depths.
class ClipDepths {
public:
    ClipDepths(const BeamView& view, const float* cols, const float* rows)
        : enter_lo_(hn::Set(dd, -view.distance() - view.depth_error())),
          enter_hi_(hn::Set(dd, -view.distance() + view.depth_error())) {
        const auto col = load_doubles(dd, cols);
        const auto row = load_doubles(dd, rows);
        const RaysOf<double>& rays = view.double_rays();
        for (int k = 0; k < 3; ++k) {
            const auto line = [&](const double* base, const double* by_col, const double* by_row) {
                return hn::MulAdd(row, hn::Set(dd, by_row[k]),
                                  hn::MulAdd(col, hn::Set(dd, by_col[k]), hn::Set(dd, base[k])));
            };
            const auto origin = line(rays.origin, rays.origin_by_col, rays.origin_by_row);
            const auto direction =
                line(rays.direction, rays.direction_by_col, rays.direction_by_row);
            const auto inverse = hn::Div(hn::Set(dd, 1.0), direction);
            const auto error = hn::Mul(hn::Set(dd, view.depth_error()), hn::Abs(inverse));
            const auto a = hn::Mul(hn::Sub(hn::Set(dd, view.clip().lo[k]), origin), inverse);
            const auto b = hn::Mul(hn::Sub(hn::Set(dd, view.clip().hi[k]), origin), inverse);
            const auto enter = hn::Min(a, b);
            const auto exit = hn::Max(a, b);
            known_ = hn::And(known_, hn::Eq(hn::Add(enter, error), hn::Add(enter, error)));
            enter_lo_ = hn::Max(enter_lo_, hn::Sub(enter, error));
            enter_hi_ = hn::Max(enter_hi_, hn::Add(enter, error));
            exit_lo_ = hn::Min(exit_lo_, hn::Sub(exit, error));
            exit_hi_ = hn::Min(exit_hi_, hn::Add(exit, error));
        }
    }
    /// Of brackets of roots.
    template <class Real>
    [[nodiscard]] LaneBits surely_inside(const Real* lo, const Real* hi) const {
        return bits_of(dd, hn::And(known_, hn::And(hn::Ge(load_doubles(dd, lo), enter_hi_),
                                                   hn::Le(load_doubles(dd, hi), exit_lo_))));
    }
    template <class Real>
    [[nodiscard]] LaneBits surely_outside(const Real* lo, const Real* hi) const {
        return bits_of(dd, hn::And(known_, hn::Or(hn::Lt(load_doubles(dd, hi), enter_lo_),
                                                  hn::Gt(load_doubles(dd, lo), exit_hi_))));
    }
    /// Takes away what is surely outside, of stretches of the rays.
    void narrow(hn::Vec<ClipTag>& from, hn::Vec<ClipTag>& to) const {
        from = hn::IfThenElse(known_, hn::Max(from, enter_lo_), from);
        to = hn::IfThenElse(known_, hn::Min(to, exit_hi_), to);
    }

private:
    static constexpr ClipTag dd{};
    using V = hn::Vec<ClipTag>;

    hn::Mask<ClipTag> known_ = hn::Eq(hn::Zero(dd), hn::Zero(dd));
    V enter_lo_, enter_hi_;
    V exit_lo_ = hn::Set(dd, std::numeric_limits<double>::infinity());
    V exit_hi_ = exit_lo_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
