#pragma once

#include <GLFW/glfw3.h>
#include <imgui/imgui.h>

#include <algorithm>

namespace zeroset::ui {

/// True if the key went down or repeated in this frame.
inline bool is_pressed(ImGuiKey key) {
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && ImGui::IsKeyPressed(index);
}

/// True if the key went down in this frame; repeats do not count.
inline bool is_pressed_once(ImGuiKey key) {
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && ImGui::IsKeyPressed(index, false);
}

/// True if the key of the letter `letter` ('a' to 'z') went down or repeated in this frame. Windows
/// number keys as GLFW does, and a letter key by what it types, wherever it lies on the keyboard.
inline bool is_letter_pressed(char letter) {
    return ImGui::IsKeyPressed(GLFW_KEY_A + (letter - 'a'));
}

/// True if the letter was typed in this frame, in either case; `lower` is from 'a' to 'z'.
inline bool is_typed(char lower) {
    const ImVector<ImWchar>& typed = ImGui::GetIO().InputQueueCharacters;
    const char upper = static_cast<char>(lower - 'a' + 'A');
    return std::any_of(typed.begin(), typed.end(), [=](ImWchar letter) {
        return letter == static_cast<ImWchar>(lower) || letter == static_cast<ImWchar>(upper);
    });
}

}  // namespace zeroset::ui
