#include "ui/view_section.hpp"

#include "engine/trace/camera.hpp"
#include "engine/trace/scene.hpp"
#include "ui/label.hpp"
#include "ui/slider_row.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <glm/ext/vector_double3.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>

namespace zeroset::ui {
namespace {

constexpr int min_d_stop = 4;
constexpr double min_half = 1e-14;
constexpr double max_half = 1e6;

void draw_d_stop(StopCriterion& stop) {
    draw_label("d_stop",
               "Search depth: a ray's search ends at cells of the box's edge times "
               "2^-d_stop. More is finer and slower.");
    int depth = static_cast<int>(std::lround(stop.value));
    // Another rule can come from the command line; it stays until the slider is moved.
    const char* rule = stop.rule == StopRule::Epsilon ? "epsilon"
                       : stop.rule == StopRule::Delta ? "delta"
                                                      : nullptr;
    if (draw_integer_slider("##d_stop", depth, min_d_stop, max_d_stop, rule)) {
        stop = {StopRule::DStop, static_cast<double>(depth)};
    }
}

void draw_box(Box& clip) {
    draw_label("box \xC2\xB1", "Half the longest edge of the box that the surface is clipped to.");
    double half = 0.5 * clip.size();
    if (ImGui::InputDouble("##box", &half, 0.0, 0.0, "%.6g") && half >= min_half &&
        half <= max_half) {
        clip = resized(clip, half);
    }
}

void draw_light(Document& document) {
    ImGui::Checkbox("Shadows###shadows", &document.shadows);
    draw_tooltip("Let the surfaces throw shadows, once the picture rests.");
    ImGui::SameLine(0.0F, em(1.2F));
    ImGui::Checkbox("Smooth edges###antialias", &document.antialias);
    draw_tooltip("Five rays a pixel instead of one, once the picture rests.");
}

void draw_buttons(UiState& state) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x);
    const bool wide = half >= ImGui::CalcTextSize("Light theme").x + style.FramePadding.x;
    const ImVec2 size(half, 0.0F);
    if (ImGui::Button(wide ? "Reset view###reset" : "Reset###reset", size)) state.reset_view = true;
    draw_tooltip("Look at the whole box again (R).");
    ImGui::SameLine();
    const bool dark = state.theme == Theme::Dark;
    const std::string other = dark ? "Light" : "Dark";
    if (ImGui::Button((other + (wide ? " theme" : "") + "###theme").c_str(), size)) {
        state.theme = dark ? Theme::Light : Theme::Dark;
    }
    if (!wide) draw_tooltip(other + " theme");
}

}  // namespace

Box resized(const Box& box, double half) {
    const double factor = 2.0 * half / box.size();
    const glm::dvec3 centre = box.centre();
    return {centre + factor * (box.lo - centre), centre + factor * (box.hi - centre)};
}

float view_section_height(const UiState& /*state*/) {
    return 4.0F * ImGui::GetFrameHeightWithSpacing();
}

void draw_view_section(UiState& state) {
    draw_d_stop(state.document.stop);
    draw_box(state.document.clip);
    draw_light(state.document);
    draw_buttons(state);
}

}  // namespace zeroset::ui
