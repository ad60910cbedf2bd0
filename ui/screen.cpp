#include "ui/screen.hpp"

#include "ui/actions/action_functions.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/exports/export_page.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/pages/command_palette.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/panels/panels.hpp"
#include "ui/picture/axis_gizmo.hpp"
#include "ui/picture/view_notice.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/texture.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace zeroset::ui {

namespace {

/// Drops the wish to give a row the keyboard if a dialog is open, the panel not shown or the row
/// gone.
void check_focus(std::optional<RowFocus>& focus, const Edited& edited, bool asks) {
    if (!focus) return;
    const std::vector<Statement>& rows = edited.document.statements;
    const bool there = std::ranges::find(rows, focus->row, &Statement::id) != rows.end();
    if (asks || edited.layout.folded || edited.layout.presents || !there) focus.reset();
}

}  // namespace

void draw_screen(UiState& state, const Texture& picture) {
    Pages& pages = state.pages;
    const Theme theme = state.edited.theme;
    const bool asks = pages.dialogs.question || pages.dialogs.file;
    check_focus(state.wishes.focus, state.edited, asks);
    if (!asks) {
        follow_shortcuts(state);
        follow_help_keys(pages.help, state.input);
        follow_export_keys(state);
        follow_tour_keys(state);
    }
    follow_move(state, static_cast<double>(ImGui::GetIO().DeltaTime));
    draw_viewport(state, picture);
    if (state.edited.layout.presents) {
        draw_presentation(state);
    } else {
        draw_axis_gizmo(state);
        draw_view_notice(state);
        draw_side_panel(state);
        draw_status_panel(state.edited, state.shown);
    }
    draw_help_panel(pages.help, state.shown.language_help, theme);
    if (!state.edited.layout.presents) draw_tour(state);
    draw_export_page(state);
    draw_gallery_page(state);
    draw_command_palette(state);
    draw_dialogs(pages.dialogs, theme);
}

std::uint32_t behind_picture(Theme theme) { return palette(theme).sky; }

Texture::Tint undecided_tint(Theme theme) {
    return {.solid = palette(theme).undecided,
            .pale = palette(theme).undecided_pale,
            .coarse = palette(theme).coarse};
}

}  // namespace zeroset::ui
