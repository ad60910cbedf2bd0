#include "engine/base/translation.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/sections.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cstddef>

namespace zeroset::ui {
namespace {

void draw_up(UiState& state) {
    draw_label(tr("up"), tr("What is up in the picture; dragging turns about it."));
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 up(0.0);
        up[axis] = 1.0;
        const char* const name = names[static_cast<std::size_t>(axis)];
        if (axis > 0) ImGui::SameLine(0.0F, em(0.7F));
        if (ImGui::RadioButton(name, state.edited.document.up == up)) set_up(state, up);
    }
}

const char* shown_name(WheelUse use) {
    switch (use) {
        case WheelUse::Zoom: return tr("zooms");
        case WheelUse::Orbit: return tr("orbits");
        case WheelUse::Pan: return tr("pans");
    }
    return "";
}

void draw_wheel(WheelUse& use) {
    draw_label(
        tr("scroll"),
        tr("What the wheel, or two fingers on a touchpad, do over the picture. Where they orbit "
           "or pan, Shift changes to the other and Ctrl zooms."));
    if (!ImGui::BeginCombo("##wheel", shown_name(use))) return;
    for (const WheelUse other : {WheelUse::Zoom, WheelUse::Orbit, WheelUse::Pan}) {
        if (ImGui::Selectable(shown_name(other), other == use)) use = other;
    }
    ImGui::EndCombo();
}

}  // namespace

float space_section_height() { return 3.0F * ImGui::GetFrameHeightWithSpacing(); }

void draw_space_section(UiState& state) {
    draw_up(state);
    draw_action_switch(state, tr("Turn freely"), "Turn freely");
    draw_wheel(state.edited.layout.wheel);
}

}  // namespace zeroset::ui
