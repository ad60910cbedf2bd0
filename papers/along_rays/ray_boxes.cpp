#include "papers/along_rays/ray_boxes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "papers/along_rays/ray_boxes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Stores doubles, rounded upward.
HWY_INLINE void store_upward(V<double> values, double* to) { hn::StoreU(values, d<double>, to); }
HWY_INLINE void store_upward(V<double> values, float* to) {
    constexpr hn::Rebind<float, Tag<double>> narrow{};
    hn::StoreU(hn::DemoteTo(narrow, values), narrow, to);
}

template <class Real>
void make_boxes(const RaySpanArrays& spans, std::size_t count, const std::array<Real*, 6>& ends) {
    // The product and the sum are off by less than 2^-52 (|s direction| + |s direction + origin|).
    const V<double> unit = number(0x1p-50);
    for (std::size_t i = 0; i < count; i += lanes<double>) {
        const V<double> from = hn::LoadU(d<double>, spans.from + i);
        const V<double> to = hn::LoadU(d<double>, spans.to + i);
        for (std::size_t k = 0; k < 3; ++k) {
            const V<double> origin = hn::LoadU(d<double>, spans.origin[k] + i);
            const V<double> direction = hn::LoadU(d<double>, spans.direction[k] + i);
            const V<double> near = hn::MulAdd(from, direction, origin);
            const V<double> far = hn::MulAdd(to, direction, origin);
            const V<double> most = hn::Max(hn::Abs(near), hn::Abs(far));
            const V<double> spare = hn::Mul(unit, hn::Max(most, hn::Abs(origin)));
            store_upward(hn::Sub(spare, hn::Min(near, far)), ends[k] + i);
            store_upward(hn::Add(spare, hn::Max(near, far)), ends[k + 3] + i);
        }
    }
}

void make_float_boxes(const RaySpanArrays& spans, std::size_t count,
                      const std::array<float*, 6>& ends) {
    make_boxes(spans, count, ends);
}
void make_double_boxes(const RaySpanArrays& spans, std::size_t count,
                       const std::array<double*, 6>& ends) {
    make_boxes(spans, count, ends);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(make_float_boxes);
HWY_EXPORT(make_double_boxes);

void make_ray_boxes(const RaySpanArrays& spans, std::size_t count,
                    const std::array<float*, 6>& ends) {
    HWY_DYNAMIC_DISPATCH(make_float_boxes)(spans, count, ends);
}
void make_ray_boxes(const RaySpanArrays& spans, std::size_t count,
                    const std::array<double*, 6>& ends) {
    HWY_DYNAMIC_DISPATCH(make_double_boxes)(spans, count, ends);
}

}  // namespace zeroset

#endif
