#include "ui/panels/view_section.hpp"

#include "engine/view/camera.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <optional>
#include <string>

namespace zeroset::ui {
namespace {

void draw_projection(std::optional<Camera>& camera) {
    if (!camera) return;
    bool parallel = camera->projection == Projection::Orthographic;
    if (ImGui::Checkbox("Parallel rays###parallel", &parallel))
        camera->projection = parallel ? Projection::Orthographic : Projection::Perspective;
    draw_tooltip("All rays leave the picture in one direction, none is nearer to the eye (5).");
}

void draw_light(Document& document) {
    ImGui::Checkbox("Shadows###shadows", &document.shadows);
    draw_tooltip("Let the surfaces throw shadows, once the picture rests.");
    ImGui::SameLine(0.0F, em(1.2F));
    bool smooth = document.antialias != Antialias::None;
    if (ImGui::Checkbox("Smooth edges###antialias", &smooth))
        document.antialias = smooth_edges(smooth);
    draw_tooltip(
        "Show pixels part by part where they hold more than one smooth sheet, "
        "once the picture rests.");
}

const char* shown_name(WheelUse use) {
    switch (use) {
        case WheelUse::Zoom: return "zooms";
        case WheelUse::Orbit: return "orbits";
        case WheelUse::Pan: return "pans";
    }
    return "";
}

void draw_wheel(WheelUse& use) {
    draw_label(
        "scroll",
        "What the wheel, or two fingers on a touchpad, do over the picture. Where they orbit "
        "or pan, Shift changes to the other and Ctrl zooms.");
    if (!ImGui::BeginCombo("##wheel", shown_name(use))) return;
    for (const WheelUse other : {WheelUse::Zoom, WheelUse::Orbit, WheelUse::Pan}) {
        if (ImGui::Selectable(shown_name(other), other == use)) use = other;
    }
    ImGui::EndCombo();
}

void draw_buttons(UiState& state) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x);
    const bool wide = half >= ImGui::CalcTextSize("Light theme").x + style.FramePadding.x;
    const ImVec2 size(half, 0.0F);
    if (ImGui::Button(wide ? "Reset view###reset" : "Reset###reset", size))
        state.wishes.reset_view = true;
    draw_tooltip("Look at the whole box again (R).");
    ImGui::SameLine();
    const bool dark = state.edited.theme == Theme::Dark;
    const std::string other = dark ? "Light" : "Dark";
    if (ImGui::Button((other + (wide ? " theme" : "") + "###theme").c_str(), size)) {
        action_named("Light theme").run(state);
    }
    if (!wide) draw_tooltip(other + " theme");
}

}  // namespace

float view_section_height() { return 4.0F * ImGui::GetFrameHeightWithSpacing(); }

void draw_view_section(UiState& state) {
    draw_projection(state.edited.document.camera);
    draw_light(state.edited.document);
    draw_wheel(state.edited.layout.wheel);
    draw_buttons(state);
}

}  // namespace zeroset::ui
