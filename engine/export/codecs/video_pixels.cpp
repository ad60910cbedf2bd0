#include "engine/export/codecs/video_pixels.hpp"

#include "engine/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

namespace zeroset {
namespace {

// BT.709: how much of the luma is red, green and blue; chroma is the difference from the luma over
// the range that it can have.
constexpr double red_part = 0.2126;
constexpr double green_part = 0.7152;
constexpr double blue_part = 0.0722;
constexpr double blue_range = 2.0 * (1.0 - blue_part);
constexpr double red_range = 2.0 * (1.0 - red_part);

// Limited range, in 8 bits.
constexpr int black = 16;
constexpr int luma_steps = 219;
constexpr int gray = 128;
constexpr int chroma_steps = 224;

/// Weights of red, green and blue in a sum of pixels of 8 bits, with `fraction_bits` bits behind
/// the point.
struct Weights {
    std::int32_t red, green, blue;
};
constexpr int fraction_bits = 16;

constexpr Weights weights_of(double red, double green, double blue, double steps, double pixels) {
    const double scale = steps / 255.0 / pixels * (1 << fraction_bits);
    const auto rounded = [scale](double part) {
        const double weight = part * scale;
        return static_cast<std::int32_t>(weight < 0 ? weight - 0.5 : weight + 0.5);
    };
    return {.red = rounded(red), .green = rounded(green), .blue = rounded(blue)};
}

constexpr Weights blue_weights(double steps, double pixels) {
    return weights_of(-red_part / blue_range, -green_part / blue_range,
                      (1.0 - blue_part) / blue_range, steps, pixels);
}
constexpr Weights red_weights(double steps, double pixels) {
    return weights_of((1.0 - red_part) / red_range, -green_part / red_range, -blue_part / red_range,
                      steps, pixels);
}

/// Sums of the channels of pixels, with how often they count.
struct Sum {
    std::int32_t red = 0, green = 0, blue = 0;

