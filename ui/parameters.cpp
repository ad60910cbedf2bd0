#include "ui/parameters.hpp"

#include "ui/slider_row.hpp"
#include "ui/ui_state.hpp"

#include <imgui/imgui.h>

#include <cstddef>
#include <string>

namespace zeroset::ui {
namespace {

constexpr const char* how =
    "Double-click or Ctrl+click: type any number. Right click: back to the usual value and range.";

void draw_w(UiState& state) {
    draw_label("w", std::string("The fourth coordinate: the picture is the slice of f(x, y, z, w) "
                                "= 0 at this w.\n") +
                        how);
    const UiState usual;
    Slider slider{state.w, state.w_lo, state.w_hi};
    draw_slider("##w", slider, {usual.w, usual.w_lo, usual.w_hi});
    state.w = slider.value;
    state.w_lo = slider.lo;
    state.w_hi = slider.hi;
}

void draw_parameter(ParameterSlider& parameter) {
    draw_label(parameter.name, how);
    const ParameterSlider usual;
    Slider slider{parameter.value, parameter.lo, parameter.hi};
    draw_slider("##value", slider, {usual.value, usual.lo, usual.hi});
    parameter.value = slider.value;
    parameter.lo = slider.lo;
    parameter.hi = slider.hi;
}

}  // namespace

void draw_parameters(UiState& state, float room) {
    const std::size_t count = state.parameters.size() + (state.uses_w ? 1 : 0);
    if (count == 0) return;
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float row = ImGui::GetFrameHeightWithSpacing();
    const float all = static_cast<float>(count) * row - spacing;
    const float left = room - 2.0F * spacing;
    const bool scrolls = left < all && left >= 2.0F * row - spacing;
    ImGui::BeginChild("##parameters", ImVec2(0.0F, scrolls ? left : all), false);
    if (state.uses_w) draw_w(state);
    for (std::size_t i = 0; i < state.parameters.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        draw_parameter(state.parameters[i]);
        ImGui::PopID();
    }
    ImGui::EndChild();
    ImGui::Separator();
}

}  // namespace zeroset::ui
