#pragma once

#include "engine/expr/op.hpp"
#include "engine/kernel/patch_model.hpp"

#include <array>
#include <cstddef>

namespace zeroset {

/// A function of one variable about a point c: for |t| <= reach,
///   |f(c + t) - (term[0] + term[1] t + ... )| <= error.
struct Series {
    std::array<double, std::size_t{patch_degree} + 1> term{};
    double error;  ///< +inf: f is not known to be smooth there, or not known at all
};

/// Whether `series_of` knows an operator of one operand.
bool has_series(Op op);

/// The series of Sqrt, Exp, Log, Log10, Log2, Sin, Cos, Atan, Sinh or Cosh. In upward rounding.
Series series_of(Op op, double c, double reach);

/// The series of 1 / x. In upward rounding.
Series reciprocal_series(double c, double reach);

}  // namespace zeroset
