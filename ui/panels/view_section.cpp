#include "engine/base/translation.hpp"
#include "engine/view/camera.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/sections.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <optional>

namespace zeroset::ui {
namespace {

void draw_projection(std::optional<Camera>& camera) {
    if (!camera) return;
    bool parallel = camera->projection == Projection::Orthographic;
    if (ImGui::Checkbox(labelled(tr("Parallel rays"), "###parallel").c_str(), &parallel))
        camera->projection = parallel ? Projection::Orthographic : Projection::Perspective;
    draw_tooltip(tr("All rays have one direction: things do not get smaller with distance (5)."));
}

void draw_light(UiState& state) {
    Document& document = state.edited.document;
    ImGui::Checkbox(labelled(tr("Shadows"), "###shadows").c_str(), &document.shadows);
    draw_tooltip(tr("Let the surfaces throw shadows, once the picture rests."));
    ImGui::SameLine(0.0F, em(1.2F));
    bool smooth = document.antialias != Antialias::None;
    if (ImGui::Checkbox(labelled(tr("Smooth edges"), "###antialias").c_str(), &smooth))
        action_named("Smooth edges").run(state);
    draw_tooltip(
        tr("Show pixels part by part where they hold more than one smooth sheet, "
           "once the picture rests."));
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

void draw_space_buttons(UiState& state) {
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

float view_section_height() { return 4.0F * ImGui::GetFrameHeightWithSpacing(); }

void draw_view_section(UiState& state) {
    draw_projection(state.edited.document.camera);
    draw_light(state);
    draw_wheel(state.edited.layout.wheel);
    draw_space_buttons(state);
}

}  // namespace zeroset::ui
