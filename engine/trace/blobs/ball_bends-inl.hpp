// Second derivatives of soft balls' heights along lines (engine/blobs/blob_kind.hpp), and their
// bounds. Included once for each instruction set, after Highway.

#if defined(ZEROSET_BALL_BENDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BALL_BENDS_INL
#undef ZEROSET_BALL_BENDS_INL
#else
#define ZEROSET_BALL_BENDS_INL
#endif

#include "engine/blobs/blob_heights-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// h's second derivative along a line where q is this, by the square of the length, for radius 1:
/// 2 h' + 4 (q - least) h''. `least`: of q on the line.
template <BlobKind kind, class D, class Vector>
HWY_INLINE Vector bend_at(D tag, Vector q, Vector least) {
    namespace hn = hwy::HWY_NAMESPACE;
    const auto number = [&](double x) { return hn::Set(tag, static_cast<hn::TFromD<D>>(x)); };
    if constexpr (kind == BlobKind::Wyvill) {
        const Vector alone =
            hn::MulAdd(q, hn::MulAdd(q, number(-5.0 / 12), number(17.0 / 6)), number(-22.0 / 9));
        const Vector less = hn::MulAdd(q, number(-1.0 / 3), number(17.0 / 9));
        return hn::NegMulAdd(least, less, alone);
    } else if constexpr (kind == BlobKind::Metaball) {
        const Vector outside = hn::Max(q, number(4.0 / 9));
        const Vector less = hn::Div(hn::Mul(number(4), least), hn::Mul(outside, hn::Sqrt(outside)));
        // Just below 4/9, where it is -4, the larger one of both is taken.
        return hn::IfThenElse(hn::Le(q, number(0.44)), number(-4), hn::Sub(number(2), less));
    } else {
        const Vector h = height_at<kind, Rounds::Once>(tag, q).value;
        const Vector factor = hn::MulAdd(number(16), hn::Sub(q, least), number(-4));
        return hn::Mul(factor, h);
    }
}

/// A stretch of a line: the smallest and the largest q there, up to the reach, and the least on the
/// whole line.
template <class Vector>
struct StretchOf {
    Vector from, to, least;
};

/// The least upper bound of bend_at on a stretch, of a height that is 0 from the reach on: it rises
/// up to some q, then it falls; and is not below 0 at the reach.
template <BlobKind kind, class D, class Vector>
HWY_INLINE Vector most_bend(D tag, const StretchOf<Vector>& on) {
    namespace hn = hwy::HWY_NAMESPACE;
    const auto number = [&](double x) { return hn::Set(tag, static_cast<hn::TFromD<D>>(x)); };
    Vector top = on.to;
    if constexpr (kind == BlobKind::Wyvill) top = hn::MulAdd(number(0.4), on.least, number(3.4));
    if constexpr (kind == BlobKind::Blinn) top = hn::Add(on.least, number(0.75));
    return bend_at<kind>(tag, hn::Max(hn::Min(on.to, top), on.from), on.least);
}

/// The greatest lower bound of bend_at on a stretch, or 0 where that is above 0.
template <BlobKind kind, class D, class Vector>
HWY_INLINE Vector least_bend(D tag, const StretchOf<Vector>& on) {
    namespace hn = hwy::HWY_NAMESPACE;
    const auto number = [&](double x) { return hn::Set(tag, static_cast<hn::TFromD<D>>(x)); };
    const Vector first = hn::Min(bend_at<kind>(tag, on.from, on.least), hn::Zero(tag));
    // Metaballs' is -4 up to q = 4/9, and rises from there on.
    if constexpr (kind == BlobKind::Metaball) {
        return hn::IfThenElse(hn::Le(on.from, number(0.45)), number(-4), first);
    } else {
        return hn::Min(first, bend_at<kind>(tag, on.to, on.least));
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
