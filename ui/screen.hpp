#pragma once

#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <cstdint>

namespace zeroset::ui {

/// Everything that is in the window: the picture and the panels around and over it. Between
/// Window::begin_frame and Window::end_frame.
void draw_screen(UiState& state, const Texture& picture);

/// The colour (as in Framebuffer::color) that missed pixels show on average.
std::uint32_t behind_picture(Theme theme);
/// How undecided pixels are marked in the picture.
Texture::Tint undecided_tint(Theme theme);

}  // namespace zeroset::ui
