#pragma once

#include "engine/image/framebuffer.hpp"

#include <cstdint>

namespace zeroset {

/// Makes each pixel of `rect` in `picture` the mean of those of `finer` that cover it, in linear
/// light; `finer` holds `rect` at `across` times the resolution from its first pixel on. Alpha is
/// the mean of that of hits and 0 for others; 255 where none hits, as then the pixel shows
/// background alone. Where both keep their light, its mean, too. All else of the pixel stays.
void blend_finer(const Framebuffer& finer, int across, const PixelRect& rect, Framebuffer& picture);

/// Whether some, but not all, of an antialiased pixel shows a surface.
inline bool is_partly_drawn(std::uint32_t color) {
    return color >> 24U != 0 && color >> 24U != 255U;
}

/// The drawn part of an antialiased pixel, which is mixed with `background`: its colour, not
/// multiplied by alpha, with the pixel's alpha. Only for pixels that are partly drawn.
std::uint32_t without_background(std::uint32_t color, std::uint32_t background);

}  // namespace zeroset
