#include "ui/widgets/slider_row.hpp"

#include "document/document.hpp"
#include "document/play.hpp"
#include "engine/base/translation.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace zeroset::ui {
namespace {

/// Width of the column at the right (value) of a slider, in em.
constexpr float value_width = 4.3F;

/// Reserves room for draw_value at the right of the next slider. That slider's format must begin
/// with "##": ImGui does not draw what comes after it, so that the grab covers no number.
void begin_slider(float right) { ImGui::SetNextItemWidth(-em(value_width) - right); }

/// Draws the value of the last slider so that it ends `right` before the end of the line.
void draw_value(const char* text, float right) {
    const float width = ImGui::CalcTextSize(text).x;
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - right - width);
    ImGui::TextUnformatted(text);
}

/// Formats in the user's language with three decimals, as the slider does; very large or small
/// numbers as short as "1e9".
std::string slider_text(double value) {
    std::array<char, 32> text{};
    const bool fixed = value == 0.0 || (std::abs(value) < 1e4 && std::abs(value) >= 5e-4);
    std::snprintf(text.data(), text.size(), fixed ? "%.3f" : "%.2e", value);
    std::string number = text.data();
    if (const std::size_t e = number.find('e'); e != std::string::npos) {
        number = number.substr(0, e + 1) + std::to_string(std::stoi(number.substr(e + 1)));
    }
    return localized(number);
}

}  // namespace

void draw_label(const std::string& label, const std::string& explanation, float width_em) {
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool cut = draw_elided(label, em(width_em - 0.3F));
    ImGui::PopStyleColor();
    draw_tooltip(cut ? label + "\n" + explanation : explanation);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + em(width_em));
    ImGui::SetNextItemWidth(-FLT_MIN);
}

float slider_width(float right) {
    return ImGui::GetContentRegionAvail().x - em(value_width) - right;
}

bool draw_integer_slider(const char* id, int& value, int lo, int hi, const char* shown) {
    begin_slider(0.0F);
    const bool moved = slide(id, value, lo, hi, "##%d", ImGuiSliderFlags_AlwaysClamp);
    draw_value(shown != nullptr ? shown : std::to_string(value).c_str(), 0.0F);
    return moved;
}

void draw_slider(const char* id, Slider& slider, const Slider& usual, float right) {
    const double before = slider.value;
    begin_slider(right);
    const bool moved = slide(id, slider.value, slider.lo, slider.hi, "##%.3f");
    const ImGuiID item = ImGui::GetItemID();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) type_into(item);
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) slider = usual;
    if (!(std::abs(slider.value) <= largest_number)) slider.value = before;
    if (!ImGui::TempInputIsActive(item)) {
        const double by = slider.value - before;
        // A key moves by one step at least.
        if (moved && is_moved_by_keys(item) && std::abs(by) < slider.step)
            slider.value = before + std::copysign(slider.step, by);
        if (moved) slider.value = on_step(slider, slider.value);
        set_value(slider, slider.value);
    }
    draw_value(slider_text(slider.value).c_str(), right);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    if (ImGui::IsItemClicked()) type_into(item);
}

}  // namespace zeroset::ui
