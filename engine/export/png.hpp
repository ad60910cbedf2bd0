#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The colours as an 8-bit RGB PNG file; the image as one with transparency.
std::vector<std::byte> png_of(const Framebuffer& frame);
std::vector<std::byte> png_of(const RgbaImage& image);

/// The image in a PNG file; nullopt where it cannot be read or a side exceeds 4096 pixels.
std::optional<RgbaImage> image_from_png(std::span<const std::byte> png);

/// The width and height of a PNG file; nullopt where it is none.
struct PngSize {
    std::uint32_t width, height;
};
std::optional<PngSize> size_of_png(std::span<const std::byte> png);

/// The compressed text with this keyword in a PNG file; nullopt where there is none, or where it is
/// damaged or longer than 64 MiB.
std::optional<std::string> text_in_png(std::span<const std::byte> png, std::string_view keyword);

}  // namespace zeroset
