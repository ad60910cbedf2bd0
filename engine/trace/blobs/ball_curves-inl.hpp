// Bounds of the second derivatives of soft balls' heights by q (engine/blobs/blob_kind.hpp).
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BALL_CURVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BALL_CURVES_INL
#undef ZEROSET_BALL_CURVES_INL
#else
#define ZEROSET_BALL_CURVES_INL
#endif

#include "engine/blobs/blob_heights-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Bounds of h'' between two q.
template <class Vector>
struct CurvesOf {
    Vector least, most;
};
template <BlobKind kind, class D, class Vector>
HWY_INLINE CurvesOf<Vector> curves_between(D tag, Vector lo, Vector hi) {
    namespace hn = hwy::HWY_NAMESPACE;
    const auto number = [&](double x) { return hn::Set(tag, static_cast<hn::TFromD<D>>(x)); };
    const Vector reach = number(blob_facts(kind).reach);
    const auto curve_at = [&](Vector q) {
        if constexpr (kind == BlobKind::Wyvill) {
            return hn::NegMulAdd(q, number(1.0 / 12), number(17.0 / 36));
        } else if constexpr (kind == BlobKind::Metaball) {
            const Vector outside = hn::Max(q, number(4.0 / 9));
            return hn::Div(number(1), hn::Mul(outside, hn::Sqrt(outside)));
        } else {
            return hn::Mul(number(4), height_at<kind, Rounds::Once>(tag, q).value);
        }
    };
    // Take h'' at the ends: it falls with q; metaballs' is 0 up to 4/9.
    Vector most = curve_at(hn::Min(lo, reach));
    Vector least = hn::IfThenElseZero(hn::Lt(hi, reach), curve_at(hn::Min(hi, reach)));
    if constexpr (kind == BlobKind::Metaball) {
        least = hn::IfThenElseZero(hn::Gt(lo, number(4.0 / 9)), least);
        most = hn::IfThenElseZero(hn::Ge(hi, number(4.0 / 9)), most);
    }
    return {.least = least, .most = most};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
