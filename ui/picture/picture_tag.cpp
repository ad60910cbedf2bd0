#include "ui/picture/picture_tag.hpp"

#include "ui/style/fonts.hpp"

#include <algorithm>
#include <cfloat>

namespace zeroset::ui {

void draw_tag(ImDrawList& canvas, const PictureArea& area, const ImVec2& dot, float gap,
              const std::string& text, float opacity, const Palette& colors) {
    ImFont* const small = font(FontRole::Small);
    const float size = small->FontSize * ImGui::GetIO().FontGlobalScale;
    const ImVec2 extent = small->CalcTextSizeA(size, FLT_MAX, 0.0F, text.c_str());
    const float pad = em(0.3F);
    const float width = extent.x + 2.0F * pad;
    const bool fits = dot.x + gap + width <= area.hi.x;
    const float wished = fits ? dot.x + gap : dot.x - gap - width;
    const float left = std::max(std::min(wished, area.hi.x - width), area.lo.x);
    const float low = area.lo.y + extent.y;
    const float top = std::clamp(dot.y - gap, low, std::max(low, area.hi.y)) - extent.y;
    canvas.AddRectFilled(ImVec2(left, top), ImVec2(left + width, top + extent.y),
                         faded(colors.card, opacity), em(0.3F));
    canvas.AddText(small, size, ImVec2(left + pad, top), faded(colors.text, opacity), text.c_str());
}

}  // namespace zeroset::ui
