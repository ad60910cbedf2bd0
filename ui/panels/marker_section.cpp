#include "ui/panels/marker_section.hpp"

#include "document/look.hpp"
#include "ui/picture/picture_marks.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/clipboard.hpp"

#include <glm/glm.hpp>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr float row_em = 1.9F;
constexpr float most_rows = 6.0F;

/// Text of a row: the coordinates and, if another marker is selected, the distance from it.
std::string row_text(const Marker& marker, const Marker* selected, const ShownPicture& picture) {
    const double resolution = marker_resolution(marker, picture);
    std::string text = coordinates_text(marker.at, resolution);
    if (selected == nullptr || selected == &marker) return text;
    const double distance = glm::distance(marker.at, selected->at);
    return text + "   " + number_text(distance, resolution) + " from " +
           std::to_string(selected->number);
}

void draw_number(const Marker& marker, bool selected, const ImVec2& lo, float height,
                 const Palette& colors) {
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const std::string number = std::to_string(marker.number);
    const ImVec2 size = ImGui::CalcTextSize(number.c_str());
    const ImVec2 centre(lo.x + em(1.0F), lo.y + 0.5F * height);
    canvas.AddCircleFilled(centre, em(0.75F), selected ? colors.accent : colors.field_active, 24);
    canvas.AddText(ImVec2(centre.x - 0.5F * size.x, centre.y - 0.5F * size.y),
                   selected ? colors.bar : colors.text, number.c_str());
}

/// Draws a line of the list; false when the user removes the marker.
bool draw_row(Edited& edited, const Marker& marker, const Marker* selected,
              const ShownPicture& picture) {
    const Palette& colors = palette(edited.theme);
    const bool is_selected = selected == &marker;
    const float height = std::ceil(em(row_em));
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable("##select", is_selected, ImGuiSelectableFlags_AllowItemOverlap,
                          ImVec2(width - 2.0F * height, height))) {
        edited.selected_marker = is_selected ? 0 : marker.number;
    }
    const std::string text = row_text(marker, selected, picture);
    ImFont* const small = font(FontRole::SmallFormula);
    ImGui::PushFont(small);
    const float room = width - 2.0F * height - em(2.2F);
    const bool cut = ImGui::CalcTextSize(text.c_str()).x > room;
    draw_tooltip((cut ? text + "\n" : std::string()) +
                 "Select: Ctrl+C copies it, Delete removes it; the others show how far they are.");
    const ImVec4 clip(lo.x, lo.y, lo.x + em(2.2F) + room, lo.y + height);
    ImGui::GetWindowDrawList()->AddText(
        small, ImGui::GetFontSize(),
        ImVec2(lo.x + em(2.2F), lo.y + 0.5F * (height - ImGui::GetTextLineHeight())), colors.text,
        text.c_str(), nullptr, 0.0F, &clip);
    ImGui::PopFont();
    draw_number(marker, is_selected, lo, height, colors);
    const IconLook look{.size = height, .color = colors.quiet};
    ImGui::SameLine(left + width - 2.0F * height, 0.0F);
    if (icon_button("##copy", Icon::Copy, look, "Copy the coordinates")) {
        set_clipboard(coordinates_text(marker.at));
    }
    ImGui::SameLine(left + width - height, 0.0F);
    return !icon_button("##remove", Icon::Cross, look, "Remove the marker");
}

}  // namespace

float marker_section_height(const Document& document) {
    const auto rows = static_cast<float>(document.markers.size());
    if (rows == 0.0F) return 2.0F * ImGui::GetTextLineHeightWithSpacing();
    const float one = std::ceil(em(row_em)) + em(0.15F);
    return std::clamp(rows, 1.0F, most_rows) * one + ImGui::GetStyle().ItemSpacing.y;
}

void draw_marker_section(Edited& edited, const ShownPicture& picture) {
    const std::vector<Marker>& markers = edited.document.markers;
    if (markers.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette(edited.theme).quiet);
        ImGui::TextWrapped("Click on a surface (or M) to keep a point.");
        ImGui::PopStyleColor();
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, em(0.15F)));
    int removed = 0;
    const Marker* const selected = find_marker(markers, edited.selected_marker);
    for (const Marker& marker : markers) {
        ImGui::PushID(marker.number);
        if (!draw_row(edited, marker, selected, picture)) removed = marker.number;
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    if (removed != 0) remove_marker(edited.document.markers, removed);
}

}  // namespace zeroset::ui
