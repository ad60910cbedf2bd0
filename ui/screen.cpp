#include "ui/screen.hpp"

#include "ui/equation_panel.hpp"
#include "ui/help_panel.hpp"
#include "ui/status_panel.hpp"
#include "ui/texture.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"
#include "ui/view_panel.hpp"
#include "ui/viewport.hpp"

#include <cstdint>

namespace zeroset::ui {

void draw_screen(UiState& state, const Texture& picture) {
    follow_help_keys(state);
    draw_viewport(state, picture);
    draw_view_panel(state);
    draw_equation_panel(state);
    draw_status_panel(state);
    draw_help_panel(state);
}

std::uint32_t behind_picture(Theme theme) { return palette(theme).sky; }

Texture::Tint undecided_tint(Theme theme) {
    return {palette(theme).undecided, palette(theme).undecided_pale};
}

}  // namespace zeroset::ui
