#include "ui/screen.hpp"

#include "ui/actions/shortcuts.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/pages/command_palette.hpp"
#include "ui/pages/dialogs.hpp"
#include "ui/pages/gallery_page.hpp"
#include "ui/pages/help_panel.hpp"
#include "ui/panels/side_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/picture/axis_gizmo.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/texture.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cstdint>

namespace zeroset::ui {

namespace {

/// Drops the wish to give a row the keyboard if a dialog is open, the panel folded or the row gone.
void check_focus(UiState& state, bool asks) {
    if (!state.focus) return;
    const auto row = std::ranges::find(state.document.statements, state.focus->row, &Statement::id);
    const bool there = row != state.document.statements.end();
    if (asks || state.layout.folded || !there) state.focus.reset();
}

}  // namespace

void draw_screen(UiState& state, const Texture& picture) {
    const bool asks = state.dialogs.question || state.dialogs.file;
    check_focus(state, asks);
    if (!asks) {
        follow_shortcuts(state);
        follow_help_keys(state);
    }
    follow_move(state, static_cast<double>(ImGui::GetIO().DeltaTime));
    draw_viewport(state, picture);
    draw_axis_gizmo(state);
    draw_side_panel(state);
    draw_status_panel(state);
    draw_help_panel(state);
    draw_gallery_page(state);
    draw_command_palette(state);
    draw_dialogs(state);
}

std::uint32_t behind_picture(Theme theme) { return palette(theme).sky; }

Texture::Tint undecided_tint(Theme theme) {
    return {.solid = palette(theme).undecided,
            .pale = palette(theme).undecided_pale,
            .coarse = palette(theme).coarse};
}

}  // namespace zeroset::ui
