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

/// A box, and what the formula's structure could tell about it.
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

    /// Distinct points of the box, 0 in places without an operand. -0 and 0 are distinct.
    std::vector<std::array<double, 3>> points(const OpInfo& info, RandomNumbers& random) const;
};

/// A function that computes an operator's range.
template <class Real>
using OperatorRange = Outcome<Real> (*)(const Node&, const Inputs<Real>&);

/// The range over plain numbers, one box at a time.
template <class Real>
Outcome<Real> scalar_range(const Node& node, const Inputs<Real>& in);
/// The range over blocks, the carrier of kernels in double.
Outcome<double> block_range(const Node& node, const Inputs<double>& in);

/// The operator's node, with a random number where it has one.
Node random_operator_node(const OpInfo& info, RandomNumbers& random);

/// Computes one range in the tested mode and checks its claims at points of the box.
template <class Real>
void check_operator(OperatorRange<Real> range, const Node& node, const Inputs<Real>& in,
                    RandomNumbers& random, InclusionTally& tally);

}  // namespace zeroset::test
