#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

/// The value of a function of numbers that scripts call, as C has it: sqrt, arccos, log (natural),
/// min; nothing for other names and numbers of arguments.
std::optional<double> real_function(std::string_view name, std::span<const double> arguments);

/// Whether a relation holds, by its sign: < > <= >= = == != & && | ||; nothing for other signs.
std::optional<bool> holds(double a, std::string_view sign, double b);

}  // namespace zeroset
