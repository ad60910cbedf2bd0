#pragma once

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace zeroset::ui {

/// What of the text a field of several lines shows, window coordinates. ImGui makes a window of
/// the field.
struct FieldView {
    ImGuiWindow* window;
    ImRect inside;    ///< without the scrollbar
    ImVec2 text_pos;  ///< of the first character, wherever it was scrolled to
};

/// Of the field with this id, whose window is `window`; in the field's font.
FieldView view_of(ImGuiID field, ImGuiWindow& window);

/// Underlines the character at byte `at` of the text, or points to where it was scrolled to.
void draw_error_mark(const FieldView& view, const std::string& text, std::size_t at,
                     std::uint32_t color);

/// In place of the text of an empty field.
void draw_hint(const FieldView& view, const char* hint, std::uint32_t color);

}  // namespace zeroset::ui
