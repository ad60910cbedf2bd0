#pragma once

#include "engine/image/framebuffer.hpp"

#include <cstdint>

namespace zeroset {

/// Mixes into each pixel's colour the four of `finer`, which holds `rect` at twice the resolution
/// from its first pixel on: the mean of the five, of linear light, with an alpha that says how many
/// of them hit; 255 where none does, so that all that is seen is background. The rest of the pixel
/// stays.
void blend_finer(const Framebuffer& finer, const PixelRect& rect, Framebuffer& picture);

/// Whether only a part of the pixel shows something.
inline bool is_partly_drawn(std::uint32_t color) {
    return color >> 24U != 0 && color >> 24U != 255U;
}

/// What was drawn of a pixel that blend_finer has mixed with `background`, as opaque as it says;
/// colours are not multiplied by alpha. Only of pixels that are partly drawn.
std::uint32_t without_background(std::uint32_t color, std::uint32_t background);

}  // namespace zeroset
