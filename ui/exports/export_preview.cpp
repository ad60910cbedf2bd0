#include "engine/base/translation.hpp"
#include "ui/exports/export_page.hpp"
#include "ui/style/label.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset::ui {
namespace {

constexpr float preview_em = 15.0F;  ///< height of a picture's room
constexpr float dash_px = 4.0F;
constexpr double points_per_mm = 72.0 / 25.4;

struct Rect {
    ImVec2 lo, hi;
    [[nodiscard]] float width() const { return hi.x - lo.x; }
    [[nodiscard]] float height() const { return hi.y - lo.y; }
};

/// The largest rectangle of this shape in the middle of `space`.
Rect fitted(const Rect& space, double width, double height) {
    const float scale = std::min(space.width() / static_cast<float>(width),
                                 space.height() / static_cast<float>(height));
    const ImVec2 half(0.5F * scale * static_cast<float>(width),
                      0.5F * scale * static_cast<float>(height));
    const ImVec2 middle(0.5F * (space.lo.x + space.hi.x), 0.5F * (space.lo.y + space.hi.y));
    return {.lo = {std::floor(middle.x - half.x), std::floor(middle.y - half.y)},
            .hi = {std::ceil(middle.x + half.x), std::ceil(middle.y + half.y)}};
}

/// Draws squares in two greys, which are seen through transparent pictures.
void draw_checkerboard(ImDrawList& canvas, const Rect& area) {
    constexpr std::uint32_t dark = 0xFF9A9A9A;
    constexpr std::uint32_t pale = 0xFFC4C4C4;
    const float side = em(0.6F);
    canvas.AddRectFilled(area.lo, area.hi, pale);
    canvas.PushClipRect(area.lo, area.hi, true);
    for (int row = 0; static_cast<float>(row) * side < area.height(); ++row) {
        for (int col = row % 2; static_cast<float>(col) * side < area.width(); col += 2) {
            const ImVec2 lo(area.lo.x + static_cast<float>(col) * side,
                            area.lo.y + static_cast<float>(row) * side);
            canvas.AddRectFilled(lo, ImVec2(lo.x + side, lo.y + side), dark);
        }
    }
    canvas.PopClipRect();
}

void draw_image(ImDrawList& canvas, unsigned int name, const Rect& area) {
    const auto id = static_cast<std::uintptr_t>(name);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui keeps OpenGL's number as a pointer
    canvas.AddImage(reinterpret_cast<ImTextureID>(id), area.lo, area.hi);
}

/// Draws every other stretch of a line.
void draw_dashes(ImDrawList& canvas, const std::vector<ImVec2>& points, std::uint32_t color,
                 float width) {
    float along = 0.0F;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const ImVec2 from = points[i - 1];
        const ImVec2 to = points[i];
        along += std::hypot(to.x - from.x, to.y - from.y);
        if (std::fmod(along, 2.0F * dash_px) < dash_px) canvas.AddLine(from, to, color, width);
    }
}

void draw_lines(ImDrawList& canvas, const std::vector<PreviewLine>& lines, const Rect& page,
                float points_across) {
    constexpr std::uint32_t paper = 0xFFFFFFFF;
    constexpr std::uint32_t ink = 0xFF000000;
    canvas.AddRectFilled(page.lo, page.hi, paper);
    canvas.PushClipRect(page.lo, page.hi, true);
    std::vector<ImVec2> points;
    for (const PreviewLine& line : lines) {
        points.clear();
        for (const glm::dvec2& point : line.points)
            points.emplace_back(page.lo.x + static_cast<float>(point.x) * page.width(),
                                page.lo.y + static_cast<float>(point.y) * page.height());
        const float width = std::max(line.width_pt * page.width() / points_across, 0.8F);
        if (line.dashed) {
            draw_dashes(canvas, points, ink, width);
        } else {
            canvas.AddPolyline(points.data(), static_cast<int>(points.size()), ink,
                               ImDrawFlags_None, width);
        }
    }
    canvas.PopClipRect();
}

/// Draws lines that are asked for by a click.
void draw_details(const std::vector<std::string>& lines) {
    if (lines.empty() || !ImGui::TreeNode(labelled(tr("Details"), "###details").c_str())) return;
    for (const std::string& line : lines)
        ImGui::TextUnformatted(line.c_str());
    ImGui::TreePop();
}

