#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// RGB to the luma and chroma that video has: BT.709, limited range, gamma as it comes.

namespace zeroset {

/// A frame's pixels, row by row: RGBA of 8 bits each, R lowest, not multiplied by alpha.
struct VideoFrame {
    int width = 0;
    int height = 0;
    bool alpha = false;  ///< else A counts for nothing
    std::span<const std::uint32_t> pixels;

    [[nodiscard]] const std::uint32_t* row(int row) const {
        return pixels.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
    }
};

/// A channel of a pixel: 0 (red) to 3 (alpha).
constexpr std::uint32_t channel_of(std::uint32_t pixel, unsigned channel) {
    return pixel >> 8U * channel & 0xFFU;
}

/// A plane of numbers in memory; those of more than 8 bits take two bytes in the machine's order.
struct VideoPlane {
    std::uint8_t* data = nullptr;
    std::ptrdiff_t row_bytes = 0;
};

/// How a frame's luma and chroma lie.
struct VideoLayout {
    int bits = 8;           ///< of a number: 8 or 10
    bool quartered = true;  ///< one chroma number for 2 x 2 pixels, on their left edge; else each
};

/// Writes a frame into planes of luma, blue and red chroma, and alpha if the frame has it. Sides of
/// quartered frames are even. On all cores.
void write_video_planes(const VideoFrame& frame, const VideoLayout& layout,
                        std::span<const VideoPlane> planes);

}  // namespace zeroset
