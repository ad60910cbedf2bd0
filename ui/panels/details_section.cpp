#include "engine/annotate/legend.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/view/camera.hpp"
#include "ui/panels/sections.hpp"
#include "ui/picture/draw_shapes.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr int min_d_stop = 4;
/// The part of a picture's pixels above which undecided ones matter.
constexpr double many = 0.005;

void draw_d_stop(StopCriterion& stop) {
    draw_label("d_stop", tr("Search depth: a ray's search ends at cells of the box's edge times "
                            "2^-d_stop. More is finer and slower."));
    int depth = static_cast<int>(std::lround(stop.value));
    // The command line can set another stop rule; it stays until the slider is moved.
    const char* rule = stop.rule == StopRule::Epsilon ? "epsilon"
                       : stop.rule == StopRule::Delta ? "delta"
                                                      : nullptr;
    if (draw_integer_slider("##d_stop", depth, min_d_stop, max_d_stop, rule)) {
        stop = {.rule = StopRule::DStop, .value = static_cast<double>(depth)};
    }
}

void draw_undecided(Document& document, Theme theme) {
    ImGui::Checkbox(labelled(tr("Mark undecided"), "###undecided").c_str(),
                    &document.mark_undecided);
    draw_tooltip(tr(
        "Undecided pixels (U): the ray may meet the surface where the search stopped, or passed a "
        "place where f jumps or ends. A larger d_stop decides more of them."));
    const float space = ImGui::GetContentRegionAvail().x - ImGui::GetItemRectSize().x - em(1.2F);
    const std::string jumps = labelled(tr("Jumps"), "###jumps");
    if (ImGui::CalcTextSize(jumps.c_str(), nullptr, true).x + ImGui::GetFrameHeight() + em(0.6F) <=
        space) {
        ImGui::SameLine(0.0F, em(1.2F));
        ImGui::Checkbox(jumps.c_str(), &document.jumps);
        draw_tooltip(
            tr("Draw also where f changes its sign in a jump, as floor and if make it, without "
               "a root."));
    }
    if (!document.mark_undecided) return;
    constexpr std::array marks{
        std::pair(PixelMark::UndecidedDrawn, marked("something is drawn there")),
        std::pair(PixelMark::UndecidedNotDrawn, marked("nothing is drawn there")),
        std::pair(PixelMark::Coarse, marked("certified in a coarse bracket"))};
    const CardStyle style = card_style(theme);
    const float size = ImGui::GetTextLineHeight();
    for (const auto& [mark, words] : marks) {
        ImGui::Dummy(ImVec2(em(1.6F), size));
        ImGui::SameLine(0.0F, 0.0F);
        draw_shapes(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(),
                    swatch_shapes({0.0, 0.0}, static_cast<double>(size), mark, style));
        ImGui::Dummy(ImVec2(size, size));
        ImGui::SameLine(0.0F, em(0.5F));
        ImGui::TextDisabled("%s", tr(words));
    }
}

/// Width of the view at the point looked at, and the precision: "view 3.2e-07 wide, double".
std::string view_scale(const PictureFigures& figures, const Camera& camera) {
    const ViewFrame view(camera);
    const double height = 2.0 * view.half_height * view.look_distance;
    const double width = height * figures.width_px / figures.height_px;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g", width);
    return filled(tr("view {0} wide, {1}"), {localized(text.data()), name_of(figures.precision)});
}

std::string certified_text(const PictureFigures& figures) {
    const std::string certified = grouped(figures.counts.certified);
    return figures.counts.coarse == 0 ? filled(tr("{0} certified"), {certified})
                                      : filled(tr("{0} certified, {1} of them coarse"),
                                               {certified, grouped(figures.counts.coarse)});
}

/// Draws a quiet line; a tooltip says what it means, and the line itself where it is cut.
void draw_line(const std::string& text, const char* about) {
    const bool cut = draw_elided(text, ImGui::GetContentRegionAvail().x);
    draw_tooltip(cut ? text + "\n" + about : about);
}

bool has_figures(const Shown& shown) { return shown.figures.width_px > 0 && !shown.figures.hidden; }

}  // namespace

bool many_undecided(const PictureFigures& figures) {
    const double pixels = static_cast<double>(figures.width_px) * figures.height_px;
    return static_cast<double>(figures.counts.undecided) > many * pixels;
}

std::string undecided_text(const PictureFigures& figures) {
    const std::string undecided = grouped(figures.counts.undecided);
    return figures.counts.not_drawn == 0 ? filled(tr("{0} undecided"), {undecided})
                                         : filled(tr("{0} undecided, {1} of them not drawn"),
                                                  {undecided, grouped(figures.counts.not_drawn)});
}

std::string frame_time(double ms) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), ms < 100.0 ? "%.1f ms" : "%.0f ms", ms);
    return localized(text.data());
}

float details_section_height(const Document& document, const Shown& shown) {
    const float figures = !has_figures(shown) ? 0.0F : shown.figures.counts.jumps > 0 ? 5.0F : 4.0F;
    const float lines = figures + (document.mark_undecided ? 3.0F : 0.0F);
    return 2.0F * ImGui::GetFrameHeightWithSpacing() +
           lines * ImGui::GetTextLineHeightWithSpacing();
}

void draw_details_section(Edited& edited, const Shown& shown) {
    draw_d_stop(edited.document.stop);
    draw_undecided(edited.document, edited.theme);
    if (!has_figures(shown)) return;
    const PictureFigures& figures = shown.figures;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    draw_line(filled(tr("{0}, {1} \xC3\x97 {2} pixels"),
                     {frame_time(figures.frame_ms), std::to_string(figures.width_px),
                      std::to_string(figures.height_px)}),
              tr("Time that the last full picture took, and its size."));
    draw_line(certified_text(figures),
              tr("Pixels with a proved root, and a proof that nothing lies before it; coarse: in a "
                 "bracket wider than asked for."));
    draw_line(
        undecided_text(figures),
        tr("Pixels where neither a root nor emptiness is proved at this d_stop (U marks them)."));
    if (figures.counts.jumps > 0)
        draw_line(filled(tr("{0} at jumps"), {grouped(figures.counts.jumps)}),
                  tr("Pixels where f changes its sign in a jump, without a root."));
    draw_line(view_scale(figures, shown.picture.camera),
              tr("Width of the view at the point looked at, and how the rays were computed."));
    ImGui::PopStyleColor();
}

}  // namespace zeroset::ui
