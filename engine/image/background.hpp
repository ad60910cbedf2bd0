#pragma once

#include <cstdint>

namespace zeroset {

/// The background of an image row, RGBA as in Framebuffer.
std::uint32_t background_color(int row, int height);

}  // namespace zeroset
