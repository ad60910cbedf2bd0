#pragma once

#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <cstdint>

namespace zeroset::ui {

/// Draws the whole window: the picture and the panels around and over it. Called between
/// Window::begin_frame and Window::end_frame.
void draw_screen(UiState& state, const Texture& picture);

/// Average colour that shows through missed pixels (format as in Framebuffer::color).
std::uint32_t behind_picture(Theme theme);
/// Colours that mark undecided and coarse pixels in the picture.
Texture::Tint undecided_tint(Theme theme);

}  // namespace zeroset::ui
