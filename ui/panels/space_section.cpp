#include "engine/base/translation.hpp"
#include "ui/actions/actions.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/sections.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace zeroset::ui {
namespace {

struct Button {
    const char* label;
    const char* action;
};

/// Draws the buttons in one row, each as wide as its text wants it.
void draw_buttons(UiState& state, std::span<const Button> buttons) {
    const float gap = em(0.35F);
    const float pad = em(0.1F);
    const auto count = static_cast<float>(buttons.size());
    float texts = 0.0F;
    for (const Button& button : buttons)
        texts += ImGui::CalcTextSize(tr(button.label)).x;
    const float space = ImGui::GetContentRegionAvail().x - (count - 1.0F) * gap - texts;
    const float more = space / count;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(pad, ImGui::GetStyle().FramePadding.y));
    for (const Button& button : buttons) {
        const float width = ImGui::CalcTextSize(tr(button.label)).x + more;
        if (&button != buttons.data()) ImGui::SameLine(0.0F, gap);
        const Action& action = action_named(button.action);
        const std::string id = elided(tr(button.label), width - 2.0F * pad) + "###" + button.action;
        if (ImGui::Button(id.c_str(), ImVec2(width, 0.0F))) action.run(state);
        draw_tooltip(described(action));
    }
    ImGui::PopStyleVar();
}

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

/// Draws three fields with the names of the axes.
void draw_names(Document& document) {
    draw_label(tr("names"), tr("What the axes are called in the picture."));
    const float gap = em(0.35F);
    const float width = (ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F;
    for (std::size_t axis = 0; axis < document.axis_names.size(); ++axis) {
        if (axis > 0) ImGui::SameLine(0.0F, gap);
        ImGui::PushID(static_cast<int>(axis));
        ImGui::SetNextItemWidth(width);
        std::string name = document.axis_names.at(axis);
        if (ImGui::InputText("##name", &name) && name.size() <= longest_label)
            document.axis_names.at(axis) = name;
        ImGui::PopID();
    }
}

}  // namespace

float space_section_height() { return 6.0F * ImGui::GetFrameHeightWithSpacing(); }

void draw_space_section(UiState& state) {
    draw_action_switch(state, tr("Axes, box and grid"), "Axes, box and grid");
    draw_action_switch(state, tr("Axes"), "Axes");
    ImGui::SameLine(0.0F, em(1.0F));
    draw_action_switch(state, tr("Box"), "Clip box");
    ImGui::SameLine(0.0F, em(1.0F));
    draw_action_switch(state, tr("Grid"), "Grid");
    draw_names(state.edited.document);
    draw_up(state);
    draw_action_switch(state, tr("Turn freely"), "Turn freely");
    constexpr std::array<Button, 5> views{
        {{.label = marked("Front"), .action = "View from the front"},
         {.label = marked("Right"), .action = "View from the right"},
         {.label = marked("Top"), .action = "View from above"},
         {.label = marked("Corner"), .action = "Isometric view"},
         {.label = marked("Frame"), .action = "Frame the surface"}}};
    draw_buttons(state, views);
}

}  // namespace zeroset::ui
