#include "ui/picture/furniture_layer.hpp"

#include "engine/annotate/furnished.hpp"
#include "engine/annotate/furniture.hpp"
#include "engine/annotate/furniture_colors.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace zeroset::ui {
namespace {

/// ImGui's size of a font is the height of DejaVu's lines.
constexpr float em_of_line = 1.0F / 1.164F;
/// From a line's top to the middle of its digits.
constexpr float digits_middle = 0.484F;

constexpr float outline_em = 0.09F;
/// Of each of its eight copies, which lie over one another.
constexpr float outline_opacity = 0.3F;
/// Of a number behind a surface: it must be read, unlike lines, which need only be seen.
constexpr float hidden_label = 0.6F;

struct LabelPen {
    ImFont* font;
    float size;

    LabelPen()
        : font(ui::font(FontRole::Small)), size(font->FontSize * ImGui::GetIO().FontGlobalScale) {}
    [[nodiscard]] float em() const { return em_of_line * size; }
    void draw(ImDrawList& canvas, const ImVec2& middle, const std::string& text,
              std::uint32_t color) const {
        const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0.0F, text.c_str());
        const ImVec2 at(std::round(middle.x - 0.5F * extent.x),
                        std::round(middle.y - digits_middle * size));
        canvas.AddText(font, size, at, color, text.c_str());
    }
    /// The same about itself, in the colour of a thin outline.
    void outline(ImDrawList& canvas, const ImVec2& middle, const std::string& text,
                 std::uint32_t color) const {
        const float reach = std::max(outline_em * em(), 1.0F);
        for (const auto& [across, down] :
             {std::pair(-1, -1), {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}) {
            draw(canvas,
                 ImVec2(middle.x + reach * static_cast<float>(across),
                        middle.y + reach * static_cast<float>(down)),
                 text, color);
        }
    }
};

FurnitureView view_of(const UiState& state, const ImVec2& extent, const LabelPen& pen) {
    const Document& document = state.document;
    return {document.clip,
            state.shown.camera,
            document.up,
            static_cast<int>(extent.x),
            static_cast<int>(extent.y),
            static_cast<double>(pen.em())};
}

ImVec2 placed(const ImVec2& lo, const glm::dvec2& at) {
    return {lo.x + static_cast<float>(at.x), lo.y + static_cast<float>(at.y)};
}

}  // namespace

void draw_furniture(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi, const UiState& state) {
    const FurnitureChoice choice{state.document.axes, state.document.clip_box, state.document.grid};
    const ImVec2 extent(hi.x - lo.x, hi.y - lo.y);
    if (!choice.any() || state.shown.frame == nullptr || extent.x < 1.0F || extent.y < 1.0F) return;
    const LabelPen pen;
    const Furniture furniture =
        make_furniture(view_of(state, extent, pen), choice, *state.shown.frame);
    const FurnitureColors& colors =
        state.theme == Theme::Dark ? furniture_on_dark : furniture_on_light;
    // So that numbers can be read on surfaces, too.
    const std::uint32_t behind = palette(state.theme).sky;
    const float pixel = 1.0F / ImGui::GetIO().DisplayFramebufferScale.x;
    canvas.PushClipRect(lo, hi, true);
    for (const FurnitureLine& line : furniture.lines) {
        const float width = static_cast<float>(line_width_em(line.kind)) * pen.em();
        canvas.AddLine(placed(lo, line.from), placed(lo, line.to),
                       furniture_color(colors, line.kind, line.hidden), std::max(width, pixel));
    }
    for (const FurnitureLabel& label : furniture.labels) {
        const std::uint32_t color = furniture_color(colors, label.kind, false);
        const float opacity = label.hidden ? hidden_label : 1.0F;
        pen.outline(canvas, placed(lo, label.middle), label.text,
                    faded(behind, outline_opacity * opacity));
        pen.draw(canvas, placed(lo, label.middle), label.text, faded(color, opacity));
    }
    canvas.PopClipRect();
}

}  // namespace zeroset::ui
