#pragma once

#include <cstddef>
#include <vector>

namespace zeroset {

/// A PNG of `width` x `height` pixels from the top, of `channels` bytes each: 3 (RGB) or 4 (RGBA).
/// Empty where it cannot be made.
std::vector<std::byte> encoded_png(const void* pixels, int width, int height, int channels);

}  // namespace zeroset
