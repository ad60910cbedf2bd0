#pragma once

#include "engine/image/framebuffer.hpp"

#include <cstdint>

namespace zeroset {

/// Mixes into each pixel of `rect` in `picture` the four of `finer` that cover it; `finer` holds
/// `rect` at twice the resolution from its first pixel on. The colour becomes the mean of the five,
/// in linear light. Alpha says how many of the five hit; it is 255 where none does, as then the
/// pixel shows background alone. All else of the pixel stays.
void blend_finer(const Framebuffer& finer, const PixelRect& rect, Framebuffer& picture);

/// Whether some, but not all, of the rays of a pixel from blend_finer hit.
inline bool is_partly_drawn(std::uint32_t color) {
    return color >> 24U != 0 && color >> 24U != 255U;
}

/// The drawn part of a pixel that blend_finer has mixed with `background`: its colour, not
/// multiplied by alpha, with the pixel's alpha. Only for pixels that are partly drawn.
std::uint32_t without_background(std::uint32_t color, std::uint32_t background);

}  // namespace zeroset
