#pragma once

#include <chrono>

namespace zeroset {

/// Milliseconds from `start` to now.
double ms_since(std::chrono::steady_clock::time_point start);

/// The time `seconds` after `start`.
std::chrono::steady_clock::time_point until_after(std::chrono::steady_clock::time_point start,
                                                  double seconds);

/// Frames a second: numerator and denominator.
struct FrameRate {
    int frames = 30;
    int seconds = 1;

    bool operator==(const FrameRate&) const = default;
};

}  // namespace zeroset
