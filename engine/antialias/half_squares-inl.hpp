// Parts of squares on one side of lines, as half_square.hpp has them, for vectors of squares.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_HALF_SQUARES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_HALF_SQUARES_INL
#undef ZEROSET_HALF_SQUARES_INL
#else
#define ZEROSET_HALF_SQUARES_INL
#endif

#include "engine/antialias/numbers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// LinearOnSquare for a vector of squares.
struct LinearOnSquares {
    V<double> value, by_x, by_y;
};

/// SquarePart for a vector of squares.
struct SquareParts {
    V<double> share, x, y;
};

/// The parts about a corner, as corner_part in half_square.cpp.
HWY_INLINE SquareParts corner_parts(V<double> max, V<double> min, V<double> depth) {
    const V<double> third = number(1.0 / 3.0);
    const V<double> per_max = hn::Div(number(1.0), max);
    const V<double> first = hn::Mul(depth, per_max);
    // A triangle at the corner, or from side to side: so far at the one and at the other.
    const V<double> beyond = hn::NegMulAdd(number(2.0), min, depth);
    const M<double> triangle = hn::Le(beyond, hn::Zero(d<double>));
    const V<double> height = hn::Div(depth, min);
    const V<double> last = hn::Mul(beyond, per_max);
    const V<double> sum = hn::Add(first, last);
    const V<double> per_sum = hn::Div(third, sum);
    const V<double> squares =
        hn::MulAdd(first, first, hn::MulAdd(first, last, hn::Mul(last, last)));
    const V<double> twice = hn::MulAdd(number(2.0), first, hn::Mul(number(4.0), last));
    return {.share = hn::IfThenElse(triangle, hn::Mul(number(0.125), hn::Mul(first, height)),
                                    hn::Mul(number(0.25), sum)),
            .x = hn::IfThenElse(triangle, hn::Mul(first, third), hn::Mul(squares, per_sum)),
            .y = hn::IfThenElse(triangle, hn::Mul(height, third), hn::Mul(twice, per_sum))};
}

/// part_below_zero for a vector of squares.
HWY_INLINE SquareParts parts_below_zero(const LinearOnSquares& f) {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> one = number(1.0);
    const M<double> is_rest = hn::Not(hn::Gt(f.value, zero));
    const V<double> by_x = hn::Abs(f.by_x);
    const V<double> by_y = hn::Abs(f.by_y);
    const V<double> depth = hn::Sub(hn::Add(by_x, by_y), hn::Abs(f.value));
    const M<double> any = hn::Gt(depth, zero);
    const M<double> along_x = hn::Gt(by_x, by_y);
    const SquareParts corner = corner_parts(hn::Max(by_x, by_y), hn::Min(by_x, by_y), depth);
    const V<double> share = hn::IfThenElseZero(any, corner.share);
    const V<double> x = hn::Sub(hn::IfThenElse(along_x, corner.x, corner.y), one);
    const V<double> y = hn::Sub(hn::IfThenElse(along_x, corner.y, corner.x), one);
    // Place the part from the corner where f is least, or greatest; the rest is opposite.
    const auto placed = [&](V<double> at, V<double> by) {
        const M<double> kept = hn::Xor(hn::Gt(by, zero), is_rest);
        return hn::IfThenElseZero(any, hn::IfThenElse(kept, at, hn::Neg(at)));
    };
    const V<double> of_rest = hn::Sub(one, share);
    const V<double> scale = hn::IfThenElse(is_rest, hn::Neg(hn::Div(share, of_rest)), one);
    return {.share = hn::IfThenElse(is_rest, of_rest, share),
            .x = hn::Mul(scale, placed(x, f.by_x)),
            .y = hn::Mul(scale, placed(y, f.by_y))};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
