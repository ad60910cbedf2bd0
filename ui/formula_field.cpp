#include "ui/formula_field.hpp"

#include "ui/fonts.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace zeroset::ui {
namespace {

constexpr const char* hint = "type an equation, for example  x^2 + y^2 + z^2 = 1";
constexpr const char* short_hint = "type an equation";

bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// One after the UTF-8 character at `at`, at most the text's size.
std::size_t next_character(const std::string& text, std::size_t at) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) {
        ++at;
    }
    return std::min(at, text.size());
}

/// Whether this frame's Enter begins a line; the formula's field is the only one with lines.
bool begins_line() {
    const ImGuiInputTextState& typing = ImGui::GetCurrentContext()->InputTextState;
    const bool active = typing.ID != 0 && ImGui::GetActiveID() == typing.ID;
    return active && typing.Stb.single_line == 0 && !ImGui::GetIO().KeyCtrl &&
           (is_pressed(ImGuiKey_Enter) || is_pressed(ImGuiKey_KeyPadEnter));
}

/// Escape leaves the field and keeps what was typed; ImGui by itself would restore the old text.
/// Tab leaves it, too; ImGui by itself would come back to the bar's only field.
void leave_on_keys(ImGuiID field) {
    if (ImGui::GetActiveID() != field) return;
    const bool tab = is_pressed(ImGuiKey_Tab);
    if (!tab && !is_pressed(ImGuiKey_Escape)) return;
    ImGui::ClearActiveID();
    if (tab) ImGui::NavMoveRequestCancel();
}

/// ImGui activates the field in the frame after it is asked to.
void take_keyboard(bool& wanted, ImGuiID field) {
    if (!wanted) return;
    ImGuiInputTextState* typing = ImGui::GetInputTextState(field);
    if (ImGui::GetActiveID() == field && typing != nullptr) {
        typing->SelectAll();
        wanted = false;
    } else {
        ImGui::SetKeyboardFocusHere();
    }
}

/// What of the text the field shows, window coordinates. ImGui makes a window of the field.
struct FieldView {
    ImGuiWindow* window;
    ImRect inside;    ///< without the scrollbar
    ImVec2 text_pos;  ///< of the first character, wherever it was scrolled to
};

FieldView view_of(ImGuiID field, ImGuiWindow& window) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImGuiID active = ImGui::GetActiveID();
    const bool typing =
        active == field || active == ImGui::GetWindowScrollbarID(&window, ImGuiAxis_Y);
    const ImGuiInputTextState* state = typing ? ImGui::GetInputTextState(field) : nullptr;
    ImRect inside = window.Rect();
    inside.Max.x -= window.ScrollbarSizes.x;
    const float scroll_x = state != nullptr ? state->ScrollX : 0.0F;
    return {
        &window, inside,
        ImVec2(inside.Min.x + padding.x - scroll_x, inside.Min.y + padding.y - window.Scroll.y)};
}

/// Where the character at `at` stands in the field; a narrow place after the end of a line.
ImRect character_place(const FieldView& view, const std::string& text, std::size_t at) {
    at = std::min(at, text.size());
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    const bool visible = at < text.size() && text[at] != '\n';
    const char* bytes = text.c_str();
    const float x = view.text_pos.x + ImGui::CalcTextSize(bytes + begin, bytes + at).x;
    const float wide = visible ? ImGui::CalcTextSize(bytes + at, bytes + next_character(text, at)).x
                               : ImGui::CalcTextSize("0").x;
    const float y = view.text_pos.y + static_cast<float>(line) * ImGui::GetFontSize();
    return {x, y, x + wide, y + ImGui::GetFontSize()};
}

