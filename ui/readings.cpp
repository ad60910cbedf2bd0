#include "ui/readings.hpp"

#include "ui/fonts.hpp"
#include "ui/formula_field.hpp"
#include "ui/label.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

float row_pitch() { return std::ceil(em(1.2F)); }

std::string all_of(const std::vector<Reading>& readings) {
    std::string text;
    for (const Reading& reading : readings) {
        text += reading.text + '\n';
    }
    return text;
}

void draw_copy_menu(const UiState& state, const Reading& reading) {
    for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right}) {
        if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(button)) ImGui::OpenPopup("##copy");
    }
    if (!ImGui::BeginPopup("##copy")) return;
    ImGui::PushFont(font(FontRole::Text));
    ImGui::PushStyleColor(ImGuiCol_Text, palette(state.theme).text);
    if (ImGui::MenuItem("Copy")) ImGui::SetClipboardText(reading.text.c_str());
    if (state.readings.size() > 1 && ImGui::MenuItem("Copy all lines")) {
        ImGui::SetClipboardText(all_of(state.readings).c_str());
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::EndPopup();
}

/// Left of the text, so that the texts of all readings begin at the same place.
void draw_swatch(std::uint32_t color, const Palette& colors) {
    const float size = std::round(em(0.6F));
    ImVec2 lo = ImGui::GetCursorScreenPos();
    lo.y += std::round(0.5F * (ImGui::GetTextLineHeight() - size));
    const ImVec2 hi(lo.x + size, lo.y + size);
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const float rounding = 0.25F * size;
    canvas.AddRectFilled(lo, hi, color | 0xFF000000U, rounding);
    canvas.AddRect(lo, hi, colors.border, rounding);
}

void draw_reading(const UiState& state, const Reading& reading, bool indented) {
    const Palette& colors = palette(state.theme);
    if (reading.color) draw_swatch(*reading.color, colors);
    if (indented) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + em(1.0F));
    const bool cut = draw_elided(in_one_line(reading.text), ImGui::GetContentRegionAvail().x);
    if (cut) draw_tooltip(reading.text, 60.0F);
    if (ImGui::IsItemHovered()) {
        const ImVec2 lo = ImGui::GetItemRectMin();
        const ImVec2 hi = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddLine(ImVec2(lo.x, hi.y), hi, colors.border);
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    draw_copy_menu(state, reading);
}

}  // namespace

float readings_height(int rows) {
    const float text = font(FontRole::Text)->FontSize * ImGui::GetIO().FontGlobalScale;
    return text + static_cast<float>(rows - 1) * row_pitch();
}

void draw_readings(const UiState& state, int rows) {
    const bool colored = std::ranges::any_of(
        state.readings, [](const Reading& reading) { return reading.color.has_value(); });
    ImGui::PushFont(font(FontRole::SmallFormula));
    ImGui::PushStyleColor(ImGuiCol_Text, palette(state.theme).quiet);
    ImGui::BeginChild("##readings", ImVec2(0.0F, readings_height(rows)), false,
                      ImGuiWindowFlags_NoNav);
    for (std::size_t i = 0; i < state.readings.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetCursorPosY(static_cast<float>(i) * row_pitch());
        draw_reading(state, state.readings[i], colored);
        ImGui::PopID();
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void draw_error(const UiState& state) {
    const Palette& colors = palette(state.theme);
    std::string text = state.error;
    if (state.error_at && !state.unfinished && formula_lines(state) > 1) {
        const std::size_t at = std::min(*state.error_at, state.equation.size());
        const auto end = state.equation.begin() + static_cast<std::ptrdiff_t>(at);
        text = "line " + std::to_string(1 + std::count(state.equation.begin(), end, '\n')) + ": " +
               text;
    }
    ImGui::PushFont(font(FontRole::Text));
    ImGui::PushStyleColor(ImGuiCol_Text, state.unfinished ? colors.quiet : colors.error);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace zeroset::ui
