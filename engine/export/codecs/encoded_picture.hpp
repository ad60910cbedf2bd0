#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <vector>

namespace zeroset {

/// A whole picture in memory.
struct RawPicture {
    int width = 0;
    int height = 0;
    int bits = 8;  ///< of a channel: 8, or 16 of the machine's byte order
    bool alpha = false;
    std::span<const std::uint8_t> rows;  ///< RGB or RGBA, row by row, not multiplied by alpha
};

/// A finished file, or why there is none.
using EncodedPicture = std::expected<std::vector<std::byte>, std::string>;

inline constexpr const char* webp_encoder = "libwebp";
inline constexpr const char* tiff_encoder = "tiff";

// By stb_image_write, which every build has: 8 bits, TGA alone with alpha.

/// `quality`: 1 to 100; from 91 on colours are not subsampled.
EncodedPicture encoded_jpeg(const RawPicture& picture, int quality);
EncodedPicture encoded_bmp(const RawPicture& picture);
EncodedPicture encoded_tga(const RawPicture& picture);
/// Radiance's format. `light`: RGB, row by row.
EncodedPicture encoded_hdr(int width, int height, std::span<const float> light);

// By FFmpeg.

/// 8 bits; `quality`: 1 to 100, which is without loss.
EncodedPicture encoded_webp(const RawPicture& picture, int quality);
/// 8 or 16 bits, without loss. `dots_per_inch`: 0: not told.
EncodedPicture encoded_tiff(const RawPicture& picture, double dots_per_inch);

}  // namespace zeroset
