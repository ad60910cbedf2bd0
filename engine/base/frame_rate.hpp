#pragma once

namespace zeroset {

/// Frames a second: numerator and denominator.
struct FrameRate {
    int frames = 30;
    int seconds = 1;

    bool operator==(const FrameRate&) const = default;
};

}  // namespace zeroset
