#include "document/look.hpp"
#include "engine/base/translation.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sections.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/bar.hpp"
#include "ui/widgets/color_picker.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr const char* separator = "  \xC2\xB7  ";
constexpr const char* keys_hint = marked(
    "drag: orbit  \xC2\xB7  right or Shift+drag: pan  \xC2\xB7  wheel: zoom  \xC2\xB7  R: reset "
    " \xC2\xB7  F1: help  \xC2\xB7  Ctrl+Q: quit");

/// Adds text to the line, unless that is too narrow for it.
void add_text(std::uint32_t color, const std::string& text, const char* between = separator) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const bool first = ImGui::GetCursorPosX() <= style.WindowPadding.x;
    const float space = ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX();
    const std::string before = first ? "" : between;
    if (ImGui::CalcTextSize((before + text).c_str()).x > space && !first) return;
    ImGui::TextDisabled("%s", before.c_str());
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine(0.0F, 0.0F);
}

/// The section of details tells more.
void draw_figures(const PictureFigures& figures, const Palette& colors) {
    if (figures.width_px <= 0) return;
    add_text(colors.quiet, frame_time(figures.frame_ms));
    add_text(colors.quiet,
             std::to_string(figures.width_px) + " \xC3\x97 " + std::to_string(figures.height_px));
    if (many_undecided(figures)) add_text(colors.warning, undecided_text(figures));
}

/// Adds the surface's colour and, if there are several, the number of its row.
void add_surface(const std::vector<Statement>& rows, int id, const Palette& colors) {
    const auto row = std::ranges::find(rows, id, &Statement::id);
    if (row == rows.end()) return;
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    draw_color_dot(*ImGui::GetWindowDrawList(), ImVec2(lo.x + 0.4F * size, lo.y + 0.5F * size),
                   0.33F * size, *row, colors, false);
    ImGui::Dummy(ImVec2(1.1F * size, size));
    ImGui::SameLine(0.0F, 0.0F);
    if (rows.size() < 2) return;
    ImGui::PushStyleColor(ImGuiCol_Text, colors.quiet);
    ImGui::Text("%s  ", filled(tr("row {0}"), {std::to_string(row - rows.begin() + 1)}).c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine(0.0F, 0.0F);
}

/// Formats a number with `format`, -0 as 0; for example "f = 1.2e-16".
std::string small_number(const char* format, double number) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, number == 0.0 ? 0.0 : number);
    return text.data();
}

/// Draws the facts of the point under the pointer, with as many digits as distinguish neighbouring
/// pixels and are certain.
void draw_pointed(const PointedFacts& pointed, const std::vector<Statement>& rows,
                  const Palette& colors) {
    const PointFacts& facts = pointed.facts;
    const double resolution = std::max(0.1 * pointed.pixel_size, facts.within);
    add_surface(rows, pointed.row, colors);
    const bool certified = is_proved(facts.certificate);
    const bool coarse = facts.certificate == Certificate::Coarse;
    add_text(colors.text, coordinates_text(facts.point, resolution), "");
    const bool jump = facts.certificate == Certificate::Jump;
    add_text(certified ? colors.quiet : colors.warning, coarse      ? tr("certified, coarse")
                                                        : certified ? tr("certified")
                                                        : jump      ? tr("jump in sign, no root")
                                                                    : tr("undecided"));
    if (facts.normal != glm::dvec3(0.0))
        add_text(colors.quiet, filled(tr("normal {0}"), {coordinates_text(facts.normal, 1e-3)}));
    add_text(colors.quiet,
             filled(tr("{0} from the eye"), {localized(number_text(facts.distance, resolution))}));
    add_text(colors.quiet, small_number("f = %.2g", facts.f));
}

/// Draws facts of the point under the pointer or, without one, of the picture.
void draw_known(const Shown& shown, const std::vector<Statement>& rows, const Palette& colors) {
    if (shown.pointed) {
        draw_pointed(*shown.pointed, rows, colors);
    } else if (!shown.figures.hidden) {
        draw_figures(shown.figures, colors);
    }
    if (shown.picture.tracing && shown.status.doing.empty()) {
        add_text(colors.accent, tr("tracing\xE2\x80\xA6"));
    }
}

/// The text at the line's right end, apart from the facts: what is going on, or not as it should
/// be; else the keys.
struct RightText {
    std::string text;
    std::uint32_t color;
    bool matters = true;
};

RightText right_text(const StatusTexts& status, const Palette& colors) {
    if (!status.doing.empty()) return {.text = status.doing, .color = colors.accent};
    if (!status.note.empty()) return {.text = status.note, .color = colors.warning};
    return {.text = tr(keys_hint), .color = colors.quiet, .matters = false};
}

/// Draws the text where there is room beside what stands at the left, which ends at `left`.
void draw_right(const RightText& right, float left) {
    const float padding = ImGui::GetStyle().WindowPadding.x;
    const float space = ImGui::GetWindowWidth() - padding - left;
    const float width = ImGui::CalcTextSize(right.text.c_str()).x;
    if (width > space && !right.matters) return;
    ImGui::SetCursorPosX(std::max(ImGui::GetWindowWidth() - padding - width, left));
    ImGui::PushStyleColor(ImGuiCol_Text, right.color);
    draw_elided(right.text, space);
    ImGui::PopStyleColor();
}

}  // namespace

void draw_status_panel(const Edited& edited, const Shown& shown) {
    const Palette& colors = palette(edited.theme);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float height = status_bar_height();
    ImGui::SetNextWindowPos(ImVec2(0.0F, window.y - height));
    ImGui::SetNextWindowSize(ImVec2(window.x, height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    if (begin_bar("##status", colors, ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav)) {
        ImGui::PushFont(font(FontRole::Small));
        ImGui::SetCursorPosY(0.5F * (height - ImGui::GetTextLineHeight()));
        const RightText right = right_text(shown.status, colors);
        // Figures of a dimmed picture do not describe the text in the rows.
        const bool known = shown.picture.dimmed == 0.0F;
        if (known) draw_known(shown, edited.document.statements, colors);
        draw_right(right, ImGui::GetCursorPosX() + (known ? em(2.0F) : 0.0F));
        ImGui::PopFont();
    }
    end_bar(Edge::Top, colors);
    ImGui::PopStyleVar();
}

}  // namespace zeroset::ui
