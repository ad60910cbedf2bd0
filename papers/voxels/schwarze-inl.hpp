// Schwarze's analytic inversion: all roots of the cubic by Cardano's formula [Sch90; Marmitt04,
// sec. 2.1]. The nearest in the voxel is the hit.
//   p, q, D    of the cubic x^3 + 3 p x + 2 q with x = tau + A / 3, D = q^2 + p^3
//   tau        t / t_out, from 0 to 1 in the voxel
// Differs from the source: in floats, as the paper does it, so that the source's 1e-9, below which
// numbers count as 0, is 2^-20 of the largest coefficient; cosines, their inverses and cubic roots
// are polynomials over lanes; a root may be beyond the voxel's ends by 2^-12 of the stretch, or
// rays would slip through where voxels meet.

#if defined(ZEROSET_SCHWARZE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_SCHWARZE_INL
#undef ZEROSET_SCHWARZE_INL
#else
#define ZEROSET_SCHWARZE_INL
#endif

#include "papers/voxels/cubic-inl.hpp"
#include "papers/voxels/voxel_lanes-inl.hpp"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

struct Schwarze {
    template <class D>
    static HWY_INLINE hn::Vec<D> first_hit(D tag, const VoxelLanes<D>& voxel) {
        using V = hn::Vec<D>;
        const Cubic<D> f = cubic_of(tag, voxel);
        const V t = voxel.t_out;
        const V a = hn::Mul(f.t3, hn::Mul(t, hn::Mul(t, t)));
        const V b = hn::Mul(f.t2, hn::Mul(t, t));
        const V c = hn::Mul(f.t1, t);
        const V largest =
            hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Max(hn::Abs(c), hn::Abs(f.t0)));
        const V small = hn::Mul(hn::Set(tag, 0x1p-20F), largest);
        const hn::Mask<D> is_cubic = hn::Gt(hn::Abs(a), small);
        const hn::Mask<D> is_quadratic = hn::AndNot(is_cubic, hn::Gt(hn::Abs(b), small));
        V tau = no_hit(tag);
        if (!hn::AllFalse(tag, is_cubic)) {
            const V roots = cubic(tag, hn::Div(b, a), hn::Div(c, a), hn::Div(f.t0, a));
            tau = hn::IfThenElse(is_cubic, roots, tau);
        }
        if (!hn::AllFalse(tag, is_quadratic))
            tau =
                hn::IfThenElse(is_quadratic, quadratic(tag, hn::Div(c, b), hn::Div(f.t0, b)), tau);
        const hn::Mask<D> is_linear = hn::Not(hn::Or(is_cubic, is_quadratic));
        if (!hn::AllFalse(tag, is_linear)) {
            const V root = nearer(tag, hn::Neg(hn::Div(f.t0, c)), no_hit(tag));
            tau = hn::IfThenElse(is_linear, root, tau);
        }
        return hn::Mul(tau, t);
    }

private:
    /// The nearer of a root, if it is in the voxel, and of one that is known.
    template <class D>
    static HWY_INLINE hn::Vec<D> nearer(D tag, hn::Vec<D> root, hn::Vec<D> known) {
        constexpr float beyond = 0x1p-12F;
        const hn::Mask<D> within =
            hn::And(hn::Ge(root, hn::Set(tag, -beyond)), hn::Le(root, hn::Set(tag, 1.0F + beyond)));
        return hn::IfThenElse(within, hn::Min(root, known), known);
    }
    template <class V>
    static HWY_INLINE V cubic_root(V x) {
        const hn::DFromV<V> tag;
        const V size = hn::Abs(x);
        const V root = hn::Exp(tag, hn::Mul(hn::Set(tag, 1.0F / 3.0F), hn::Log(tag, size)));
        const V zero = hn::Zero(tag);
        return hn::IfThenElse(hn::Eq(size, zero), zero, hn::CopySign(root, x));
    }
    /// x^2 + c x + d
    template <class D>
    static HWY_INLINE hn::Vec<D> quadratic(D tag, hn::Vec<D> c, hn::Vec<D> d) {
        using V = hn::Vec<D>;
        const V p = hn::Mul(hn::Set(tag, 0.5F), c);
        const V root = hn::Sqrt(hn::Sub(hn::Mul(p, p), d));  // NaN: there is none
        return nearer(tag, hn::Sub(root, p), nearer(tag, hn::Neg(hn::Add(root, p)), no_hit(tag)));
    }
    /// x^3 + b x^2 + c x + d
    template <class D>
    static HWY_INLINE hn::Vec<D> cubic(D tag, hn::Vec<D> b, hn::Vec<D> c, hn::Vec<D> d) {
        using V = hn::Vec<D>;
        const auto number = [&](float x) HWY_ATTR { return hn::Set(tag, x); };
        const V third = hn::Mul(number(1.0F / 3.0F), b);
        const V p = hn::Sub(hn::Mul(number(1.0F / 3.0F), c), hn::Mul(third, third));
        const V q =
            hn::Mul(number(0.5F),
                    hn::Add(hn::Sub(hn::Mul(hn::Mul(number(2.0F), third), hn::Mul(third, third)),
                                    hn::Mul(third, c)),
                            d));
        const V cubed = hn::Mul(p, hn::Mul(p, p));
        const V discriminant = hn::MulAdd(q, q, cubed);
        const hn::Mask<D> has_three = hn::Lt(discriminant, hn::Zero(tag));
        V found = no_hit(tag);
        if (!hn::AllFalse(tag, has_three)) {
            const V one = number(1.0F);
            const V cosine = hn::Div(hn::Neg(q), hn::Sqrt(hn::Neg(cubed)));
            const V phi = hn::Mul(number(1.0F / 3.0F),
                                  hn::Acos(tag, hn::Max(hn::Min(cosine, one), hn::Neg(one))));
            const V size = hn::Mul(number(2.0F), hn::Sqrt(hn::Neg(p)));
            const V sixth_turn = number(1.0471975512F);
            V nearest = no_hit(tag);
            const V first = hn::Mul(size, hn::Cos(tag, phi));
            const V second = hn::Mul(size, hn::Cos(tag, hn::Add(phi, sixth_turn)));
            const V last = hn::Mul(size, hn::Cos(tag, hn::Sub(phi, sixth_turn)));
            nearest = nearer(tag, hn::Sub(first, third), nearest);
            nearest = nearer(tag, hn::Neg(hn::Add(second, third)), nearest);
            nearest = nearer(tag, hn::Neg(hn::Add(last, third)), nearest);
            found = hn::IfThenElse(has_three, nearest, found);
        }
        if (hn::AllTrue(tag, has_three)) return found;
        const V root = hn::Sqrt(hn::Max(discriminant, hn::Zero(tag)));
        const V u = cubic_root(hn::Sub(root, q));
        const V v = hn::Neg(cubic_root(hn::Add(root, q)));
        V nearest = nearer(tag, hn::Sub(hn::Add(u, v), third), no_hit(tag));
        // Where D is 0 there is a double root besides.
        const hn::Mask<D> doubled = hn::Le(discriminant, hn::Mul(number(0x1p-20F), hn::Mul(q, q)));
        const V twice =
            nearer(tag, hn::Neg(hn::MulAdd(number(0.5F), hn::Add(u, v), third)), nearest);
        nearest = hn::IfThenElse(doubled, twice, nearest);
        return hn::IfThenElse(has_three, found, nearest);
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
