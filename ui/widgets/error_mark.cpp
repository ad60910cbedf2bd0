#include "ui/widgets/error_mark.hpp"

#include "engine/base/utf8.hpp"
#include "ui/style/theme.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace zeroset::ui {
namespace {

/// Rectangle of the character at byte `at`, window coordinates; a line's end is as wide as "0".
ImRect character_place(const FieldView& view, const std::string& text, std::size_t at) {
    at = std::min(at, text.size());
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    const bool visible = at < text.size() && text[at] != '\n';
    const char* bytes = text.c_str();
    const float x = view.text_pos.x + ImGui::CalcTextSize(bytes + begin, bytes + at).x;
    const float wide = visible
                           ? ImGui::CalcTextSize(bytes + at, bytes + end_of_character(text, at)).x
                           : ImGui::CalcTextSize("0").x;
    const float y = view.text_pos.y + static_cast<float>(line) * ImGui::GetFontSize();
    return {x, y, x + wide, y + ImGui::GetFontSize()};
}

/// Draws a triangle at the edge of `space` that points towards `place` outside it.
void draw_arrow(ImDrawList& canvas, const ImRect& space, const ImRect& place, std::uint32_t color) {
    const float size = em(0.4F);
    const auto arrow = [&](ImVec2 tip, ImVec2 back) {
        const ImVec2 side(0.75F * back.y, 0.75F * back.x);
        const ImVec2 base(tip.x + back.x, tip.y + back.y);
        canvas.AddTriangleFilled(tip, ImVec2(base.x + side.x, base.y + side.y),
                                 ImVec2(base.x - side.x, base.y - side.y), color);
    };
    const float middle = 0.5F * (place.Min.x + place.Max.x);
    const float x = std::clamp(middle, space.Min.x + size, space.Max.x - size);
    if (place.Max.y < space.Min.y + size) {
        arrow(ImVec2(x, space.Min.y), ImVec2(0.0F, size));
    } else if (place.Min.y > space.Max.y - size) {
        arrow(ImVec2(x, space.Max.y), ImVec2(0.0F, -size));
    } else if (middle < space.Min.x) {
        arrow(ImVec2(space.Min.x, place.Max.y), ImVec2(size, 0.0F));
    } else {
        arrow(ImVec2(space.Max.x, place.Max.y), ImVec2(-size, 0.0F));
    }
}

/// Part of the field that the surrounding window does not clip.
ImRect visible_part(const FieldView& view) {
    ImRect part = view.inside;
    part.ClipWithFull(ImGui::GetCurrentWindow()->ClipRect);
    return part;
}

}  // namespace

FieldView view_of(ImGuiID field, ImGuiWindow& window) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImGuiID active = ImGui::GetActiveID();
    const bool typing =
        active == field || active == ImGui::GetWindowScrollbarID(&window, ImGuiAxis_Y);
    const ImGuiInputTextState* state = typing ? ImGui::GetInputTextState(field) : nullptr;
    ImRect inside = window.Rect();
    inside.Max.x -= window.ScrollbarSizes.x;
    const float scroll_x = state != nullptr ? state->ScrollX : 0.0F;
    return {.window = &window,
            .inside = inside,
            .text_pos = ImVec2(inside.Min.x + padding.x - scroll_x,
                               inside.Min.y + padding.y - window.Scroll.y)};
}

void draw_error_mark(const FieldView& view, const std::string& text, std::size_t at,
                     std::uint32_t color) {
    const ImRect place = character_place(view, text, at);
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImRect space(view.inside.Min.x + 0.5F * padding.x, view.inside.Min.y + em(0.1F),
                       view.inside.Max.x - 0.5F * padding.x, view.inside.Max.y - em(0.1F));
    ImDrawList& canvas = *view.window->DrawList;
    const ImRect clip = visible_part(view);
    canvas.PushClipRect(clip.Min, clip.Max, false);
    const float thick = em(0.15F);  // the free space above the next line's letters
    const float y = place.Max.y;
    const bool seen = place.Min.x >= space.Min.x && place.Max.x <= space.Max.x &&
                      place.Min.y + 0.5F * place.GetHeight() >= space.Min.y &&
                      y + thick <= view.inside.Max.y;
    if (seen) {
        canvas.AddRectFilled(ImVec2(place.Min.x, y), ImVec2(place.Max.x, y + thick), color,
                             0.5F * thick);
    } else {
        draw_arrow(canvas, space, place, color);
    }
    canvas.PopClipRect();
}

void draw_hint(const FieldView& view, const char* hint, std::uint32_t color) {
    ImDrawList& canvas = *view.window->DrawList;
    const ImRect clip = visible_part(view);
    canvas.PushClipRect(clip.Min, clip.Max, false);
    canvas.AddText(view.text_pos, color, hint);
    canvas.PopClipRect();
}

}  // namespace zeroset::ui
