#include "ui/actions/action_functions.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/widgets/chord.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <vector>

namespace zeroset::ui {
namespace {

struct Binding {
    const Action* action;
    Chord chord;
};

const std::vector<Binding>& bindings() {
    static const std::vector<Binding> all = [] {
        std::vector<Binding> found;
        for (const Action& action : actions()) {
            for (const Chord& chord : chords_of(action.keys))
                found.push_back({.action = &action, .chord = chord});
        }
        return found;
    }();
    return all;
}

}  // namespace

void follow_shortcuts(UiState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (std::ranges::any_of(io.MouseClicked, [](bool clicked) { return clicked; }))
        ++state.input.gesture;
    state.input.held = ImGui::IsAnyMouseDown();
    const bool typing = io.WantTextInput;
    for (const auto& [action, chord] : bindings()) {
        if (typing && !action->in_fields) continue;
        if (is_pressed(chord, action->repeats) && is_enabled(*action, state)) action->run(state);
    }
}

}  // namespace zeroset::ui
