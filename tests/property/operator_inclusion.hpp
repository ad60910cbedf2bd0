#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/op.hpp"
#include "tests/support/inclusion.hpp"
#include "tests/support/random_numbers.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

// Checks that an operator of op.def encloses the real function: on a random box, at random real
// points of it, against a reference of 256 bits.

namespace zeroset::test {

inline constexpr int points_a_box = 8;

/// A box with what the formula's structure could tell of it.
template <class Real>
struct Input {
    Interval<Real> box;
    Facts facts;
    bool condition = false;
    std::optional<Interval<Real>> gap{};

    [[nodiscard]] double point(RandomNumbers& random) const;
    [[nodiscard]] std::string text() const;
};

/// The operands of one operator.
template <class Real>
struct Inputs {
    std::array<Input<Real>, 3> of;

    Inputs(const OpInfo& info, RandomNumbers& random);

    /// Points of the box, 0 in what is no operand; those drawn twice only once. -0 is not 0.
    std::vector<std::array<double, 3>> points(const OpInfo& info, RandomNumbers& random) const;
};

/// How an operator's range is computed.
template <class Real>
using OperatorRange = Outcome<Real> (*)(const Node&, const Inputs<Real>&);

/// One box at a time.
template <class Real>
Outcome<Real> scalar_range(const Node& node, const Inputs<Real>& in);
/// By the carrier of kernels in double.
Outcome<double> block_range(const Node& node, const Inputs<double>& in);

/// The operator with a random number where it has one.
Node random_operator_node(const OpInfo& info, RandomNumbers& random);

/// Computes one range in the tested mode and compares its claims at points of the box.
template <class Real>
void check_operator(OperatorRange<Real> range, const Node& node, const Inputs<Real>& in,
                    RandomNumbers& random, InclusionTally& tally);

}  // namespace zeroset::test
