#pragma once

#include "tests/support/inclusion.hpp"
#include "tests/support/random_numbers.hpp"

#include <span>

// Checks of those functions of interval.hpp that do more than an operator of op.def needs.

namespace zeroset::test {

enum class Domain : std::uint8_t { Any, FirstNonnegative, Nonnegative };

/// A function under test and its true value; `n` is an exponent, or the index of a factor.
template <class Real>
struct Helper {
    const char* name;
    Domain domain;
    Outcome<Real> (*range)(const Interval<Real>& a, const Interval<Real>& b, const int& n);
    Reference (*truth)(const MpfrNumber& a, const MpfrNumber& b, int n);
};

template <class Real>
std::span<const Helper<Real>> helpers();

/// Checks one random box, at random points of it.
template <class Real>
void check_helper(const Helper<Real>& helper, RandomNumbers& random, InclusionTally& tally);

}  // namespace zeroset::test
