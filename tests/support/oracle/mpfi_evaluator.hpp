#pragma once

#include "tests/support/oracle/mpfi_operators.hpp"

#include <span>
#include <vector>

namespace zeroset::test {

/// Evaluates whole formulas in intervals of MPFI, in the working precision, as natural interval
/// extensions. For use by one thread.
class MpfiEvaluator {
public:
    explicit MpfiEvaluator(const Expr& expr);

    /// An enclosure of f over the box: intervals of x, y, z, w and the parameters.
    MpfiEnclosure over(std::span<const MpfiInterval> box);
    /// An enclosure of f, with its slope along a line on which the variables have the given slopes.
    MpfiDual along(std::span<const MpfiDual> variables);

private:
    Expr expr_;
    std::vector<MpfiEnclosure> values_;
    std::vector<MpfiDual> duals_;
};

/// The box that is a single point.
std::vector<MpfiInterval> points(std::span<const double> at);

}  // namespace zeroset::test
