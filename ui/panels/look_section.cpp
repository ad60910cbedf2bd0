#include "document/look.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/scene/coloring.hpp"
#include "ui/panels/sections.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/picture/draw_shapes.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <array>
#include <cfloat>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr const char* about_expression = marked(
    "A formula of x, y, z, w and the sliders' letters, such as x^2 + y^2; F1 lists the "
    "functions.");

void draw_color_by(ColorChoice& coloring) {
    draw_label(tr("color"), tr("What the colors of the surfaces tell."));
    if (!ImGui::BeginCombo("##color_by", shown_name(coloring.by), ImGuiComboFlags_HeightLarge)) {
        return;
    }
    for (const ColorBy by : color_modes()) {
        if (!ImGui::Selectable(shown_name(by), by == coloring.by) || by == coloring.by) continue;
        // Settings of the old quantity mean nothing for the new one.
        coloring = {.by = by, .expression = coloring.expression, .lines = coloring.lines};
    }
    ImGui::EndCombo();
}

void draw_expression(const char* id, std::string& expression, const std::string& error,
                     const Palette& colors) {
    draw_label(tr("formula"), tr(about_expression));
    ImGui::PushFont(font(FontRole::Formula));
    ImGui::InputTextWithHint(id, "x^2 + y^2", &expression);
    ImGui::PopFont();
    if (error.empty()) return;
    draw_label("", "");
    ImGui::PushStyleColor(ImGuiCol_Text, colors.error);
    const float space = ImGui::GetContentRegionAvail().x;
    if (draw_elided(error, space)) draw_tooltip(error);
    ImGui::PopStyleColor();
}

void draw_map(ColorChoice& coloring) {
    draw_label(tr("map"),
               tr("Colors in even steps, told apart by lightness, too. Balance is for numbers "
                  "with a sign, cycle for angles."));
    const ColorMap usual = usual_map(coloring.by);
    if (const auto map = draw_map_combo("##color_map", coloring.map.value_or(usual)))
        coloring.map = *map == usual ? std::nullopt : map;
}

/// Draws a field for one end of the range; true when another finite number was typed.
bool draw_end(const char* id, double& end, float width) {
    ImGui::SetNextItemWidth(width);
    return draw_number_field(id, end, -largest_number, largest_number);
}

void draw_range(ColorChoice& coloring, const std::optional<Legend>& legend) {
    draw_label(tr("range"),
               tr("The numbers at the ends of the colors. By itself the range holds most of "
                  "what the picture shows."));
    bool by_itself = !coloring.range;
    const ValueRange found = legend && legend->range ? *legend->range : ValueRange();
    ValueRange range = coloring.range.value_or(found);
    if (ImGui::Checkbox(labelled(tr("auto"), "##range").c_str(), &by_itself)) {
        coloring.range = by_itself ? std::nullopt : std::optional(range);
    }
    ImGui::SameLine();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    const bool lo = draw_end("##range_lo", range.lo, width);
    ImGui::SameLine(0.0F, gap);
    const bool hi = draw_end("##range_hi", range.hi, -FLT_MIN);
    if ((lo || hi) && range.lo < range.hi) coloring.range = range;
}

const char* shown_name(Contours contours) {
    switch (contours) {
        case Contours::None: return tr_in("contours", "None");
        case Contours::Height: return tr("Height");
        case Contours::Coordinates: return tr("Grid of x, y, z");
        case Contours::Expression: return tr("An expression");
    }
    return "";
}

/// Draws the field of the step between contour lines; empty: chosen by itself.
/// `found`: the one that was.
void draw_step(LineChoice& lines, const std::optional<double>& found) {
    double step = lines.step.value_or(0.0);
    const std::string by_itself =
        found ? filled(tr("step {0} (auto)"), {localized(short_number(*found))}) : tr("step auto");
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (draw_number_field("##step", step, 0.0, largest_number, by_itself.c_str()))
        lines.step = step > 0.0 ? std::optional(step) : std::nullopt;
    draw_tooltip(tr("The step from line to line; empty or 0: chosen by itself."));
}

void draw_lines(LineChoice& lines, const Shown& shown, const Palette& colors) {
    const std::string& error = shown.reading.contour_error;
    draw_label(tr("lines"), tr("Contour lines: where a number is a whole multiple of a step."));
    const bool has_lines = lines.contours != Contours::None;
    if (has_lines) ImGui::SetNextItemWidth(0.55F * ImGui::GetContentRegionAvail().x);
    if (ImGui::BeginCombo("##contours", shown_name(lines.contours))) {
        for (const Contours contours :
             {Contours::None, Contours::Height, Contours::Coordinates, Contours::Expression}) {
            if (ImGui::Selectable(shown_name(contours), contours == lines.contours))
                lines.contours = contours;
        }
        ImGui::EndCombo();
    }
    if (has_lines) {
        ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
        draw_step(lines, shown.picture.contour_step);
        ImGui::Checkbox(labelled(tr("Numbers"), "###labels").c_str(), &lines.labels);
        draw_tooltip(tr("Numbers along the contour lines."));
    }
    if (lines.contours == Contours::Expression)
        draw_expression("##contour_expression", lines.expression, error, colors);
}

}  // namespace

float look_section_height(const Document& document, const ReadingFacts& reading) {
    const ColorChoice& coloring = document.coloring;
    float rows = coloring.lines.contours == Contours::None ? 2.0F : 3.0F;
    if (coloring.lines.contours == Contours::Expression)
        rows += reading.contour_error.empty() ? 1.0F : 2.0F;
    if (coloring.by == ColorBy::Expression) rows += reading.color_error.empty() ? 1.0F : 2.0F;
    if (has_range(coloring.by)) rows += 2.0F;
    return rows * ImGui::GetFrameHeightWithSpacing();
}

void draw_look_section(Edited& edited, const Shown& shown) {
    ColorChoice& coloring = edited.document.coloring;
    draw_color_by(coloring);
    if (coloring.by == ColorBy::Expression) {
        draw_expression("##color_expression", coloring.expression, shown.reading.color_error,
                        palette(edited.theme));
    }
    if (has_range(coloring.by)) {
        draw_map(coloring);
        draw_range(coloring, shown.picture.legend);
    }
    draw_lines(coloring.lines, shown, palette(edited.theme));
}

}  // namespace zeroset::ui
