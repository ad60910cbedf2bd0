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

/// How far a halo reaches beside its line, in em.
constexpr double halo_em = 0.09;

/// Whether dark lines are seen better than light ones on the colour (format as in Framebuffer).
bool is_light(std::uint32_t color) {
    const auto channel = [color](unsigned shift) {
        return static_cast<double>(color >> shift & 0xFFU) / 255.0;
    };
    return 0.2126 * channel(0) + 0.7152 * channel(8) + 0.0722 * channel(16) > 0.5;
}

std::uint32_t color_of(LineKind kind, const AxisColors& colors) {
    if (kind == LineKind::ClipBox) return colors.clip_box;
    if (kind == LineKind::Grid) return colors.grid;
    return colors.axes[static_cast<std::size_t>(kind)];
}

}  // namespace

AxisStyle axis_style_on(const Background& background, double em) {
    /// Opacity of each of a label's outline's eight copies, which lie over one another.
    constexpr double outline_opacity = 0.3;
    constexpr double halo_opacity = 0.55;
    /// Opacity of a number behind a surface: it must be read, unlike lines, which need only be
    /// seen.
    constexpr double hidden_label_opacity = 0.75;
    constexpr int rows = 3;  // the middle one has the mean colour
    const std::uint32_t ground = background_color(background, rows / 2, rows) | 0xFF000000U;
    return {.colors = is_light(ground) ? axes_on_light : axes_on_dark,
            .em = em,
            .hidden_label = hidden_label_opacity,
            .label_outline = faded(ground, outline_opacity),
            .halo = faded(ground, halo_opacity)};
}

AxisStyle axis_style_on_anything(double em) {
    AxisStyle style = axis_style_on(Background(), em);
    style.colors = axes_on_anything;
    style.label_outline = style.halo = 0;
    return style;
}

Shapes axis_shapes(const Axes& axes, const AxisStyle& style) {
    Shapes shapes;
    const auto width_of = [&style](LineKind kind) {
        return std::max(line_width_em(kind) * style.em, style.least_width);
    };
    for (const AxisLine& line : axes.lines) {
        if (style.halo >> 24U == 0 || line.hidden || line.kind == LineKind::Grid) continue;
        const double width = width_of(line.kind) + 2.0 * std::max(halo_em * style.em, 1.0);
        shapes.emplace_back(
            Line{.from = line.from, .to = line.to, .width = width, .color = style.halo});
    }
    for (const AxisLine& line : axes.lines) {
        const double width = width_of(line.kind);
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
