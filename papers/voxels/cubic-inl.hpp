// The density along a ray in a voxel as a cubic, f(t) = A t^3 + B t^2 + C t + D [PSL98; Marmitt04,
// sec. 2].
// Differs from the paper: the coefficients come from the trilinear function's eight (1, u, v, w,
// uv, uw, vw, uvw) instead of sums over the corners, which takes a third of the operations.

#if defined(ZEROSET_CUBIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_CUBIC_INL
#undef ZEROSET_CUBIC_INL
#else
#define ZEROSET_CUBIC_INL
#endif

#include "papers/voxels/voxel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Tag>
struct Cubic {
    using V = hn::Vec<Tag>;

    V t3, t2, t1, t0;  ///< A, B, C and D

    HWY_INLINE V operator()(V t) const {
        return hn::MulAdd(hn::MulAdd(hn::MulAdd(t3, t, t2), t, t1), t, t0);
    }
};

template <class Tag>
HWY_INLINE Cubic<Tag> cubic_of(Tag /*tag*/, const VoxelLanes<Tag>& voxel) {
    using V = hn::Vec<Tag>;
    const V* const rho = voxel.rho;
    const V* const a = voxel.a;
    const V* const b = voxel.b;
    const V k_u = hn::Sub(rho[1], rho[0]);
    const V k_v = hn::Sub(rho[2], rho[0]);
    const V k_w = hn::Sub(rho[4], rho[0]);
    const V k_uv = hn::Sub(hn::Sub(rho[3], rho[2]), k_u);
    const V k_uw = hn::Sub(hn::Sub(rho[5], rho[4]), k_u);
    const V k_vw = hn::Sub(hn::Sub(rho[6], rho[4]), k_v);
    const V k_uvw = hn::Sub(hn::Sub(hn::Sub(rho[7], rho[6]), hn::Sub(rho[5], rho[4])), k_uv);
    // The slopes by u, v and w at a, and products of directions
    const V at_uv = hn::MulAdd(k_uvw, a[2], k_uv);
    const V at_uw = hn::MulAdd(k_uvw, a[1], k_uw);
    const V at_vw = hn::MulAdd(k_uvw, a[0], k_vw);
    const V slope_u = hn::MulAdd(at_uv, a[1], hn::MulAdd(k_uw, a[2], k_u));
    const V slope_v = hn::MulAdd(at_uv, a[0], hn::MulAdd(k_vw, a[2], k_v));
    const V slope_w = hn::MulAdd(at_uw, a[0], hn::MulAdd(k_vw, a[1], k_w));
    const V b_uv = hn::Mul(b[0], b[1]);
    const V b_uw = hn::Mul(b[0], b[2]);
    const V b_vw = hn::Mul(b[1], b[2]);
    Cubic<Tag> cubic;
    cubic.t3 = hn::Mul(k_uvw, hn::Mul(b_uv, b[2]));
    cubic.t2 = hn::MulAdd(at_uv, b_uv, hn::MulAdd(at_uw, b_uw, hn::Mul(at_vw, b_vw)));
    cubic.t1 = hn::MulAdd(slope_u, b[0], hn::MulAdd(slope_v, b[1], hn::Mul(slope_w, b[2])));
    cubic.t0 =
        hn::MulAdd(a[0], hn::MulAdd(a[1], at_uv, hn::MulAdd(a[2], k_uw, k_u)),
                   hn::MulAdd(a[1], hn::MulAdd(a[2], k_vw, k_v), hn::MulAdd(a[2], k_w, rho[0])));
    return cubic;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
