#include "ui/actions/actions.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/label.hpp"

#include <imgui/imgui.h>

#include <string>

namespace zeroset::ui {

void draw_action_switch(UiState& state, const char* label, const char* name) {
    const Action& action = action_named(name);
    bool on = action.is_on(state);
    if (ImGui::Checkbox((std::string(label) + "###" + name).c_str(), &on)) action.run(state);
    draw_tooltip(described(action));
}

}  // namespace zeroset::ui
