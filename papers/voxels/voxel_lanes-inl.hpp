// Rays in voxels, one a lane, and the words of the methods that intersect them [Marmitt04].
//   rho       the density less rho_iso, trilinear between the corners
//   R(t)      the ray a + t b, in the voxel from t_in = 0 to t_out
//   no_hit    +inf
// Differs from the paper: u, v and w go up with the coordinates, and t_in is 0, so that floats are
// finest in the voxel.

#if defined(ZEROSET_VOXEL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_VOXEL_LANES_INL
#undef ZEROSET_VOXEL_LANES_INL
#else
#define ZEROSET_VOXEL_LANES_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "papers/voxels/voxel_ray.hpp"

#include <hwy/highway.h>

#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// One ray a lane of D; a D of one lane is a single ray.
template <class D>
struct VoxelLanes {
    using V = hn::Vec<D>;

    V rho[8];
    V a[3], b[3];
    V t_out;

    /// rho(R(t)), trilinear.
    HWY_INLINE V at(V t) const {
        const V u = hn::MulAdd(t, b[0], a[0]);
        const V v = hn::MulAdd(t, b[1], a[1]);
        const V w = hn::MulAdd(t, b[2], a[2]);
        const auto mix = [](V from, V to, V share) {
            return hn::MulAdd(share, hn::Sub(to, from), from);
        };
        const V below = mix(mix(rho[0], rho[1], u), mix(rho[2], rho[3], u), v);
        const V above = mix(mix(rho[4], rho[5], u), mix(rho[6], rho[7], u), v);
        return mix(below, above, w);
    }
};

/// The rays whose columns of numbers begin at `column(0)`, `column(1)` and so on.
template <class D, class Column>
HWY_INLINE VoxelLanes<D> load_voxels(D tag, const Column& column) {
    VoxelLanes<D> voxels;
    for (std::size_t i = 0; i < 8; ++i)
        voxels.rho[i] = hn::LoadU(tag, column(i));
    for (std::size_t i = 0; i < 3; ++i) {
        voxels.a[i] = hn::LoadU(tag, column(8 + i));
        voxels.b[i] = hn::LoadU(tag, column(11 + i));
    }
    voxels.t_out = hn::LoadU(tag, column(14));
    return voxels;
}

template <class D>
HWY_INLINE hn::Vec<D> no_hit(D tag) {
    return hn::Set(tag, std::numeric_limits<float>::infinity());
}

/// Whether two numbers lie on different sides of 0; 0 itself counts as above.
template <class D>
HWY_INLINE hn::Mask<D> differ_in_sign(D tag, hn::Vec<D> x, hn::Vec<D> y) {
    const hn::Vec<D> zero = hn::Zero(tag);
    return hn::Xor(hn::Lt(x, zero), hn::Lt(y, zero));
}

/// Number of repeated linear interpolations; the paper recommends 2 or 3.
constexpr int interpolations = 3;

/// Where the line through (t_0, f_0) and (t_1, f_1) is 0.
template <class V>
HWY_INLINE V interpolated(V t_0, V t_1, V f_0, V f_1) {
    return hn::Sub(t_0, hn::Div(hn::Mul(hn::Sub(t_1, t_0), f_0), hn::Sub(f_1, f_0)));
}

/// The root between t_0 and t_1, where f has different signs, by repeated linear interpolation.
template <class D, class F>
HWY_INLINE hn::Vec<D> repeatedly_interpolated(D tag, hn::Vec<D> t_0, hn::Vec<D> t_1, hn::Vec<D> f_0,
                                              hn::Vec<D> f_1, const F& f) {
    for (int i = 0; i < interpolations; ++i) {
        const hn::Vec<D> t = interpolated(t_0, t_1, f_0, f_1);
        const hn::Vec<D> f_t = f(t);
        const hn::Mask<D> before = differ_in_sign(tag, f_t, f_0);
        t_1 = hn::IfThenElse(before, t, t_1);
        f_1 = hn::IfThenElse(before, f_t, f_1);
        t_0 = hn::IfThenElse(before, t_0, t);
        f_0 = hn::IfThenElse(before, f_0, f_t);
    }
    return interpolated(t_0, t_1, f_0, f_1);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
