#pragma once

#include "engine/kernel/kernel.hpp"
#include "tests/oracle/form_cells.hpp"
#include "tests/oracle/kernel_inclusion.hpp"
#include "tests/support/inclusion.hpp"

#include <string>

// Checks the claims of a form kernel about the cells of a view at points of these cells, against
// MPFI: the form, the slope along rays, the bound of an evaluation's rounding and the masks of the
// domain.

namespace zeroset::test {

/// The first claim of a kernel about the cells that MPFI disproves, or an empty text.
template <class Real>
std::string disproved(const Kernel& kernel, const Expr& expr, const FormCells<Real>& cells,
                      InclusionTally& tally);

/// Checks `batches` batches of random cells of a random formula. The formula of the first failure
/// is minimised.
template <class Real>
void check_forms(MakeKernel make, int depth, int batches, RandomNumbers& random,
                 InclusionTally& tally);

}  // namespace zeroset::test
