#include "document/look.hpp"
#include "engine/base/translation.hpp"
#include "ui/actions/action_functions.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/typed_point.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/sections.hpp"
#include "ui/picture/picture_marks.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/clipboard.hpp"

#include <glm/glm.hpp>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr float row_em = 1.9F;
constexpr float most_rows = 6.0F;

/// Text of a row: the coordinates and, if another marker is selected, the distance from it.
std::string row_text(const Marker& marker, const Marker* selected, const ShownPicture& picture) {
    const double resolution = marker_resolution(marker, picture);
    std::string text = coordinates_text(marker.at, resolution);
    if (!marker.label.empty()) text.insert(0, marker.label + "  ");
    if (selected == nullptr || selected == &marker) return text;
    const double distance = glm::distance(marker.at, selected->at);
    return text + "   " +
           filled(tr("{0} from {1}"),
                  {localized(number_text(distance, resolution)), name_of(*selected)});
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
    const float space = width - 2.0F * height - em(2.2F);
    const std::string shown = elided(text, space);
    const bool cut = shown != text;
    draw_tooltip((cut ? text + "\n" : std::string()) +
                 tr("Select: Ctrl+C copies it, Delete removes it; the others show how far they "
                    "are."));
    ImGui::GetWindowDrawList()->AddText(
        small, ImGui::GetFontSize(),
        ImVec2(lo.x + em(2.2F), lo.y + 0.5F * (height - ImGui::GetTextLineHeight())), colors.text,
        shown.c_str());
    ImGui::PopFont();
    draw_number(marker, is_selected, lo, height, colors);
    const IconLook look{.size = height, .color = colors.quiet};
    ImGui::SameLine(left + width - 2.0F * height, 0.0F);
    if (icon_button("##copy", Icon::Copy, look, tr("Copy the coordinates"))) {
        set_clipboard(coordinates_text(marker.at));
    }
    ImGui::SameLine(left + width - height, 0.0F);
    return !icon_button("##remove", Icon::Cross, look, tr("Remove the marker"));
}

float row_gap() { return em(0.15F); }

/// Draws the field into which a point is typed; Enter goes there.
void draw_point_field(UiState& state) {
    PointField& field = state.pages.point;
    const bool in_sight = !ImGui::GetCurrentWindow()->SkipItems &&
                          ImGui::IsRectVisible(ImVec2(1.0F, ImGui::GetFrameHeight()));
    if (in_sight && std::exchange(state.wishes.point_field, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool entered = ImGui::InputTextWithHint("##point", tr("go to x, y, z"), &field.typed,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemEdited()) field.wrong = false;
    draw_tooltip(
        tr("Type a point, such as 1, 2, 3, and press Enter: it is looked at, and marked."));
    if (entered) {
        const auto point = point_typed(field.typed);
        field.wrong = !point.has_value();
        if (point) {
            go_to(state, *point);
            field.typed.clear();
        }
    }
    if (!field.wrong) return;
    ImGui::PushStyleColor(ImGuiCol_Text, palette(state.edited.theme).error);
    ImGui::TextUnformatted(tr("type three numbers, such as 1, 2, 3"));
    ImGui::PopStyleColor();
}

/// Draws the selected marker's label and the button that snaps it.
void draw_selected(UiState& state) {
    std::vector<Marker>& markers = state.edited.document.markers;
    const auto marker = std::ranges::find(markers, state.edited.selected_marker, &Marker::number);
    if (marker == markers.end()) {
        // The line is always there, so that the rows stay where they are clicked.
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", tr("Select one to label or snap it."));
        return;
    }
    const Action& snap = action_named("Snap the marker");
    const float button =
        ImGui::CalcTextSize(tr("Snap")).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - em(0.4F));
    std::string label = marker->label;
    const std::string hint = filled(tr("label of {0}"), {std::to_string(marker->number)});
    ImGui::PushID(marker->number);
    if (ImGui::InputTextWithHint("##label", hint.c_str(), &label) && label.size() <= longest_label)
        marker->label = label;
    draw_tooltip(tr("Shown in the picture in place of the number."));
    ImGui::PopID();
    ImGui::SameLine(0.0F, em(0.4F));
    if (ImGui::Button(labelled(tr("Snap"), "##snap").c_str(), ImVec2(button, 0.0F)))
        snap.run(state);
    draw_tooltip(described(snap) + "\n" + tr(snap.about));
}

/// Draws the list; or what to do where it is empty.
void draw_list(Edited& edited, const ShownPicture& picture) {
    const std::vector<Marker>& markers = edited.document.markers;
    if (markers.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette(edited.theme).quiet);
        ImGui::TextWrapped("%s", tr("Click on a surface (or M) to keep a point."));
        ImGui::PopStyleColor();
        return;
    }
    int removed = 0;
    const Marker* const selected = find_marker(markers, edited.selected_marker);
    for (const Marker& marker : markers) {
        ImGui::PushID(marker.number);
        if (!draw_row(edited, marker, selected, picture)) removed = marker.number;
        ImGui::PopID();
    }
    if (removed != 0) remove_marker(edited.document.markers, removed);
}

/// Height of the list as far as it is shown without scrolling.
float marker_list_height(const Document& document) {
    const auto rows = static_cast<float>(document.markers.size());
    if (rows == 0.0F) return 2.0F * ImGui::GetTextLineHeightWithSpacing();
    return std::clamp(rows, 1.0F, most_rows) * (std::ceil(em(row_em)) + row_gap()) + em(0.3F);
}

}  // namespace

float marker_section_height(const UiState& state) {
    const Document& document = state.edited.document;
    const float field = ImGui::GetFrameHeightWithSpacing();
    const float wrong = state.pages.point.wrong ? ImGui::GetTextLineHeightWithSpacing() : 0.0F;
    return field + wrong + marker_list_height(document) + ImGui::GetStyle().ItemSpacing.y +
           (document.markers.empty() ? 0.0F : field);
}

void draw_marker_section(UiState& state) {
    draw_point_field(state);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, row_gap()));
    draw_list(state.edited, state.shown.picture);
    ImGui::PopStyleVar();
    if (!state.edited.document.markers.empty()) draw_selected(state);
}

}  // namespace zeroset::ui
