#include "engine/annotate/axis_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// How thick a line is, in em.
double line_width_em(LineKind kind) {
    switch (kind) {
        case LineKind::AxisX:
        case LineKind::AxisY:
        case LineKind::AxisZ: return 0.115;
        case LineKind::ClipBox: return 0.09;
        case LineKind::Grid: return 0.08;
    }
    return 0.0;
}

std::uint32_t color_of(LineKind kind, const AxisColors& colors) {
    if (kind == LineKind::ClipBox) return colors.clip_box;
    if (kind == LineKind::Grid) return colors.grid;
    return colors.axes[static_cast<std::size_t>(kind)];
}

}  // namespace

Shapes axis_shapes(const Axes& axes, const AxisStyle& style) {
    Shapes shapes;
    for (const AxisLine& line : axes.lines) {
        const double width = std::max(line_width_em(line.kind) * style.em, style.least_width);
        const std::uint32_t color = color_of(line.kind, style.colors);
        shapes.emplace_back(Line{.from = line.from,
                                 .to = line.to,
                                 .width = width,
                                 .color = line.hidden ? faded(color, hidden_opacity) : color});
    }
    for (const AxisLabel& label : axes.labels) {
        const double opacity = label.hidden ? style.hidden_label : 1.0;
        shapes.emplace_back(Text{.words = label.text,
                                 .at = label.middle,
                                 .anchor = Anchor::Middle,
                                 .em = style.em,
                                 .color = faded(color_of(label.kind, style.colors), opacity),
                                 .outline = faded(style.label_outline, opacity)});
    }
    return shapes;
}

double label_em(int width_px, int height_px) {
    constexpr double least = 11.0;
    constexpr double of_picture = 1.0 / 70.0;
    return std::max(least, std::round(of_picture * std::min(width_px, height_px)));
}

}  // namespace zeroset
