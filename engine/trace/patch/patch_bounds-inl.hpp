// Bounds for Newton's method in float on a piece of a leaf.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_BOUNDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_BOUNDS_INL
#undef ZEROSET_PATCH_BOUNDS_INL
#else
#define ZEROSET_PATCH_BOUNDS_INL
#endif

#include "engine/trace/patch/patch_pieces-inl.hpp"

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Where Newton's method may go, and bounds of polynomials hold: |p|, |q| <= newton_limit.
constexpr double newton_limit = 1.125;

/// Bounds for the polynomials of a piece in each of (a, b, s), by the sums of the sizes of their
/// terms of each degree. In upward rounding.
struct NewtonBounds {
    /// Bounds of the sum of second derivatives, without those of the terms of degree 2, and of the
    /// rounding errors of slopes in float.
    double bend[4], slope_error[4];
    double square[4];  ///< of the second derivatives of the terms of degree 2
    /// Bounds of the rounding errors of terms in float where |p|, |q| <= 1. A term of degree n is
    /// rounded 2 n + 7 times at most, each time by 2^-23 of it.
    double error[4];

    /// `with_squares`: those of degree 2 are added in double.
    NewtonBounds(const Piece& piece, bool with_squares) {
        const D4 d4;
        for (std::size_t k = 0; k < 4; k += step4) {
            V4 all[3] = {hn::Zero(d4), hn::Zero(d4), hn::Zero(d4)};
            double power = 1.0;  // newton_limit^(n - 1)
            for (int n = 1; n <= piece.first_degree; ++n, power *= newton_limit) {
                const V4 size = hn::Load(d4, piece.sizes[static_cast<std::size_t>(n)].data() + k);
                const auto add = [&](V4& to, double factor)
                                     HWY_ATTR { to = hn::MulAdd(size, hn::Set(d4, factor), to); };
                if (n == 2) hn::StoreU(hn::Add(size, size), d4, square + k);
                // Products with the second derivatives are rounded, too.
                add(all[0], n * (n - 1) * power / newton_limit * (n == 2 ? 0x1p-19 : 1.0));
                // Each product and sum is rounded twice where the machine has no fused ones.
                if (n > 2 || (n == 2 && !with_squares)) add(all[1], 0x1p-23 * (2 * n + 8));
                add(all[2], 0x1p-20 * n * (n + 2) * power);
            }
            hn::StoreU(all[0], d4, bend + k);
            hn::StoreU(all[1], d4, error + k);
            hn::StoreU(all[2], d4, slope_error + k);
        }
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
