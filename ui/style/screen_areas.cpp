#include "ui/style/screen_areas.hpp"

#include "ui/style/theme.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset::ui {
float side_panel_width(const Layout& layout) {
    if (layout.folded || layout.presents) return 0.0F;
    const float most = most_of_window * ImGui::GetIO().DisplaySize.x;
    return std::ceil(std::min(std::max(em(layout.panel_em), em(narrowest_em)),
                              std::max(most, em(narrowest_em))));
}

float status_bar_height() { return std::ceil(em(1.9F)); }

float picture_height(const Layout& layout) {
    const float below = layout.presents ? 0.0F : status_bar_height();
    return std::max(ImGui::GetIO().DisplaySize.y - below, 0.0F);
}

PictureArea viewport_area(const Layout& layout) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float left = std::min(side_panel_width(layout), window.x);
    return {.lo = ImVec2(left, 0.0F), .hi = ImVec2(window.x, picture_height(layout))};
}

}  // namespace zeroset::ui
