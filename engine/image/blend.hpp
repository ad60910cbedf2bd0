#pragma once

#include "engine/image/framebuffer.hpp"

namespace zeroset {

/// Mixes into each pixel's colour the four of `finer`, which holds `rect` at twice the resolution
/// from its first pixel on: the mean of the five, of linear light. The rest of the pixel stays.
void blend_finer(const Framebuffer& finer, const PixelRect& rect, Framebuffer& picture);

}  // namespace zeroset
