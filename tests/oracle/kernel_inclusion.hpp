#pragma once

#include "engine/expr/kernel.hpp"
#include "tests/oracle/shrink.hpp"
#include "tests/support/inclusion.hpp"
#include "tests/support/random_numbers.hpp"

#include <string>

// Checks that a range kernel agrees with MPFI: at points of a box and on smaller boxes in it.

namespace zeroset::test {

/// How a kernel is made of a formula.
using MakeKernel = Kernel (*)(const Expr& expr);

/// What MPFI disproves of a kernel's answer for a box; empty if nothing. The same points each time.
template <class Real>
std::string disproved(const Expr& expr, const Box4<Real>& box, const Outcome<Real>& outcome,
                      InclusionTally& tally);

/// The same of the kernel's answer for one box, asked for in the tested mode.
template <class Real>
std::string disproved(MakeKernel make, const FormulaOnBox<Real>& on);

/// Checks a batch of random boxes of a random formula. The first failure is minimised and described
/// as the text of a formula and a box.
template <class Real>
void check_kernel(MakeKernel make, int depth, RandomNumbers& random, InclusionTally& tally);

}  // namespace zeroset::test
