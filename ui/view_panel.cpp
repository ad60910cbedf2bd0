#include "ui/view_panel.hpp"

#include "engine/trace/camera.hpp"
#include "engine/trace/scene.hpp"
#include "ui/equation_panel.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <glm/ext/vector_double3.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <string>

namespace zeroset::ui {
namespace {

constexpr int min_d_stop = 4;
constexpr double max_w = 2.0;
constexpr double min_half = 1e-4;
constexpr double max_half = 1e6;
/// Of the column at the right of a slider, in em.
constexpr float value_width = 4.0F;

void draw_tooltip(const char* text) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(22.0F));
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// A quiet label; the control that follows fills the rest of the line.
void draw_label(const char* label, const char* explanation) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    draw_tooltip(explanation);
    ImGui::SameLine(em(4.6F));
    ImGui::SetNextItemWidth(-FLT_MIN);
}

/// Leaves room for draw_value on the line of the slider that follows. Its format begins with "##":
/// ImGui does not draw what comes after, so that the grab covers no number.
void begin_slider() { ImGui::SetNextItemWidth(-em(value_width)); }

/// The value of the slider before, at the right end of its line.
void draw_value(const char* text) {
    const float width = ImGui::CalcTextSize(text).x;
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    ImGui::TextUnformatted(text);
}

void draw_d_stop(StopCriterion& stop) {
    draw_label("d_stop",
               "Search depth: a ray's search ends at cells of the box's edge times "
               "2^-d_stop. More is finer and slower.");
    int depth = static_cast<int>(std::lround(stop.value));
    begin_slider();
    if (ImGui::SliderInt("##d_stop", &depth, min_d_stop, max_d_stop, "##%d",
                         ImGuiSliderFlags_AlwaysClamp)) {
        stop = {StopRule::DStop, static_cast<double>(depth)};
    }
    // Another rule can come from the command line; it stays until the slider is moved.
    draw_value(stop.rule == StopRule::Epsilon ? "epsilon"
               : stop.rule == StopRule::Delta ? "delta"
                                              : std::to_string(depth).c_str());
}

void draw_w(double& w) {
    draw_label("w",
               "The fourth coordinate: the picture is the slice of f(x, y, z, w) = 0 at this w. "
               "Ctrl+click to type a value.");
    constexpr double lo = -max_w;
    constexpr double hi = max_w;
    begin_slider();
    ImGui::SliderScalar("##w", ImGuiDataType_Double, &w, &lo, &hi, "##%.3f");
    std::array<char, 32> value{};
    std::snprintf(value.data(), value.size(), "%.3f", w);
    draw_value(value.data());
}

void draw_box(Box& clip) {
    draw_label("box \xC2\xB1", "Half the longest edge of the box that the surface is clipped to.");
    double half = 0.5 * clip.size();
    if (ImGui::InputDouble("##box", &half, 0.0, 0.0, "%.6g") && half >= min_half &&
        half <= max_half) {
        clip = resized(clip, half);
    }
}

void draw_buttons(UiState& state) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x);
    const bool abreast = half >= ImGui::CalcTextSize("Light theme").x + style.FramePadding.x;
    const ImVec2 size(abreast ? half : -FLT_MIN, 0.0F);
    if (ImGui::Button("Reset view", size)) state.reset_view = true;
    draw_tooltip("Look at the whole box again (R).");
    if (abreast) ImGui::SameLine();
    const bool dark = state.theme == Theme::Dark;
    if (ImGui::Button(dark ? "Light theme###theme" : "Dark theme###theme", size)) {
        state.theme = dark ? Theme::Light : Theme::Dark;
    }
}

}  // namespace

Box resized(const Box& box, double half) {
    const double factor = 2.0 * half / box.size();
    const glm::dvec3 centre = box.centre();
    return {centre + factor * (box.lo - centre), centre + factor * (box.hi - centre)};
}

void draw_view_panel(UiState& state) {
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoFocusOnAppearing;
    const float margin = em(1.0F);
    // Off the middle of the picture even in a small window.
    const float width =
        std::clamp(0.5F * ImGui::GetIO().DisplaySize.x - em(3.5F), em(13.0F), em(18.0F));
    ImGui::SetNextWindowPos(ImVec2(margin, equation_bar_height() + margin));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0F), ImVec2(width, 1e6F));
    if (ImGui::Begin("##view", nullptr, flags)) {
        draw_d_stop(state.stop);
        if (state.uses_w) draw_w(state.w);
        draw_box(state.clip);
        draw_buttons(state);
    }
    ImGui::End();
}

}  // namespace zeroset::ui
