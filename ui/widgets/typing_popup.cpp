#include "ui/widgets/typing_popup.hpp"

#include "ui/style/keys.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

namespace zeroset::ui {
namespace {

/// Number of frames after which a field that does not have the keyboard will not get it.
constexpr int patience_frames = 5;

bool is_opening(const TypingPopup& popup) {
    return popup.open && !popup.has_keyboard && popup.frames < patience_frames;
}

}  // namespace

bool follow_popup(TypingPopup& popup, const char* name) {
    if (popup.frames > 0 && !ImGui::IsPopupOpen(name)) popup.open = false;
    popup.frames = popup.open ? popup.frames + 1 : 0;
    if (!popup.open) {
        popup.has_keyboard = false;
    } else if (!ImGui::IsPopupOpen(name)) {
        ImGui::OpenPopup(name);
    }
    return popup.open;
}

void draw_popup(const TypingPopup& popup, const char* name, const std::function<void()>& draw) {
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav;
    if (!ImGui::BeginPopup(name, flags)) return;
    draw();
    if (!popup.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

bool draw_popup_field(TypingPopup& popup, const char* hint, std::string& text) {
    // Enter, or a press beside the field, takes the keyboard from it.
    const bool lost = popup.frames > patience_frames && !popup.has_keyboard &&
                      !ImGui::IsAnyItemActive() &&
                      ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    if (ImGui::IsWindowAppearing() || lost) ImGui::SetKeyboardFocusHere();
    // The field would take back what was typed since it has had the keyboard.
    if (popup.has_keyboard && is_pressed(ImGuiKey_Escape)) ImGui::ClearActiveID();
    const bool changed =
        ImGui::InputTextWithHint("##typed", hint, &text, ImGuiInputTextFlags_AutoSelectAll);
    popup.has_keyboard = ImGui::IsItemActive();
    return changed;
}

bool awaits_keyboard(const Wishes& wishes, const Pages& pages) {
    return wishes.focus.has_value() || is_opening(pages.gallery) || is_opening(pages.commands);
}

}  // namespace zeroset::ui
