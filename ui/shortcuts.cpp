#include "ui/shortcuts.hpp"

#include "ui/keys.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <optional>

namespace zeroset::ui {
namespace {

bool pressed_once(char letter) { return ImGui::IsKeyPressed(GLFW_KEY_A + (letter - 'a'), false); }

/// Of the keys held with Ctrl.
std::optional<Command> pressed_command(bool typing) {
    const bool shift = ImGui::GetIO().KeyShift;
    if (is_letter_pressed('z')) return shift ? Command::Redo : Command::Undo;
    if (is_letter_pressed('y')) return Command::Redo;
    if (pressed_once('n')) return Command::New;
    if (pressed_once('o')) return Command::Open;
    if (pressed_once('s')) return shift ? Command::SaveAs : Command::Save;
    if (pressed_once('q')) return Command::Quit;
    // In a field these are about its text.
    if (typing) return std::nullopt;
    if (pressed_once('c')) return Command::Copy;
    if (pressed_once('v')) return Command::Paste;
    return std::nullopt;
}

}  // namespace

void follow_shortcuts(UiState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (std::ranges::any_of(io.MouseClicked, [](bool clicked) { return clicked; })) ++state.gesture;
    if (!io.KeyCtrl || io.KeyAlt || io.KeySuper) return;
    if (const auto command = pressed_command(io.WantTextInput)) state.command = command;
    if (pressed_once('b')) state.layout.folded = !state.layout.folded;
}

}  // namespace zeroset::ui
