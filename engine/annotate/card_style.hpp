#pragma once

#include "engine/annotate/shapes.hpp"

#include <cstdint>

namespace zeroset {

/// Colours of the legend's card, of markers and their tags.
struct CardColors {
    std::uint32_t card;    ///< behind words
    std::uint32_t border;  ///< of the card
    std::uint32_t text;
    std::uint32_t quiet;   ///< of words that matter less
    std::uint32_t accent;  ///< of markers
    /// Undecided pixels: one colour where nothing is drawn; stripes of both where something is.
    std::uint32_t undecided, undecided_pale;
    std::uint32_t coarse;  ///< stripes over certified pixels whose bracket is coarse

    bool operator==(const CardColors&) const = default;
};

/// The colours of the window's dark theme.
inline constexpr CardColors cards_on_dark{.card = 0xEB241C18U,
                                          .border = 0x17FFFFFFU,
                                          .text = 0xFFF1EBE8U,
                                          .quiet = 0xFFB3A197U,
                                          .accent = 0xFFF5A86FU,
                                          .undecided = 0xFF8A21E0U,
                                          .undecided_pale = 0xFFF2E3FFU,
                                          .coarse = 0xFFA09A1EU};

/// How legend, markers and tags look on a canvas.
struct CardStyle {
    CardColors colors = cards_on_dark;
    double unit = 14.0;  ///< of all lengths but letters, pixels
    double em = 10.0;    ///< size of the letters, pixels
    TextWidth width;

    [[nodiscard]] double line_height() const { return line_height_em * em; }
};

/// The style that suits a picture of this size.
CardStyle card_style_for(int width_px, int height_px, TextWidth width);

}  // namespace zeroset
