#include "engine/base/translation.hpp"
#include "engine/view/camera.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/sections.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
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

void draw_projection(std::optional<Camera>& camera) {
    if (!camera) return;
    bool perspective = camera->projection == Projection::Perspective;
    if (ImGui::Checkbox(labelled(tr("Perspective"), "###perspective").c_str(), &perspective))
        camera->projection = perspective ? Projection::Perspective : Projection::Orthographic;
    draw_tooltip(tr("Things get smaller with distance; else all rays have one direction (5)."));
}

void draw_light(UiState& state) {
    Document& document = state.edited.document;
    bool smooth = document.antialias != Antialias::None;
    if (ImGui::Checkbox(labelled(tr("Smooth edges"), "###antialias").c_str(), &smooth))
        action_named("Smooth edges").run(state);
    draw_tooltip(
        tr("Show pixels part by part where they hold more than one smooth sheet, "
           "once the picture rests."));
    ImGui::SameLine(0.0F, em(1.2F));
    ImGui::Checkbox(labelled(tr("Shadows"), "###shadows").c_str(), &document.shadows);
    draw_tooltip(tr("Let the surfaces throw shadows, once the picture rests."));
}

void draw_reset_and_theme(UiState& state) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x);
    const bool dark = state.edited.theme == Theme::Dark;
    const char* const reset = tr("Reset view");
    const char* const other = dark ? tr("Light theme") : tr("Dark theme");
    const float needed = std::max(ImGui::CalcTextSize(reset).x, ImGui::CalcTextSize(other).x);
    const bool wide = half >= needed + style.FramePadding.x;
    const ImVec2 size(half, 0.0F);
    if (ImGui::Button(labelled(wide ? reset : tr("Reset"), "###reset").c_str(), size))
        state.wishes.reset_view = true;
    draw_tooltip(tr("Look at the whole box again (R)."));
    ImGui::SameLine();
    const char* const brief = dark ? tr_in("theme", "Light") : tr_in("theme", "Dark");
    if (ImGui::Button(labelled(wide ? other : brief, "###theme").c_str(), size)) {
        action_named("Light theme").run(state);
    }
    if (!wide) draw_tooltip(other);
}

}  // namespace

float view_section_height() { return 6.0F * ImGui::GetFrameHeightWithSpacing(); }

void draw_view_section(UiState& state) {
    draw_action_switch(state, tr("Axes"), "Axes");
    ImGui::SameLine(0.0F, em(1.0F));
    draw_action_switch(state, tr("Box"), "Clip box");
    ImGui::SameLine(0.0F, em(1.0F));
    draw_action_switch(state, tr("Grid"), "Grid");
    draw_names(state.edited.document);
    constexpr std::array<Button, 5> views{
        {{.label = marked("Front"), .action = "View from the front"},
         {.label = marked("Top"), .action = "View from above"},
         {.label = marked("Right"), .action = "View from the right"},
         {.label = marked("Corner"), .action = "Isometric view"},
         {.label = marked("Frame"), .action = "Frame the surface"}}};
    draw_buttons(state, views);
    draw_light(state);
    draw_projection(state.edited.document.camera);
    draw_reset_and_theme(state);
}

}  // namespace zeroset::ui
