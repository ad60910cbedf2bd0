#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"
#include "tests/support/inclusion.hpp"
#include "tests/support/random_numbers.hpp"

#include <array>
#include <cstddef>

// Checks of whole formulas: the range kernel encloses f over a box at every real point of the box.

namespace zeroset::test {

inline constexpr std::size_t boxes_a_batch = batch_multiple;

/// A box in x, y, z, w.
template <class Real>
using Box4 = std::array<Interval<Real>, 4>;

/// The boxes of one batch; all have the same w.
template <class Real>
using Boxes = std::array<Box4<Real>, boxes_a_batch>;

template <class Real>
using Ranges = std::array<Outcome<Real>, boxes_a_batch>;

/// Random boxes: half of the time usual ones, else ones that are likely to find faults.
template <class Real>
Boxes<Real> random_boxes(RandomNumbers& random);

/// The kernel's claims for the boxes. Call it in the tested mode.
template <class Real>
Ranges<Real> ranges_of(const Kernel& kernel, const Boxes<Real>& boxes);

/// The box as text: "x [lo, hi]" and so on, each in a line.
template <class Real>
std::string described(const Box4<Real>& box);

/// Checks one batch of random boxes of a formula, at random points of them.
template <class Real>
void check_expression(const Expr& expr, RandomNumbers& random, InclusionTally& tally);

/// Checks one batch of random boxes of a random formula.
template <class Real>
void check_random_expression(int depth, RandomNumbers& random, InclusionTally& tally);

}  // namespace zeroset::test
