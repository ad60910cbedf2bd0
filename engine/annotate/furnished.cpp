#include "engine/annotate/furnished.hpp"

#include "engine/annotate/paint.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

std::uint32_t furniture_color(const FurnitureColors& colors, FurnitureKind kind, bool hidden) {
    const std::uint32_t color = kind == FurnitureKind::ClipBox ? colors.clip_box
                                : kind == FurnitureKind::Grid
                                    ? colors.grid
                                    : colors.axes[static_cast<std::size_t>(kind)];
    if (!hidden) return color;
    const double alpha = hidden_opacity * static_cast<double>(color >> 24U);
    return (color & 0xFFFFFFU) | static_cast<std::uint32_t>(std::lround(alpha)) << 24U;
}

void paint_furniture(Framebuffer& picture, const Furniture& furniture,
                     const FurnitureColors& colors, const LabelFont& font, double em) {
    for (const FurnitureLine& line : furniture.lines) {
        paint_line(picture, line.from, line.to, std::max(line_width_em(line.kind) * em, 1.0),
                   furniture_color(colors, line.kind, line.hidden));
    }
    for (const FurnitureLabel& label : furniture.labels) {
        font.paint(picture, label.middle, label.text, em,
                   furniture_color(colors, label.kind, label.hidden));
    }
}

double label_em(int width_px, int height_px) {
    constexpr double least = 11.0;
    constexpr double of_picture = 1.0 / 70.0;
    return std::max(least, std::round(of_picture * std::min(width_px, height_px)));
}

}  // namespace zeroset
