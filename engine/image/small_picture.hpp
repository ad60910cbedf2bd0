#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"

namespace zeroset {

/// Takes rows of a picture over into a small one of all of it, whose sides are `most_px` at most.
/// `frame`: the part that begins at `row` of `rows`. The small one is opaque; what is not there yet
/// is transparent.
void take_over(const Framebuffer& frame, int row, int rows, int most_px, RgbaImage& small);

}  // namespace zeroset
