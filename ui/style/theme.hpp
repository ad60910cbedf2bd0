#pragma once

#include "engine/image/background.hpp"
#include "ui/model/theme.hpp"

#include <cstdint>

namespace zeroset::ui {

/// Colours of a theme as 0xAABBGGRR (red in the lowest byte, as in Framebuffer::color).
struct Palette {
    std::uint32_t sky;     ///< background behind the picture, at its top
    std::uint32_t ground;  ///< background behind the picture, at its bottom
    std::uint32_t bar;     ///< bars along the window's edges
    std::uint32_t card;    ///< floating panels
    std::uint32_t popup;
    std::uint32_t border;
    std::uint32_t field;
    std::uint32_t field_hovered;
    std::uint32_t field_active;
    std::uint32_t row_field;    ///< field of a statement that is not being edited
    std::uint32_t row_hovered;  ///< background of the row under the pointer
    std::uint32_t row_active;   ///< background of the row that is being edited
    std::uint32_t text;
    std::uint32_t quiet;
    std::uint32_t accent;
    std::uint32_t grab;  ///< grab of sliders; translucent, so that the value shows through
    std::uint32_t selection;
    std::uint32_t warning;
    std::uint32_t error;
    /// Colours of undecided pixels: `undecided` alone where nothing is drawn, stripes of both where
    /// a surface is drawn. Their hue is far from the surfaces' colours, and their lightnesses are
    /// far apart.
    std::uint32_t undecided;
    std::uint32_t undecided_pale;
    std::uint32_t coarse;  ///< stripes over certified pixels with a coarse bracket
};

const Palette& palette(Theme theme);

/// The background of the picture in a theme.
Background picture_background(Theme theme);

/// Sets ImGui's style; `scale` is in window coordinates per design unit.
void apply_theme(Theme theme, float scale);

/// `count` times the size of the text font in window coordinates: the unit of all layout.
float em(float count);

}  // namespace zeroset::ui
