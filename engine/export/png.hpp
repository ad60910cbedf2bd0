#pragma once

#include "engine/image/rgba_image.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// A PNG file of `width` x `height` pixels, row by row from the top, of `channels` bytes each: 3
/// (RGB) or 4 (RGBA). Empty where the encoder fails.
std::vector<std::byte> encoded_png(const void* pixels, int width, int height, int channels);

/// The image as a PNG file; empty where the encoder fails.
std::vector<std::byte> png_of(const RgbaImage& image);

/// The image in a PNG file; nullopt where it cannot be read or a side exceeds 4096 pixels.
std::optional<RgbaImage> image_from_png(std::span<const std::byte> png);

}  // namespace zeroset
