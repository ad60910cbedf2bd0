#include "engine/base/translation.hpp"
#include "engine/scene/region.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <optional>
#include <string>

namespace zeroset::ui {
namespace {

/// A range as those who look at scans say it.
struct Window {
    double level, width;  ///< its middle, and how wide it is

    explicit Window(const ValueRange& range)
        : level(0.5 * (range.lo + range.hi)), width(range.hi - range.lo) {}
    [[nodiscard]] ValueRange range() const {
        return {.lo = level - 0.5 * width, .hi = level + 0.5 * width};
    }
};

/// Draws a slider that begins as `usual`; true when it was moved.
bool draw_part(const char* label, const char* about, double& value, const Slider& usual) {
    draw_label(label, about);
    Slider slider = usual;
    set_value(slider, value);
    draw_slider((std::string("##") + label).c_str(), slider, usual, 0.0F);
    const bool moved = slider.value != value;
    value = slider.value;
    return moved;
}

void draw_map(SectionChoice& choice) {
    const std::string by_itself = labelled(tr("auto"), "##section_range");
    const float right = ImGui::CalcTextSize(by_itself.c_str(), nullptr, true).x +
                        ImGui::GetFrameHeight() + em(1.2F);
    draw_label(tr("values"), tr("The colors of the values that sections show."));
    const ColorMap shown = choice.map.value_or(ColorMap::Gray);
    if (const auto map = draw_map_combo("##section_map", shown, right))
        choice.map = *map == ColorMap::Gray ? std::nullopt : map;
    ImGui::SameLine();
    bool is_open = !choice.range;
    if (ImGui::Checkbox(by_itself.c_str(), &is_open) && is_open) choice.range.reset();
    draw_tooltip(tr("Level and window hold most of the values in the box."));
}

}  // namespace

void draw_section_values(Document& document, const ShownPicture& picture) {
    if (section_values_rows(document) == 0.0F) return;
    SectionChoice& choice = document.section_values;
    draw_map(choice);
    const ValueRange usual_range = picture.usual_section_range.value_or(ValueRange());
    const Window usual(usual_range);
    Window window(choice.range.value_or(usual_range));
    const bool level =
        draw_part(tr_in("section", "level"), tr("The value in the middle of the colors."),
                  window.level, {.value = usual.level, .lo = usual_range.lo, .hi = usual_range.hi});
    const bool width = draw_part(
        tr_in("section", "window"), tr("The values from one end of the colors to the other."),
        window.width, {.value = usual.width, .lo = 0.0, .hi = 2.0 * usual.width});
    if (!level && !width) return;
    window.width = std::max(window.width, 1e-3 * usual.width);
    const ValueRange range = window.range();
    if (range.lo < range.hi) choice.range = range;
}

float section_values_rows(const Document& document) {
    return std::ranges::any_of(document.region.sections, &Section::values) ? 3.0F : 0.0F;
}

}  // namespace zeroset::ui
