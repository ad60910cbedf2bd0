#include "ui/equation_panel.hpp"

#include "ui/bar.hpp"
#include "ui/fonts.hpp"
#include "ui/formula_field.hpp"
#include "ui/gallery_picker.hpp"
#include "ui/label.hpp"
#include "ui/readings.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cfloat>

namespace zeroset::ui {
namespace {

constexpr int most_lines = 6;
constexpr int most_readings = 4;
/// Of the window's height that the bar may take.
constexpr float most_of_window = 0.45F;

/// How much of the text and of its readings is seen without scrolling.
struct BarRows {
    int lines = 1;
    int readings = 1;
};

float bar_height(const BarRows& rows) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return 2.0F * style.WindowPadding.y + formula_field_height(rows.lines) + style.ItemSpacing.y +
           readings_height(rows.readings);
}

/// The text comes before its readings where the window is too low for both.
BarRows bar_rows(const UiState& state) {
    const float room = most_of_window * ImGui::GetIO().DisplaySize.y;
    const int lines = std::min(formula_lines(state), most_lines);
    const int readings = std::min(static_cast<int>(state.readings.size()), most_readings);
    BarRows rows;
    while (rows.lines < lines && bar_height({rows.lines + 1, 1}) <= room) {
        ++rows.lines;
    }
    while (rows.readings < readings && bar_height({rows.lines, rows.readings + 1}) <= room) {
        ++rows.readings;
    }
    return rows;
}

/// As high as one line of the field beside it, whose font is larger.
void draw_help_button(bool& shown, float size) {
    const float padding = 0.5F * (size - ImGui::GetFontSize());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(padding, padding));
    if (ImGui::Button("?", ImVec2(size, size))) shown = !shown;
    ImGui::PopStyleVar();
    draw_tooltip("Help: formulas and keys (F1)");
}

}  // namespace

float equation_bar_height(const UiState& state) { return bar_height(bar_rows(state)); }

void draw_equation_panel(UiState& state) {
    const BarRows rows = bar_rows(state);
    const float width = ImGui::GetIO().DisplaySize.x;
    ImGui::SetNextWindowPos(ImVec2(0.0F, 0.0F));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, bar_height(rows)), ImVec2(width, FLT_MAX));
    if (begin_bar("##equation bar", palette(state.theme), ImGuiWindowFlags_AlwaysAutoResize)) {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float inner = width - 2.0F * style.WindowPadding.x;
        const float picker = std::min(em(9.0F), 0.3F * inner);
        const float button = formula_field_height(1);
        draw_formula_field(state, inner - picker - button - 2.0F * style.ItemSpacing.x, rows.lines);
        ImGui::SameLine();
        draw_gallery_picker(state, picker);
        ImGui::SameLine();
        draw_help_button(state.show_help, button);
        ImGui::SetCursorPosX(style.WindowPadding.x + style.FramePadding.x);
        if (state.error.empty() || state.equation.empty()) {
            draw_readings(state, rows.readings);
        } else {
            draw_error(state);
        }
    }
    end_bar(Edge::Bottom, palette(state.theme));
}

}  // namespace zeroset::ui
