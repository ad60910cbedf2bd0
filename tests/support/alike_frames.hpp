#pragma once

#include "engine/image/framebuffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace zeroset::test {

/// The most by which channels of two colours of a frame differ, of 255.
inline int color_change(std::uint32_t a, std::uint32_t b) {
    int change = 0;
    for (unsigned shift = 0; shift < 24; shift += 8)
        change = std::max(change, std::abs(static_cast<int>(a >> shift & 255U) -
                                           static_cast<int>(b >> shift & 255U)));
    return change;
}

/// How many pixels of two frames differ by more than this in a channel, of 255.
inline std::size_t different_pixels(const Framebuffer& a, const Framebuffer& b, int most) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < a.color.size(); ++at)
        count += color_change(a.color[at], b.color[at]) > most ? 1U : 0U;
    return count;
}

/// The colours of a picture whose pixels are each the mean, in linear light, of the factor x factor
/// pixels of another one that lie there: far more rays a pixel than one picture has.
inline Framebuffer averaged(const Framebuffer& large, int factor) {
    Framebuffer frame(large.width / factor, large.height / factor);
    const int count = factor * factor;
    for (int row = 0; row < frame.height; ++row) {
        for (int col = 0; col < frame.width; ++col) {
            std::array<double, 3> light{};
            for (int part = 0; part < count; ++part) {
                const std::uint32_t color = large.color[large.index(factor * col + part % factor,
                                                                    factor * row + part / factor)];
                for (unsigned channel = 0; channel < 3; ++channel) {
                    const double shown = (color >> 8 * channel & 255U) / 255.0;
                    light[channel] += shown * shown / count;  // by gamma 2
                }
            }
            std::uint32_t color = 0xFF000000U;
            for (unsigned channel = 0; channel < 3; ++channel)
                color |= static_cast<std::uint32_t>(std::lround(255.0 * std::sqrt(light[channel])))
                         << 8 * channel;
            frame.color[frame.index(col, row)] = color;
        }
    }
    return frame;
}

/// Pixels of a frame, compared with those of another way to draw it.
struct Comparison {
    int certified = 0;        ///< by both
    int undecided = 0;        ///< by the first
    double difference = 0.0;  ///< of channels, summed over what both have certified
};

/// Compares two frames. What one has proved the other must not contradict: a failure, and so are
/// depths that differ by more than `tolerance`.
inline void compare_frames(const Framebuffer& frame, const Framebuffer& other, double tolerance,
                           Comparison& seen) {
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        const Certificate a = frame.certificate[i];
        const Certificate b = other.certificate[i];
        seen.undecided += a == Certificate::Undecided ? 1 : 0;
        if (a == Certificate::Undecided || b == Certificate::Undecided) continue;
        ASSERT_EQ(a, b) << i;
        if (a != Certificate::Certified) continue;
        ++seen.certified;
        ASSERT_NEAR(frame.depth[i], other.depth[i], tolerance) << i;
        for (unsigned shift = 0; shift < 24; shift += 8) {
            seen.difference += std::abs(static_cast<int>(frame.color[i] >> shift & 255U) -
                                        static_cast<int>(other.color[i] >> shift & 255U));
        }
    }
}

}  // namespace zeroset::test
