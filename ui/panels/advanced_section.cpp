#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/image/frame_pictures.hpp"
#include "ui/panels/sections.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::ui {
namespace {

/// Draws a line of the list of tracers; true when it is picked.
bool draw_tracer(const TracerChoice& tracer, std::string_view chosen) {
    const bool picked = ImGui::Selectable(tracer.name.c_str(), tracer.name == chosen);
    draw_tooltip(tr(tracer.about.c_str()));
    return picked;
}

void draw_tracers(UiState& state) {
    draw_label(tr("tracer"), tr("How the first root on each ray is found. The others are published "
                                "methods, to compare with."));
    std::string& chosen = state.edited.inspection.tracer;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (!ImGui::BeginCombo("##tracer", chosen.c_str(), ImGuiComboFlags_HeightLarge)) return;
    for (const TracerChoice& tracer : state.shown.tracers) {
        if (draw_tracer(tracer, chosen)) chosen = tracer.name;
    }
    ImGui::EndCombo();
}

void draw_others(UiState& state) {
    draw_label(tr("beside"),
               tr("The same view by another tracer, with a divider to drag. Both draw without "
                  "shadows and smooth edges, so that their times are their own."));
    std::optional<std::string>& other = state.edited.inspection.other;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const char* const shown = other ? other->c_str() : tr_in("the tracer beside the first", "none");
    if (!ImGui::BeginCombo("##other", shown, ImGuiComboFlags_HeightLarge)) return;
    if (ImGui::Selectable(tr_in("the tracer beside the first", "none"), !other)) other.reset();
    for (const TracerChoice& tracer : state.shown.tracers) {
        if (draw_tracer(tracer, other ? std::string_view(*other) : std::string_view()))
            other = tracer.name;
    }
    ImGui::EndCombo();
}

std::string drawn_by(const std::string& tracer, double frame_ms, const Framebuffer& frame) {
    const std::string time = frame_time(frame_ms);
    if (frame.cost.empty()) return filled(tr("{0}: {1}"), {tracer, time});
    return filled(tr("{0}: {1}, {2} evaluations a pixel"),
                  {tracer, time, localized(short_number(mean_cost(frame), 3))});
}

/// The lines of text on the pictures.
std::vector<std::string> lines_of(const UiState& state) {
    const Inspection& wanted = state.edited.inspection;
    std::vector<std::string> lines;
    const auto& choices = state.shown.tracers;
    for (const TracerChoice& tracer : choices) {
        const bool draws = tracer.name == wanted.tracer;
        if (draws && !tracer.finds_jumps && state.edited.document.jumps)
            lines.emplace_back(tr("jumps are found by the tracer beams only"));
    }
    const Shown& shown = state.shown;
    if (shown.picture.frame == nullptr || shown.figures.hidden) return lines;
    if ((wanted.other || wanted.costs) && !shown.picture.tracing)
        lines.push_back(drawn_by(wanted.tracer, shown.figures.frame_ms, *shown.picture.frame));
    const OtherPicture& other = shown.other;
    if (!wanted.other || other.frame == nullptr || !other.complete) return lines;
    lines.push_back(drawn_by(other.tracer, other.frame_ms, *other.frame));
    if (!other.wrong) return lines;
    if (other.reference == Reference::None) {
        lines.emplace_back(tr("neither of the two proves anything"));
        return lines;
    }
    const std::string& judged = other.reference == Reference::First ? other.tracer : wanted.tracer;
    lines.push_back(filled(tr("{0}: {1} missed (red), {2} added (violet), {3} moved (amber)"),
                           {judged, grouped(other.wrong->missed), grouped(other.wrong->added),
                            grouped(other.wrong->moved)}));
    return lines;
}

void draw_switches(UiState& state) {
    if (state.edited.inspection.other) {
        draw_action_switch(state, tr("Difference"), "Difference of two tracers");
        ImGui::SameLine(0.0F, em(1.0F));
    }
    const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    const std::string label =
        elided(tr("Cost of each pixel"), ImGui::GetContentRegionAvail().x - box);
    draw_action_switch(state, label.c_str(), "Cost of each pixel");
}

/// Height of the lines as they wrap.
float lines_height(const std::vector<std::string>& lines, float width) {
    float height = 0.0F;
    for (const std::string& line : lines)
        height += ImGui::CalcTextSize(line.c_str(), nullptr, false, width).y +
                  ImGui::GetStyle().ItemSpacing.y;
    return height;
}

}  // namespace

float advanced_section_height(const UiState& state) {
    return 3.0F * ImGui::GetFrameHeightWithSpacing() +
           lines_height(lines_of(state), ImGui::GetContentRegionAvail().x);
}

void draw_advanced_section(UiState& state) {
    draw_tracers(state);
    draw_others(state);
    draw_switches(state);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    for (const std::string& line : lines_of(state))
        ImGui::TextWrapped("%s", line.c_str());
    ImGui::PopStyleColor();
}

}  // namespace zeroset::ui
