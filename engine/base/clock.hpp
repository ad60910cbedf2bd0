#pragma once

#include <chrono>

namespace zeroset {

/// Milliseconds from then to now.
double ms_since(std::chrono::steady_clock::time_point start);

/// The time so many seconds later.
std::chrono::steady_clock::time_point until_after(std::chrono::steady_clock::time_point start,
                                                  double seconds);

}  // namespace zeroset
