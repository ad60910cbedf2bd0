#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/view/camera.hpp"
#include "ui/panels/sections.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/label.hpp"
#include "ui/widgets/slider_row.hpp"

#include <imgui/imgui.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

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

float details_section_height(const Shown& shown) {
    const float lines = !has_figures(shown) ? 0.0F : shown.figures.counts.jumps > 0 ? 5.0F : 4.0F;
    return ImGui::GetFrameHeightWithSpacing() + lines * ImGui::GetTextLineHeightWithSpacing();
}

void draw_details_section(StopCriterion& stop, const Shown& shown) {
    draw_d_stop(stop);
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
