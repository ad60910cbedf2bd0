#pragma once

#include "engine/image/rgba_image.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// A PNG of `width` x `height` pixels from the top, of `channels` bytes each: 3 (RGB) or 4 (RGBA).
/// Empty where it cannot be made.
std::vector<std::byte> encoded_png(const void* pixels, int width, int height, int channels);

/// As a PNG file; empty when the encoder fails.
std::vector<std::byte> png_of(const RgbaImage& image);

/// The picture in a PNG file; nothing when it cannot be read or is larger than 4096 pixels a side.
std::optional<RgbaImage> image_from_png(std::span<const std::byte> png);

}  // namespace zeroset
