// Linear interpolation between entry and exit [Marmitt04, sec. 3.2, algorithm 1].
//   rho_in, rho_out   the densities there, less rho_iso, both trilinear
// Misses two roots in a voxel.

#if defined(ZEROSET_LINEAR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_LINEAR_INL
#undef ZEROSET_LINEAR_INL
#else
#define ZEROSET_LINEAR_INL
#endif

#include "papers/voxels/voxel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

struct Linear {
    template <class D>
    static HWY_INLINE hn::Vec<D> first_hit(D tag, const VoxelLanes<D>& voxel) {
        const hn::Vec<D> t_in = hn::Zero(tag);
        const hn::Vec<D> rho_in = voxel.at(t_in);
        const hn::Vec<D> rho_out = voxel.at(voxel.t_out);
        const hn::Mask<D> hit = differ_in_sign(tag, rho_in, rho_out);
        if (hn::AllFalse(tag, hit)) return no_hit(tag);
        return hn::IfThenElse(hit, interpolated(t_in, voxel.t_out, rho_in, rho_out), no_hit(tag));
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