/// A triangle whose tip is at an edge of the field, towards what lies beyond it.
void draw_arrow(ImDrawList& canvas, const ImRect& room, const ImRect& place, std::uint32_t color) {
    const float size = em(0.4F);
    const auto arrow = [&](ImVec2 tip, ImVec2 back) {
        const ImVec2 side(0.75F * back.y, 0.75F * back.x);
        const ImVec2 base(tip.x + back.x, tip.y + back.y);
        canvas.AddTriangleFilled(tip, ImVec2(base.x + side.x, base.y + side.y),
                                 ImVec2(base.x - side.x, base.y - side.y), color);
    };
    const float middle = 0.5F * (place.Min.x + place.Max.x);
    const float x = std::clamp(middle, room.Min.x + size, room.Max.x - size);
    if (place.Max.y < room.Min.y + size) {
        arrow(ImVec2(x, room.Min.y), ImVec2(0.0F, size));
    } else if (place.Min.y > room.Max.y - size) {
        arrow(ImVec2(x, room.Max.y), ImVec2(0.0F, -size));
    } else if (middle < room.Min.x) {
        arrow(ImVec2(room.Min.x, place.Max.y), ImVec2(size, 0.0F));
    } else {
        arrow(ImVec2(room.Max.x, place.Max.y), ImVec2(-size, 0.0F));
    }
}

/// Underlines the wrong character, or points to where it was scrolled to.
void draw_error_mark(const FieldView& view, const UiState& state) {
    const std::uint32_t color = palette(state.theme).error;
    const ImRect place = character_place(view, state.equation, *state.error_at);
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImRect room(view.inside.Min.x + 0.5F * padding.x, view.inside.Min.y + em(0.1F),
                      view.inside.Max.x - 0.5F * padding.x, view.inside.Max.y - em(0.1F));
    ImDrawList& canvas = *view.window->DrawList;
    canvas.PushClipRect(view.inside.Min, view.inside.Max, false);
    const float thick = em(0.15F);  // as much as is free above the next line's letters
    const float y = place.Max.y;
    const bool seen = place.Min.x >= room.Min.x && place.Max.x <= room.Max.x &&
                      place.Min.y + 0.5F * place.GetHeight() >= room.Min.y &&
                      y + thick <= view.inside.Max.y;
    if (seen) {
        canvas.AddRectFilled(ImVec2(place.Min.x, y), ImVec2(place.Max.x, y + thick), color,
                             0.5F * thick);
    } else {
        draw_arrow(canvas, room, place, color);
    }
    canvas.PopClipRect();
}

void draw_hint(const FieldView& view, std::uint32_t color) {
    const float room = view.inside.GetWidth() - 2.0F * ImGui::GetStyle().FramePadding.x;
    const char* text = ImGui::CalcTextSize(hint).x <= room ? hint : short_hint;
    ImDrawList& canvas = *view.window->DrawList;
    canvas.PushClipRect(view.inside.Min, view.inside.Max, false);
    canvas.AddText(view.text_pos, color, text);
    canvas.PopClipRect();
}

}  // namespace

float formula_field_height(int lines) {
    const float line = font(FontRole::Formula)->FontSize * ImGui::GetIO().FontGlobalScale;
    return std::ceil(static_cast<float>(lines) * line + 2.0F * ImGui::GetStyle().FramePadding.y);
}

int formula_lines(const UiState& state) {
    return 1 + (begins_line() ? 1 : 0) + static_cast<int>(std::ranges::count(state.equation, '\n'));
}

void draw_formula_field(UiState& state, float width, int lines) {
    const Palette& colors = palette(state.theme);
    ImGui::PushFont(font(FontRole::Formula));
    const ImGuiID field = ImGui::GetID("##equation");
    leave_on_keys(field);
    take_keyboard(state.focus_equation, field);
    ImGui::InputTextMultiline("##equation", &state.equation,
                              ImVec2(width, formula_field_height(lines)));
    const auto& children = ImGui::GetCurrentWindow()->DC.ChildWindows;
    if (!children.empty()) {
        const FieldView view = view_of(field, *children.back());
        if (state.equation.empty()) {
            draw_hint(view, colors.quiet);
        } else if (!state.error.empty() && !state.unfinished && state.error_at) {
            draw_error_mark(view, state);
        }
    }
    ImGui::PopFont();
}

}  // namespace zeroset::ui
