#pragma once

#include <GLFW/glfw3.h>
#include <imgui/imgui.h>

#include <algorithm>

namespace zeroset::ui {

/// Whether the key went down in this frame, or repeats.
inline bool is_pressed(ImGuiKey key) {
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && ImGui::IsKeyPressed(index);
}

/// The same without repeats.
inline bool is_pressed_once(ImGuiKey key) {
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && ImGui::IsKeyPressed(index, false);
}

/// Whether a letter went down or repeats, from 'a' to 'z'; windows number the keys as GLFW does and
/// report letters by what they type, wherever they lie on the keyboard.
inline bool is_letter_pressed(char letter) {
    return ImGui::IsKeyPressed(GLFW_KEY_A + (letter - 'a'));
}

/// Whether a letter was typed in this frame, by what it says; `lower` from 'a' to 'z'.
inline bool is_typed(char lower) {
    const ImVector<ImWchar>& typed = ImGui::GetIO().InputQueueCharacters;
    const char upper = static_cast<char>(lower - 'a' + 'A');
    return std::any_of(typed.begin(), typed.end(), [=](ImWchar letter) {
        return letter == static_cast<ImWchar>(lower) || letter == static_cast<ImWchar>(upper);
    });
}

}  // namespace zeroset::ui
