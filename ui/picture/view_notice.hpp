#pragma once

#include "ui/model/ui_state.hpp"

#include <cstdint>
#include <span>

namespace zeroset::ui {

/// Why the picture shows nothing.
enum class Emptiness : std::uint8_t {
    None,       ///< it shows something, or that is not known yet
    NoText,     ///< nothing is typed yet
    AllHidden,  ///< the eyes of all surfaces are closed
    OutOfView,  ///< the surfaces are elsewhere, or cut away
};

Emptiness emptiness_of(const UiState& state);

/// A text to begin with.
struct Example {
    const char* title;
    const char* text;
};
std::span<const Example> examples();

/// Says over an empty picture why it is so, with what leads on: examples and the gallery, all
/// surfaces shown, the view on the surfaces, the usual box. Then what was done and found by
/// framing, at the picture's lower edge, and a button that shows a file that was saved.
void draw_view_notice(UiState& state);

}  // namespace zeroset::ui
