// Isolation and iterative root finding [Marmitt04, sec. 4, algorithm 3].
//   f          the cubic of the density along the ray, less rho_iso
//   e_0, e_1   its extrema, the roots of f'(t) = 3 A t^2 + 2 B t + C
//   t_0, t_1   the ends of the first part between extrema in which f changes its sign
// Differs from the paper: the extrema come from the sum whose terms have equal signs, and from
// Vieta's rule the other one, as floats lose digits in the difference; and lanes do both of each
// test, as in the paper's SIMD version.

#if defined(ZEROSET_MARMITT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_MARMITT_INL
#undef ZEROSET_MARMITT_INL
#else
#define ZEROSET_MARMITT_INL
#endif

#include "papers/voxels/cubic-inl.hpp"
#include "papers/voxels/voxel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

struct Marmitt {
    template <class D>
    static HWY_INLINE hn::Vec<D> first_hit(D tag, const VoxelLanes<D>& voxel) {
        using V = hn::Vec<D>;
        const Cubic<D> f = cubic_of(tag, voxel);
        Part<D> part{.t_0 = hn::Zero(tag), .t_1 = voxel.t_out, .f_0 = f.t0, .f_1 = f(voxel.t_out)};
        const V b = f.t2;
        const V a_3 = hn::Mul(hn::Set(tag, 3.0F), f.t3);
        const V radicand = hn::Sub(hn::Mul(b, b), hn::Mul(a_3, f.t1));
        if (!hn::AllFalse(tag, hn::Ge(radicand, hn::Zero(tag)))) {
            // NaN where f' has no real roots: then all tests below fail.
            const V q = hn::Neg(hn::Add(b, hn::CopySign(hn::Sqrt(radicand), b)));
            const V one = hn::Div(q, a_3);
            const V other = hn::Div(f.t1, q);
            const hn::Mask<D> in_order = hn::Lt(one, other);
            part.cut_at(tag, hn::IfThenElse(in_order, one, other), f);
            part.cut_at(tag, hn::IfThenElse(in_order, other, one), f);
        }
        const hn::Mask<D> hit = differ_in_sign(tag, part.f_0, part.f_1);
        if (hn::AllFalse(tag, hit)) return no_hit(tag);
        const V t = repeatedly_interpolated(tag, part.t_0, part.t_1, part.f_0, part.f_1, f);
        return hn::IfThenElse(hit, t, no_hit(tag));
    }

private:
    /// A part of the ray that holds its first root, if there is one.
    template <class D>
    struct Part {
        hn::Vec<D> t_0, t_1, f_0, f_1;

        /// Keeps what is before or behind e, where e is within it.
        HWY_INLINE void cut_at(D tag, hn::Vec<D> e, const Cubic<D>& f) {
            const hn::Mask<D> within = hn::And(hn::Ge(e, t_0), hn::Le(e, t_1));
            const hn::Vec<D> f_e = f(e);
            const hn::Mask<D> differ = differ_in_sign(tag, f_e, f_0);
            const hn::Mask<D> ends = hn::And(within, differ);
            const hn::Mask<D> begins = hn::AndNot(differ, within);
            t_0 = hn::IfThenElse(begins, e, t_0);
            f_0 = hn::IfThenElse(begins, f_e, f_0);
            t_1 = hn::IfThenElse(ends, e, t_1);
            f_1 = hn::IfThenElse(ends, f_e, f_1);
        }
    };
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
