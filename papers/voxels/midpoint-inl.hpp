// The simple midpoint algorithm [Marmitt04, sec. 3.1]: a voxel whose corners are on both sides of
// rho_iso is hit in the middle between t_in and t_out. Only the walk looks at the corners.

#if defined(ZEROSET_MIDPOINT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_MIDPOINT_INL
#undef ZEROSET_MIDPOINT_INL
#else
#define ZEROSET_MIDPOINT_INL
#endif

#include "papers/voxels/voxel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

struct Midpoint {
    template <class D>
    static HWY_INLINE hn::Vec<D> first_hit(D tag, const VoxelLanes<D>& voxel) {
        return hn::Mul(hn::Set(tag, 0.5F), voxel.t_out);
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
