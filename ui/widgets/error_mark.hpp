#pragma once

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace zeroset::ui {

/// Geometry of a multi-line text field in window coordinates. ImGui makes a window of the field.
struct FieldView {
    ImGuiWindow* window;
    ImRect inside;    ///< the field without its scrollbar
    ImVec2 text_pos;  ///< position of the first character, even if it is scrolled out of sight
};

/// Returns the geometry of the field with this id, whose window is `window`. Call it while the
/// field's font is set.
FieldView view_of(ImGuiID field, ImGuiWindow& window);

/// Underlines the character at byte `at` of the text, or draws an arrow towards it where it is
/// scrolled out of sight.
void draw_error_mark(const FieldView& view, const std::string& text, std::size_t at,
                     std::uint32_t color);

/// Draws `hint` where the text of an empty field would stand.
void draw_hint(const FieldView& view, const char* hint, std::uint32_t color);

}  // namespace zeroset::ui
