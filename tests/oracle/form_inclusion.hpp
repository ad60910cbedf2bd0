#pragma once

#include "engine/kernel/kernel.hpp"
#include "tests/oracle/form_cells.hpp"
#include "tests/oracle/kernel_inclusion.hpp"
#include "tests/support/inclusion.hpp"

#include <string>

// Checks that what a form kernel says of the cells of a view is true at points of these cells: the
// form, the slope along rays, the bound of an evaluation's rounding and the marks of the domain,
// against MPFI.

namespace zeroset::test {

/// What MPFI disproves of a kernel's claims for the cells; empty if nothing.
template <class Real>
std::string disproved(const Kernel& kernel, const Expr& expr, const FormCells<Real>& cells,
                      InclusionTally& tally);

/// Checks `batches` batches of random cells of a random formula. The formula of the first failure
/// is minimised.
template <class Real>
void check_forms(MakeKernel make, int depth, int batches, RandomNumbers& random,
                 InclusionTally& tally);

}  // namespace zeroset::test
