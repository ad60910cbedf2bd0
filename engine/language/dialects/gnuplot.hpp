#pragma once

#include "engine/language/dialects/expressions.hpp"

#include <string_view>

namespace zeroset {

/// Writes the surfaces of gnuplot's splot, parametric ones where the text says so, and returns
/// their box: the ranges before the formulas, else those of "set xrange [a:b]", else -10 to 10 of x
/// and y.
AskedBox write_splot(std::string_view row, ExpressionWriter& writer);

}  // namespace zeroset
