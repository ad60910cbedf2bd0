// Neubauer's repeated linear interpolation [NMHW02; Marmitt04, sec. 3.3, algorithm 2].
//   t_0, t_1       the ends of the part of the ray that is looked at
//   rho_0, rho_1   the densities there, less rho_iso, all trilinear
// Misses two roots in a voxel, and may find the last of three.

#if defined(ZEROSET_NEUBAUER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_NEUBAUER_INL
#undef ZEROSET_NEUBAUER_INL
#else
#define ZEROSET_NEUBAUER_INL
#endif

#include "papers/voxels/voxel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

struct Neubauer {
    template <class D>
    static HWY_INLINE hn::Vec<D> first_hit(D tag, const VoxelLanes<D>& voxel) {
        const hn::Vec<D> t_0 = hn::Zero(tag);
        const hn::Vec<D> rho_0 = voxel.at(t_0);
        const hn::Vec<D> rho_1 = voxel.at(voxel.t_out);
        const hn::Mask<D> hit = differ_in_sign(tag, rho_0, rho_1);
        if (hn::AllFalse(tag, hit)) return no_hit(tag);
        const hn::Vec<D> t =
            repeatedly_interpolated(tag, t_0, voxel.t_out, rho_0, rho_1,
                                    [&](hn::Vec<D> at) HWY_ATTR { return voxel.at(at); });
        return hn::IfThenElse(hit, t, no_hit(tag));
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
