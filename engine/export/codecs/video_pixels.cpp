#include "engine/export/codecs/video_pixels.hpp"

#include "engine/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

namespace zeroset {
namespace {

// BT.709: how much of the luma is red, green and blue; chroma is the difference from the luma over
// the range that it can have.
constexpr float red_part = 0.2126F;
constexpr float green_part = 0.7152F;
constexpr float blue_part = 0.0722F;
constexpr float blue_range = 2.0F * (1.0F - blue_part);
constexpr float red_range = 2.0F * (1.0F - red_part);

// Limited range, in 8 bits.
constexpr float black = 16.0F;
constexpr float luma_steps = 219.0F;
constexpr float gray = 128.0F;
constexpr float chroma_steps = 224.0F;

/// Red, green, blue and weight of a pixel, 0 to 1.
using Light = std::array<float, 4>;

Light light_at(const VideoFrame& frame, int col, int row) {
    const std::uint8_t* const pixel = frame.pixel(col, row);
    const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; };
    return {part(pixel[0]), part(pixel[1]), part(pixel[2]), frame.alpha ? part(pixel[3]) : 1.0F};
}

float luma_of(const Light& light) {
    return red_part * light[0] + green_part * light[1] + blue_part * light[2];
}

/// Writes numbers of a plane's row one after the other.
class RowWriter {
public:
    RowWriter(const VideoPlane& plane, int row, int bits)
        : out_(plane.data + row * plane.row_bytes), bits_(bits) {}

    /// `value`: in steps of 8 bits.
    void put(float value) {
        const float scale = bits_ == 8 ? 1.0F : 4.0F;
        const float largest = bits_ == 8 ? 255.0F : 1023.0F;
        const auto number =
            static_cast<std::uint16_t>(std::clamp(value * scale + 0.5F, 0.0F, largest));
        if (bits_ == 8) {
            *out_++ = static_cast<std::uint8_t>(number);
        } else {
            std::memcpy(out_, &number, sizeof number);
            out_ += sizeof number;
        }
    }

private:
    std::uint8_t* out_;
    int bits_;
};

void put_chroma(const Light& light, RowWriter& blue, RowWriter& red) {
    const float luma = luma_of(light);
    blue.put(gray + chroma_steps * (light[2] - luma) / blue_range);
    red.put(gray + chroma_steps * (light[0] - luma) / red_range);
}

/// The mean about the left edge of a square of 2 x 2 pixels: transparent ones do not count.
Light left_mean(const VideoFrame& frame, int col, int row) {
    Light sum{};
    for (const int y : {row, row + 1}) {
        for (const int x : {-1, 0, 1}) {
            Light light = light_at(frame, std::max(col + x, 0), y);
            const float weight = (x == 0 ? 2.0F : 1.0F) * (light[3] + 1e-6F);
            for (std::size_t channel = 0; channel < 3; ++channel)
                sum[channel] += weight * light[channel];
            sum[3] += weight;
        }
    }
    for (std::size_t channel = 0; channel < 3; ++channel)
        sum[channel] /= sum[3];
    return sum;
}

void write_luma_row(const VideoFrame& frame, const VideoLayout& layout, int row,
                    std::span<const VideoPlane> planes) {
    RowWriter luma(planes[0], row, layout.bits);
    for (int col = 0; col < frame.width; ++col)
        luma.put(black + luma_steps * luma_of(light_at(frame, col, row)));
    if (!frame.alpha) return;
    // All of the range, whose steps are those of the largest number.
    const float largest = layout.bits == 8 ? 255.0F : 1023.0F / 4.0F;
    RowWriter alpha(planes[3], row, layout.bits);
    for (int col = 0; col < frame.width; ++col)
        alpha.put(largest * light_at(frame, col, row)[3]);
}

void write_chroma_row(const VideoFrame& frame, const VideoLayout& layout, int row,
                      std::span<const VideoPlane> planes) {
    RowWriter blue(planes[1], row, layout.bits);
    RowWriter red(planes[2], row, layout.bits);
    if (layout.quartered) {
        for (int col = 0; col < frame.width; col += 2)
            put_chroma(left_mean(frame, col, 2 * row), blue, red);
    } else {
        for (int col = 0; col < frame.width; ++col)
            put_chroma(light_at(frame, col, row), blue, red);
    }
}

}  // namespace

void write_video_planes(const VideoFrame& frame, const VideoLayout& layout,
                        std::span<const VideoPlane> planes) {
    assert(planes.size() >= (frame.alpha ? 4U : 3U));
    assert(!layout.quartered || (frame.width % 2 == 0 && frame.height % 2 == 0));
    parallel_for(static_cast<std::size_t>((frame.height + 1) / 2), 0, [&](std::size_t pair) {
        const int first = 2 * static_cast<int>(pair);
        for (int row = first; row < std::min(first + 2, frame.height); ++row) {
            write_luma_row(frame, layout, row, planes);
            if (!layout.quartered) write_chroma_row(frame, layout, row, planes);
        }
        if (layout.quartered) write_chroma_row(frame, layout, first / 2, planes);
    });
}

}  // namespace zeroset