    void add(std::uint32_t pixel, std::int32_t weight) {
        red += weight * static_cast<std::int32_t>(channel_of(pixel, 0));
        green += weight * static_cast<std::int32_t>(channel_of(pixel, 1));
        blue += weight * static_cast<std::int32_t>(channel_of(pixel, 2));
    }
};

/// The weighted sum on top of `offset`, rounded: within the range of its numbers, as the weights
/// are.
std::int32_t number_of(const Sum& sum, const Weights& weights, std::int32_t offset) {
    const std::int32_t scaled =
        weights.red * sum.red + weights.green * sum.green + weights.blue * sum.blue;
    return offset + ((scaled + (1 << (fraction_bits - 1))) >> fraction_bits);
}

template <class Number>
Number* row_of(const VideoPlane& plane, int row) {
    return reinterpret_cast<Number*>(plane.data + row * plane.row_bytes);
}

/// A number of 8 bits in numbers of so many bits.
template <class Number>
constexpr int scale_of = sizeof(Number) == 1 ? 1 : 4;

template <class Number>
void write_luma_row(const VideoFrame& frame, int row, std::span<const VideoPlane> planes) {
    constexpr int scale = scale_of<Number>;
    constexpr Weights weights = weights_of(red_part, green_part, blue_part, luma_steps * scale, 1);
    const std::uint32_t* const from = frame.row(row);
    Number* const luma = row_of<Number>(planes[0], row);
    for (int col = 0; col < frame.width; ++col) {
        Sum sum;
        sum.add(from[col], 1);
        luma[col] = static_cast<Number>(number_of(sum, weights, black * scale));
    }
    if (!frame.alpha) return;
    constexpr std::uint32_t largest = sizeof(Number) == 1 ? 255 : 1023;
    Number* const alpha = row_of<Number>(planes[3], row);
    for (int col = 0; col < frame.width; ++col)
        alpha[col] = static_cast<Number>((channel_of(from[col], 3) * largest + 127) / 255);
}

template <class Number>
void write_chroma_row(const VideoFrame& frame, int row, std::span<const VideoPlane> planes) {
    constexpr int scale = scale_of<Number>;
    constexpr Weights to_blue = blue_weights(chroma_steps * scale, 1);
    constexpr Weights to_red = red_weights(chroma_steps * scale, 1);
    const std::uint32_t* const from = frame.row(row);
    Number* const blue = row_of<Number>(planes[1], row);
    Number* const red = row_of<Number>(planes[2], row);
    for (int col = 0; col < frame.width; ++col) {
        Sum sum;
        sum.add(from[col], 1);
        blue[col] = static_cast<Number>(number_of(sum, to_blue, gray * scale));
        red[col] = static_cast<Number>(number_of(sum, to_red, gray * scale));
    }
}

/// The sum of eight pixels about the left edge of a square of 2 x 2: its left column counts twice,
/// the right one and that beside it once.
Sum left_sum(const std::uint32_t* upper, const std::uint32_t* lower, int col) {
    Sum sum;
    const int left = col == 0 ? 0 : col - 1;
    for (const std::uint32_t* const row : {upper, lower}) {
        sum.add(row[left], 1);
        sum.add(row[col], 2);
        sum.add(row[col + 1], 1);
    }
    return sum;
}

/// The sum of left_sum where transparent pixels do not count, unless all of them are.
Sum left_sum_of_drawn(const std::uint32_t* upper, const std::uint32_t* lower, int col) {
    std::array<float, 3> light{};
    float weights = 0.0F;
    const int left = col == 0 ? 0 : col - 1;
    for (const std::uint32_t* const row : {upper, lower}) {
        for (const int at : {left, col, col, col + 1}) {
            const float weight = static_cast<float>(channel_of(row[at], 3)) + 1e-3F;
            for (unsigned channel = 0; channel < 3; ++channel)
                light[channel] += weight * static_cast<float>(channel_of(row[at], channel));
            weights += weight;
        }
    }
    const auto eight = [&](float channel) {
        return static_cast<std::int32_t>(8.0F * channel / weights + 0.5F);
    };
    return {.red = eight(light[0]), .green = eight(light[1]), .blue = eight(light[2])};
}

/// Row `row` of quartered chroma.
void write_quartered_row(const VideoFrame& frame, int row, std::span<const VideoPlane> planes) {
    constexpr Weights to_blue = blue_weights(chroma_steps, 8);
    constexpr Weights to_red = red_weights(chroma_steps, 8);
    const std::uint32_t* const upper = frame.row(2 * row);
    const std::uint32_t* const lower = frame.row(2 * row + 1);
    std::uint8_t* const blue = row_of<std::uint8_t>(planes[1], row);
    std::uint8_t* const red = row_of<std::uint8_t>(planes[2], row);
    for (int i = 0; i < frame.width / 2; ++i) {
        const Sum sum =
            frame.alpha ? left_sum_of_drawn(upper, lower, 2 * i) : left_sum(upper, lower, 2 * i);
        blue[i] = static_cast<std::uint8_t>(number_of(sum, to_blue, gray));
        red[i] = static_cast<std::uint8_t>(number_of(sum, to_red, gray));
    }
}

/// Two rows of a frame, or its last one.
void write_rows(const VideoFrame& frame, const VideoLayout& layout, int first,
                std::span<const VideoPlane> planes) {
    for (int row = first; row < std::min(first + 2, frame.height); ++row) {
        if (layout.bits == 8) {
            write_luma_row<std::uint8_t>(frame, row, planes);
            if (!layout.quartered) write_chroma_row<std::uint8_t>(frame, row, planes);
        } else {
            write_luma_row<std::uint16_t>(frame, row, planes);
            write_chroma_row<std::uint16_t>(frame, row, planes);
        }
    }
    if (layout.quartered) write_quartered_row(frame, first / 2, planes);
}

}  // namespace

void write_video_planes(const VideoFrame& frame, const VideoLayout& layout,
                        std::span<const VideoPlane> planes) {
    assert(planes.size() >= (frame.alpha ? 4U : 3U));
    assert(!layout.quartered || (frame.width % 2 == 0 && frame.height % 2 == 0));
    assert(layout.bits == 8 || !layout.quartered);
    parallel_for(static_cast<std::size_t>((frame.height + 1) / 2), 0, [&](std::size_t pair) {
        write_rows(frame, layout, 2 * static_cast<int>(pair), planes);
    });
}

}  // namespace zeroset
