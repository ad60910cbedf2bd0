#pragma once

#include "engine/export/codecs/video_pixels.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace zeroset {

/// The colours of a film, 0xRRGGBB, at most 255: one more number stands for transparent pixels.
using FilmPalette = std::vector<std::uint32_t>;

/// How often colours occur, rounded to 5 bits a channel, with the means of those that share a
/// place.
class ColorCounts {
public:
    ColorCounts() : cells_(std::size_t{1} << 15U) {}

    /// Counts the pixels that are not transparent.
    void add(const VideoFrame& frame);
    /// The palette that shows them best: boxes of colours, halved where that lowers the error most
    /// (median cut by variance, Wu 1991), then moved to the means of what is nearest (k-means).
    [[nodiscard]] FilmPalette palette(std::size_t colors) const;

private:
    struct Cell {
        std::array<double, 3> sum{};  ///< of the channels
        double count = 0.0;
    };
    std::vector<Cell> cells_;
};

/// The numbers of a frame's colours in the palette, dithered by error diffusion (Floyd and
/// Steinberg 1976) along rows that turn; `transparent` for pixels less than half opaque.
std::vector<std::uint8_t> dithered(const VideoFrame& frame, const FilmPalette& palette,
                                   std::uint8_t transparent);

}  // namespace zeroset
