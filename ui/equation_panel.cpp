#include "ui/equation_panel.hpp"

#include "ui/bar.hpp"
#include "ui/fonts.hpp"
#include "ui/gallery_picker.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace zeroset::ui {
namespace {

constexpr const char* hint = "type an equation, for example  x^2 + y^2 + z^2 = 1";
constexpr const char* short_hint = "type an equation";

float font_height(FontRole role) { return font(role)->FontSize * ImGui::GetIO().FontGlobalScale; }

/// Bytes of the first `characters` of a UTF-8 text.
std::size_t utf8_prefix(const std::string& text, std::size_t characters) {
    std::size_t at = 0;
    while (at < text.size() && characters > 0) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) {
            ++at;
        }
        --characters;
    }
    return at;
}

/// Escape leaves the field and keeps what was typed; ImGui by itself would restore the old text.
void leave_on_escape(ImGuiID field) {
    if (ImGui::GetActiveID() == field && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        ImGui::ClearActiveID();
    }
}

/// Underlines the wrong character in the field, which was drawn last in the current font. `column`
/// may be one after the end.
void draw_error_mark(ImGuiID field, const std::string& text, std::size_t column,
                     std::uint32_t color) {
    const ImVec2 lo = ImGui::GetItemRectMin();
    const ImVec2 hi = ImGui::GetItemRectMax();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const bool active = ImGui::GetActiveID() == field;
    const ImGuiInputTextState* typing = active ? ImGui::GetInputTextState(field) : nullptr;

    const std::size_t begin = utf8_prefix(text, column - 1);
    const std::size_t end = utf8_prefix(text, column);
    const char* bytes = text.c_str();
    const float before = ImGui::CalcTextSize(bytes, bytes + begin).x;
    const float wide = end > begin ? ImGui::CalcTextSize(bytes + begin, bytes + end).x
                                   : ImGui::CalcTextSize("0").x;
    const float x = lo.x + padding.x + before - (typing != nullptr ? typing->ScrollX : 0.0F);
    const float thick = em(0.2F);
    const float y = lo.y + padding.y + ImGui::GetFontSize() + em(0.05F);

    const float left = lo.x + 0.5F * padding.x;
    const float right = hi.x - 0.5F * padding.x;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    if (x < left || x + wide > right) {  // scrolled out of sight: an arrow towards it
        const float tip = x < left ? left : right;
        const float base = x < left ? tip + em(0.5F) : tip - em(0.5F);
        canvas.AddTriangleFilled(ImVec2(tip, y), ImVec2(base, y - em(0.3F)),
                                 ImVec2(base, y + em(0.3F)), color);
        return;
    }
    canvas.AddRectFilled(ImVec2(x, y), ImVec2(x + wide, y + thick), color, 0.5F * thick);
}

void draw_field(UiState& state, float width) {
    const Palette& colors = palette(state.theme);
    ImGui::PushFont(font(FontRole::Formula));
    ImGui::SetNextItemWidth(width);
    const ImGuiID field = ImGui::GetID("##equation");
    leave_on_escape(field);
    if (state.focus_equation) {
        ImGui::SetKeyboardFocusHere();
        state.focus_equation = false;
    }
    const float room = width - 2.0F * ImGui::GetStyle().FramePadding.x;
    const bool fits = ImGui::CalcTextSize(hint).x <= room;
    ImGui::InputTextWithHint("##equation", fits ? hint : short_hint, &state.equation);
    if (!state.error.empty() && state.error_column && !state.equation.empty()) {
        draw_error_mark(field, state.equation, std::max<std::size_t>(*state.error_column, 1),
                        colors.error);
    }
    ImGui::PopFont();
}

/// The text cut with an ellipsis to the width that is left; the whole of it in a tooltip.
void draw_elided(const std::string& text) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, ImVec2(at.x + width, at.y + size.y),
                              at.x + width, at.x + width, text.c_str(), text.c_str() + text.size(),
                              &size);
    ImGui::Dummy(ImVec2(std::min(size.x, width), size.y));
    if (size.x > width && ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(0.8F * ImGui::GetIO().DisplaySize.x);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

void draw_reading(const UiState& state) {
    const Palette& colors = palette(state.theme);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetStyle().FramePadding.x);
    if (state.error.empty() || state.equation.empty()) {
        ImGui::PushFont(font(FontRole::SmallFormula));
        ImGui::PushStyleColor(ImGuiCol_Text, colors.quiet);
        draw_elided(state.reading);
    } else {
        ImGui::PushFont(font(FontRole::Text));
        ImGui::PushStyleColor(ImGuiCol_Text, colors.error);
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(state.error.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace

float equation_bar_height() {
    const ImGuiStyle& style = ImGui::GetStyle();
    return 2.0F * style.WindowPadding.y + font_height(FontRole::Formula) +
           2.0F * style.FramePadding.y + style.ItemSpacing.y + font_height(FontRole::Text);
}

void draw_equation_panel(UiState& state) {
    const float width = ImGui::GetIO().DisplaySize.x;
    ImGui::SetNextWindowPos(ImVec2(0.0F, 0.0F));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, equation_bar_height()),
                                        ImVec2(width, FLT_MAX));
    if (begin_bar("##equation bar", palette(state.theme), ImGuiWindowFlags_AlwaysAutoResize)) {
        const float inner = width - 2.0F * ImGui::GetStyle().WindowPadding.x;
        const float picker = std::min(em(9.0F), 0.3F * inner);
        draw_field(state, inner - picker - ImGui::GetStyle().ItemSpacing.x);
        ImGui::SameLine();
        draw_gallery_picker(state, picker);
        draw_reading(state);
    }
    end_bar(Edge::Bottom, palette(state.theme));
}

}  // namespace zeroset::ui