void draw_lines_of_text(const ExportPreview& preview, const Palette& colors) {
    ImGui::PushTextWrapPos(0.0F);
    if (!preview.verdict.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, preview.is_good ? colors.accent : colors.warning);
        ImGui::TextUnformatted(preview.verdict.c_str());
        ImGui::PopStyleColor();
    }
    for (const std::string& fact : preview.facts)
        ImGui::TextUnformatted(fact.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, colors.warning);
    for (const std::string& warning : preview.warnings)
        ImGui::TextUnformatted(warning.c_str());
    ImGui::PopStyleColor();
    draw_details(preview.details);
    ImGui::PopTextWrapPos();
}

/// The text where there is nothing to be seen yet.
const char* waiting_text(const UiState& state) {
    if (!state.shown.export_preview.warnings.empty()) return "";
    return state.shown.export_progress.name.empty() ? "..." : tr("after what is being saved");
}

/// Draws the text of what is going on over `space`.
void draw_over(ImDrawList& canvas, const Rect& space, const std::string& text,
               const Palette& colors) {
    if (text.empty()) return;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 lo(0.5F * (space.lo.x + space.hi.x - size.x), space.hi.y - size.y - em(0.8F));
    const ImVec2 pad(em(0.5F), em(0.25F));
    canvas.AddRectFilled(ImVec2(lo.x - pad.x, lo.y - pad.y),
                         ImVec2(lo.x + size.x + pad.x, lo.y + size.y + pad.y), colors.bar,
                         em(0.3F));
    canvas.AddText(lo, colors.quiet, text.c_str());
}

/// Draws the picture or the lines; false where there are none yet.
bool draw_content(ImDrawList& canvas, const ExportWish& wish, const ExportPreview& preview,
                  const Rect& space) {
    if (wish.kind == ExportKind::Drawing) {
        if (preview.facts.empty()) return false;
        const glm::dvec2& size = wish.drawing.size_mm;
        draw_lines(canvas, preview.lines, fitted(space, size.x, size.y),
                   static_cast<float>(size.x * points_per_mm));
        return true;
    }
    if (preview.texture == 0) return false;
    const Rect area = fitted(space, preview.size_px.x, preview.size_px.y);
    const bool alpha = wish.kind == ExportKind::Film
                           ? wish.film.alpha
                           : wish.kind == ExportKind::Picture && wish.picture.alpha;
    if (alpha) draw_checkerboard(canvas, area);
    draw_image(canvas, preview.texture, area);
    return true;
}

/// Draws the picture that is being saved, as it goes.
bool draw_progress(ImDrawList& canvas, const ExportProgress& progress, const Rect& space) {
    draw_image(canvas, progress.texture, fitted(space, progress.size_px.x, progress.size_px.y));
    return true;
}

}  // namespace

void draw_export_preview(UiState& state) {
    const Palette& colors = palette(state.edited.theme);
    const ExportPreview& preview = state.shown.export_preview;
    ExportPage& page = state.pages.exports;
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    const float height = std::min(em(preview_em), 0.5F * ImGui::GetWindowHeight());
    const Rect space{.lo = lo, .hi = {lo.x + ImGui::GetContentRegionAvail().x, lo.y + height}};
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    page.preview_px = {static_cast<int>(space.width() * scale.x),
                       static_cast<int>(space.height() * scale.y)};
    canvas.AddRectFilled(space.lo, space.hi, colors.field, em(0.3F));
    const ExportProgress& progress = state.shown.export_progress;
    const bool drawn = progress.texture != 0 ? draw_progress(canvas, progress, space)
                                             : draw_content(canvas, page.wish, preview, space);
    // Pictures are soon there; what takes long says how far it is.
    const bool takes_long =
        page.wish.kind == ExportKind::Mesh || page.wish.kind == ExportKind::Drawing;
    const bool tells = !preview.doing.empty() && takes_long;
    draw_over(canvas, space, tells ? preview.doing : drawn ? "" : waiting_text(state), colors);
    ImGui::Dummy(ImVec2(space.width(), space.height()));
}

void draw_export_facts(const UiState& state) {
    draw_lines_of_text(state.shown.export_preview, palette(state.edited.theme));
}

}  // namespace zeroset::ui
