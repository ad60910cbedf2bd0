#pragma once

#include "engine/kernel/kernel.hpp"
#include "tests/oracle/shrink.hpp"
#include "tests/support/inclusion.hpp"
#include "tests/support/oracle/mpfi_interval.hpp"
#include "tests/support/random_numbers.hpp"

#include <cmath>
#include <string>

// Checks of range kernels against MPFI: at points of a box and on smaller boxes in it.

namespace zeroset::test {

/// A function that makes a kernel for a formula.
using MakeKernel = Kernel (*)(const Expr& expr);

/// Whether some of the values may be in the range that a kernel answered.
template <class Real>
bool meets(const Interval<Real>& range, const MpfiInterval& values) {
    if (std::isnan(range.neg_lo) || std::isnan(range.hi)) return false;
    const bool below = mpfr_cmp_d(values.lo(), static_cast<double>(range.hi)) <= 0;
    const bool above = mpfr_cmp_d(values.hi(), -static_cast<double>(range.neg_lo)) >= 0;
    const bool two_parts = range.neg_lo < 0 && range.hi < 0;  // as RangeBatch says
    return two_parts ? below || above : below && above;
}

/// The claim of a kernel's answer for a box that MPFI disproves, or an empty text. Checks the same
/// points at each call.
template <class Real>
std::string disproved(const Expr& expr, const Box4<Real>& box, const Outcome<Real>& outcome,
                      InclusionTally& tally);

/// The disproved claim, or an empty text, of the kernel of `make` for one box, computed in the
/// tested mode.
template <class Real>
std::string disproved(MakeKernel make, const FormulaOnBox<Real>& on);

/// Checks a batch of random boxes of a random formula. The first failure is minimised and described
/// as the text of a formula and of a box.
template <class Real>
void check_kernel(MakeKernel make, int depth, RandomNumbers& random, InclusionTally& tally);

}  // namespace zeroset::test
