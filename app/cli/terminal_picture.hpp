#pragma once

#include "engine/image/rgba_image.hpp"

#include <string>

namespace zeroset {

/// True if the terminal says that it shows colours of 24 bits, in the environment's COLORTERM.
bool has_true_color();

/// The picture as lines of a terminal, two rows of pixels in each; transparent pixels stay in the
/// terminal's own colour. Each line erases what was there and ends in a line end.
std::string terminal_picture(const RgbaImage& image);

/// The number of these lines.
int terminal_lines(const RgbaImage& image);

}  // namespace zeroset
