#pragma once

#include <chrono>

namespace zeroset {

/// Milliseconds from `start` to now.
double ms_since(std::chrono::steady_clock::time_point start);

/// The time `seconds` after `start`.
std::chrono::steady_clock::time_point until_after(std::chrono::steady_clock::time_point start,
                                                  double seconds);

}  // namespace zeroset
