#pragma once

#include <string_view>

namespace zeroset {

/// Whether a text gives a name to a function: f = @(x, y), f[x_] := ..., def f(x).
bool is_function_in(std::string_view typed, std::string_view name);
/// The list in brackets that a text gives a name: ends = [-1 1]; empty: none.
std::string_view list_in(std::string_view typed, std::string_view name);

}  // namespace zeroset
