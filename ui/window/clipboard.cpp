#include "ui/window/clipboard.hpp"

#include <imgui/imgui.h>

namespace zeroset::ui {

std::string clipboard() {
    const char* const text = ImGui::GetClipboardText();
    return text == nullptr ? "" : text;
}

void set_clipboard(const std::string& text) { ImGui::SetClipboardText(text.c_str()); }

}  // namespace zeroset::ui
