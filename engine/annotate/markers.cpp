#include "engine/annotate/markers.hpp"

#include "engine/annotate/hidden.hpp"
#include "engine/view/pixel_ray.hpp"

#include <algorithm>

namespace zeroset {
namespace {

// Lengths in units of the style.
constexpr double dot_radius = 0.32;
constexpr double gap_beside_dot = 0.3;
constexpr double tag_padding = 0.3;

constexpr double hidden_dot = 0.45;
constexpr double hidden_tag = 0.55;

constexpr std::uint32_t black = 0xFF000000U;
constexpr std::uint32_t white = 0xFFFFFFFFU;

/// A dot that shows on any ground: a white rim about it, a dark one about that.
Shapes dot_shapes(const glm::dvec2& at, bool hidden, bool selected, const CardStyle& style) {
    const std::uint32_t accent = style.colors.accent;
    const double unit = style.unit;
    const double radius = dot_radius * unit;
    const double opacity = hidden ? hidden_dot : 1.0;
    // Rims lie half a pixel within, so that they cover the smooth edge of what they surround.
    const auto rim = [&](double about, double thickness, std::uint32_t color) {
        return Circle{
            .middle = at, .radius = about - 0.5, .color = color, .line = thickness * unit};
    };
    Shapes shapes;
    if (!hidden) shapes.emplace_back(Circle{.middle = at, .radius = radius, .color = accent});
    shapes.emplace_back(rim(radius, 0.12, faded(hidden ? accent : white, opacity)));
    shapes.emplace_back(rim(radius + 0.1 * unit, 0.07, faded(black, 0.5 * opacity)));
    if (selected) shapes.emplace_back(rim(radius + 0.3 * unit, 0.12, accent));
    return shapes;
}

}  // namespace

Shapes marker_shapes(std::span<const MarkedPoint> points, const MarkedPicture& picture,
                     const CardStyle& style) {
    const ViewFrame view(picture.camera);
    const glm::dvec2& size = picture.size;
    const double gap = (dot_radius + gap_beside_dot) * style.unit;
    Shapes shapes;
    for (const MarkedPoint& point : points) {
        const auto seen = place_in_view(view, point.at);
        if (!seen) continue;
        const glm::dvec2 dot = 0.5 * size + size.y * glm::dvec2(seen->place.x, -seen->place.y);
        if (!(dot.x >= 0 && dot.y >= 0 && dot.x < size.x && dot.y < size.y)) continue;
        const bool hidden = is_behind(picture.frame, view, point.at);
        if (point.dot) append(shapes, dot_shapes(dot, hidden, point.selected, style));
        append(shapes, tag_shapes(point.words, dot, gap, size, style, hidden ? hidden_tag : 1.0));
    }
    return shapes;
}

Shapes tag_shapes(const std::string& words, const glm::dvec2& dot, double gap,
                  const glm::dvec2& canvas, const CardStyle& style, double opacity) {
    const double padding = tag_padding * style.unit;
    const double width = style.width(words, style.em) + 2.0 * padding;
    const double height = style.line_height();
    const bool fits = dot.x + gap + width <= canvas.x;
    const double wished = fits ? dot.x + gap : dot.x - gap - width;
    const double left = std::max(std::min(wished, canvas.x - width), 0.0);
    const double bottom = std::clamp(dot.y - gap, height, std::max(height, canvas.y));
    const glm::dvec2 lo(left, bottom - height);
    return {RoundedRectangle{.lo = lo,
                             .hi = {left + width, bottom},
                             .radius = padding,
                             .color = faded(style.colors.card, opacity)},
            Text{.words = words,
                 .at = {left + padding, lo.y},
                 .anchor = Anchor::TopLeft,
                 .em = style.em,
                 .color = faded(style.colors.text, opacity)}};
}

}  // namespace zeroset
