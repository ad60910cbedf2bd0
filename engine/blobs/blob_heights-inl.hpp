// The heights of soft balls (blob_kind.hpp) in vectors of floats or doubles.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BLOB_HEIGHTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BLOB_HEIGHTS_INL
#undef ZEROSET_BLOB_HEIGHTS_INL
#else
#define ZEROSET_BLOB_HEIGHTS_INL
#endif

#include "engine/blobs/blob_kind.hpp"

#include <hwy/highway.h>

#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// h and h' at q.
template <class Vector>
struct HeightOf {
    Vector value, slope;
};

/// Whether products and sums are rounded once, where the machine can.
enum class Rounds : std::uint8_t { Twice, Once };

template <Rounds rounds, class Vector>
HWY_INLINE Vector sum_of(Vector product_a, Vector product_b, Vector c) {
    namespace hn = hwy::HWY_NAMESPACE;
    if constexpr (rounds == Rounds::Once) {
        return hn::MulAdd(product_a, product_b, c);
    } else {
        return hn::Add(hn::Mul(product_a, product_b), c);
    }
}

/// exp(y) for -50 <= y <= 2, within some last places.
template <Rounds rounds, class D>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<D> exponential(D tag, hwy::HWY_NAMESPACE::Vec<D> y) {
    namespace hn = hwy::HWY_NAMESPACE;
    using Real = hn::TFromD<D>;
    constexpr bool is_float = std::is_same_v<Real, float>;
    constexpr int digits = is_float ? 23 : 52;
    const auto number = [&](double x) { return hn::Set(tag, static_cast<Real>(x)); };
    const auto n = hn::Floor(sum_of<rounds>(y, number(1.4426950408889634), number(0.5)));
    // log 2 in two parts, of which the first one times n is exact.
    const double high = is_float ? 0x1.62ep-1 : 0x1.62e42fee00000p-1;
    const double low = is_float ? 0x1.0bfbe8e7bcd5ep-15 : 0x1.a39ef35793c76p-33;
    const auto r = hn::Sub(hn::Sub(y, hn::Mul(n, number(high))), hn::Mul(n, number(low)));
    auto sum = number(is_float ? 1.0 / 40320 : 1.0 / 6227020800);
    if constexpr (!is_float) {
        for (const double factor :
             {1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320})
            sum = sum_of<rounds>(sum, r, number(factor));
    }
    for (const double factor : {1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0})
        sum = sum_of<rounds>(sum, r, number(factor));
    // The last bits of n + 1.5 2^digits are those of the whole number n.
    const hn::RebindToUnsigned<D> bits;
    const auto moved = hn::Add(n, number(is_float ? 0x1.8p23 : 0x1.8p52));
    const auto shifted = hn::ShiftLeft<digits>(hn::BitCast(bits, moved));
    const auto one = hn::BitCast(bits, number(1));
    return hn::Mul(sum, hn::BitCast(tag, hn::Add(one, shifted)));
}

/// At q within the reach.
template <BlobKind kind, Rounds rounds, class D>
HWY_INLINE HeightOf<hwy::HWY_NAMESPACE::Vec<D>> height_at(D tag, hwy::HWY_NAMESPACE::Vec<D> q) {
    namespace hn = hwy::HWY_NAMESPACE;
    using Real = hn::TFromD<D>;
    const auto number = [&](double x) { return hn::Set(tag, static_cast<Real>(x)); };
    if constexpr (kind == BlobKind::Wyvill) {
        const auto bent = sum_of<rounds>(q, number(-1.0 / 72), number(17.0 / 72));
        const auto steep = sum_of<rounds>(q, bent, number(-11.0 / 9));
        const auto slope = sum_of<rounds>(q, number(-1.0 / 24), number(17.0 / 36));
        return {.value = sum_of<rounds>(q, steep, number(2)),
                .slope = sum_of<rounds>(q, slope, number(-11.0 / 9))};
    } else if constexpr (kind == BlobKind::Metaball) {
        const auto root = hn::Sqrt(q);
        const auto rest = hn::Sub(number(2), root);
        const auto near = hn::Le(q, number(4.0 / 9));
        const auto inner = sum_of<rounds>(q, number(-2), number(8.0 / 3));
        const auto far = hn::Sub(number(1), hn::Div(number(2), hn::Max(root, number(0.5))));
        return {.value = hn::IfThenElse(near, inner, hn::Mul(rest, rest)),
                .slope = hn::IfThenElse(near, number(-2), far)};
    } else {
        const auto value = exponential<rounds>(tag, sum_of<rounds>(q, number(-2), number(2)));
        return {.value = value, .slope = hn::Mul(number(-2), value)};
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
