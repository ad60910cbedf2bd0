#include "document/document.hpp"
#include "document/play.hpp"
#include "engine/base/translation.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/histogram_strip.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace zeroset::ui {
namespace {

constexpr const char* about_w = marked(
    "The fourth coordinate, w or t: the picture is the slice of f(x, y, z, w) = 0 at this w.");
constexpr const char* how = marked(
    "Double-click or Ctrl+click: type any number. Right click: back to the usual value and "
    "range.");

/// Draws a number field with its label; true when a finite number was typed.
bool draw_number(const char* label, const char* id, double& number) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(em(4.0F));
    ImGui::SetNextItemWidth(em(8.0F));
    return draw_number_field(id, number, -largest_number, largest_number);
}

void draw_ends(Slider& slider) {
    double lo = slider.lo;
    if (draw_number(tr("from"), "##lo", lo) && lo < slider.hi) {
        slider.lo = lo;
        slider.value = std::max(slider.value, lo);
    }
    double hi = slider.hi;
    if (draw_number(tr("to"), "##hi", hi) && hi > slider.lo) {
        slider.hi = hi;
        slider.value = std::min(slider.value, hi);
    }
    double step = slider.step;
    if (draw_number(tr("step"), "##step", step) && step >= 0.0) {
        slider.step = step;
        slider.value = on_step(slider, slider.value);
    }
    draw_tooltip(tr("0: any value between the ends"));
}

void draw_settings(const char* id, Slider& slider) {
    if (!ImGui::BeginPopup(id)) return;
    draw_ends(slider);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", tr("speed"));
    ImGui::SameLine(em(4.0F));
    ImGui::SetNextItemWidth(em(8.0F));
    slide("##speed", slider.speed, 0.125, 8.0, "%.2f\xC3\x97",
          ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    draw_tooltip(tr("1: from end to end in four seconds"));
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", tr("at the end"));
    if (ImGui::RadioButton(tr("turn back"), slider.repeat == Repeat::Bounce)) {
        slider.repeat = Repeat::Bounce;
    }
    ImGui::SameLine();
    if (ImGui::RadioButton(tr("start again"), slider.repeat == Repeat::Loop)) {
        slider.repeat = Repeat::Loop;
    }
    ImGui::Checkbox(tr("In presentations"), &slider.presented);
    draw_tooltip(tr("Show this slider in a presentation (F5) and with zeroset --present."));
    ImGui::EndPopup();
}

void draw_play_button(Edited& edited, const std::string& name, const Slider& slider, float size) {
    const Palette& colors = palette(edited.theme);
    const bool plays = edited.playing.contains(name);
    const IconLook look{.size = size, .color = plays ? colors.accent : colors.quiet};
    if (!icon_button("##play", plays ? Icon::Pause : Icon::Play, look,
                     plays ? tr("Stop") : tr("Play"))) {
        return;
    }
    if (plays) {
        edited.playing.erase(name);
    } else {
        edited.playing[name] = started(slider);
    }
}

/// `name` of the slider, and the one by which it is `called`.
void draw_name(const std::string& name, const std::string& called, const Palette& colors) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(font(FontRole::Formula));
    ImGui::PushStyleColor(ImGuiCol_Text, colors.text);
    const bool cut = draw_elided(called, em(1.9F));
    ImGui::PopStyleColor();
    ImGui::PopFont();
    const std::string first = name == w_name ? tr(about_w) : cut ? name : std::string();
    draw_tooltip(first + (first.empty() ? "" : "\n") + tr(how));
}

/// The slider after a right click: of an isovalue, the middle of the volume's values.
Slider usual_slider(const std::string& name, const ReadingFacts& reading) {
    Slider usual = first_slider(name);
    const auto found = reading.histograms.find(name);
    if (found == reading.histograms.end()) return usual;
    const Histogram& values = *found->second;
    usual.lo = values.first;
    usual.hi = values.first + values.width * static_cast<double>(values.counts.size());
    usual.value = 0.5 * (usual.lo + usual.hi);
    return usual;
}

/// Whether the row of a slider has a button for its settings behind it.
enum class RowParts : std::uint8_t { All, NoSettings };

void draw_row(Edited& edited, const ReadingFacts& reading, const std::string& name,
              RowParts parts) {
    const Palette& colors = palette(edited.theme);
    ImGui::PushID(name.c_str());
    Slider slider = slider_named(edited.document, name);
    const float size = ImGui::GetFrameHeight();
    const float left = ImGui::GetCursorPosX();
    draw_play_button(edited, name, slider, size);
    ImGui::SameLine(0.0F, em(0.3F));
    draw_name(name, name == w_name && reading.calls_w_t ? "t" : name, colors);
    ImGui::SameLine(left + size + em(2.5F));
    Slider usual = usual_slider(name, reading);
    usual.presented = slider.presented;
    const bool settings = parts == RowParts::All;
    if (const auto histogram = reading.histograms.find(name);
        histogram != reading.histograms.end()) {
        draw_histogram("##histogram", *histogram->second, slider,
                       slider_width(settings ? size : 0.0F), colors);
        ImGui::SetCursorPosX(left + size + em(2.5F));
    }
    draw_slider("##value", slider, usual, settings ? size : 0.0F);
    if (settings) {
        ImGui::SameLine(0.0F, 0.0F);
        ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - size);
        if (icon_button("##more", Icon::More, {.size = size, .color = colors.quiet},
                        tr("Range, step, speed and presentations")))
            ImGui::OpenPopup("##settings");
        draw_settings("##settings", slider);
    }
    if (slider != slider_named(edited.document, name)) {
        if (edited.playing.contains(name)) edited.playing[name] = started(slider);
        set_slider(edited.document, name, slider);
    }
    ImGui::PopID();
}

}  // namespace

void draw_parameter_rows(Edited& edited, const ReadingFacts& reading) {
    if (!reading.uses_w && reading.parameters.empty()) return;
    ImGui::Separator();
    if (reading.uses_w) draw_row(edited, reading, w_name, RowParts::All);
    for (const std::string& name : reading.parameters)
        draw_row(edited, reading, name, RowParts::All);
}

std::vector<std::string> presented_sliders(const Document& document, const ReadingFacts& reading) {
    std::vector<std::string> names;
    if (reading.uses_w) names.emplace_back(w_name);
    names.insert(names.end(), reading.parameters.begin(), reading.parameters.end());
    std::erase_if(names,
                  [&](const std::string& name) { return !slider_named(document, name).presented; });
    return names;
}

void draw_presented_rows(Edited& edited, const ReadingFacts& reading) {
    for (const std::string& name : presented_sliders(edited.document, reading))
        draw_row(edited, reading, name, RowParts::NoSettings);
}

}  // namespace zeroset::ui
