#include "ui/window/navigation.hpp"

#include "ui/style/keys.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

namespace zeroset::ui {

namespace {

/// Whether the window is a list or a menu that is open and walked through by arrows.
bool is_list(const ImGuiWindow* window) {
    if (window == nullptr) return false;
    const bool is_walked = (window->Flags & ImGuiWindowFlags_NoNavInputs) == 0;
    const bool is_modal = (window->Flags & ImGuiWindowFlags_Modal) != 0;
    return (window->Flags & ImGuiWindowFlags_Popup) != 0 && is_walked && !is_modal;
}

}  // namespace

void Navigation::follow() {
    ImGuiContext& gui = *ImGui::GetCurrentContext();
    const bool marks = (gui.IO.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0;
    // Released alone, Alt would go to a menu bar, and there is none.
    gui.NavWindowingToggleLayer = false;
    const bool moved = gui.NavJustMovedToId != 0;
    if (tabbed_ && moved && marks) gui.NavDisableHighlight = false;
    // From a control that is not there any more the walk begins anew.
    if (tabbed_ && !moved && gui.ActiveId == 0) gui.NavId = 0;
    tabbed_ = is_pressed(ImGuiKey_Tab);
    // ImGui walks on from what is active only, else it begins at the first control.
    if (tabbed_ && gui.NavTabbingDir == 0 && gui.NavId != 0) gui.NavTabbingDir = +1;
    // In lists and menus Enter presses, as Space does.
    const bool enter = is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter);
    if (enter && gui.ActiveId == 0 && is_list(gui.NavWindow))
        gui.NavActivateId = gui.NavActivateDownId = gui.NavId;
    // ImGui has marked the panel that the keyboard is in.
    const bool closed = had_popup_;
    had_popup_ = gui.OpenPopupStack.Size > 0;
    if (is_pressed_once(ImGuiKey_Escape) && gui.ActiveId == 0 && !closed && !had_popup_)
        ImGui::SetWindowFocus(nullptr);
}

}  // namespace zeroset::ui
