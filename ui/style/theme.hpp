#pragma once

#include "ui/model/ui_state.hpp"

#include <cstdint>

namespace zeroset::ui {

/// Colours as 0xAABBGGRR (red in the lowest byte, as in Framebuffer::color).
struct Palette {
    std::uint32_t sky;     ///< the background behind the picture, at the top
    std::uint32_t ground;  ///< and at the bottom
    std::uint32_t bar;     ///< bars along the window's edges
    std::uint32_t card;    ///< floating panels
    std::uint32_t popup;
    std::uint32_t border;
    std::uint32_t field;
    std::uint32_t field_hovered;
    std::uint32_t field_active;
    std::uint32_t row_field;    ///< a statement that is not under edit
    std::uint32_t row_hovered;  ///< behind the row under the pointer
    std::uint32_t row_active;   ///< behind the row under edit
    std::uint32_t text;
    std::uint32_t quiet;
    std::uint32_t accent;
    std::uint32_t grab;  ///< of sliders; lets their value shine through
    std::uint32_t selection;
    std::uint32_t warning;
    std::uint32_t error;
    /// Undecided pixels: one colour where nothing is drawn; stripes of both where something is. Far
    /// from the surfaces' colours in hue, and the two from each other in lightness.
    std::uint32_t undecided;
    std::uint32_t undecided_pale;
    std::uint32_t
        coarse;  ///< stripes over certified pixels whose bracket is coarse; teal as in files
};

const Palette& palette(Theme theme);

/// Sets ImGui's style; `scale` is window coordinates per design unit.
void apply_theme(Theme theme, float scale);

/// The opacity of a colour times that.
std::uint32_t faded(std::uint32_t color, float opacity);

/// `count` times the size of the text font, in window coordinates: the unit of all layout.
float em(float count);

}  // namespace zeroset::ui
