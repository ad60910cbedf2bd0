#include "engine/annotate/paint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace zeroset {
namespace {

/// How much of a pixel lies within an edge at this distance from its centre, below 0: inside.
double within(double distance) { return std::clamp(0.5 - distance, 0.0, 1.0); }

class ShapePainter {
public:
    ShapePainter(Framebuffer& picture, const LabelFont& font) : picture_(picture), font_(font) {
        picture.blank_rows.clear();
    }

    void operator()(const Line& line) {
        paint_line(picture_, line.from, line.to, line.width, line.color);
    }
    void operator()(const Circle& circle);
    void operator()(const RoundedRectangle& rectangle);
    void operator()(const ConvexPolygon& polygon);
    void operator()(const MapBar& bar);
    void operator()(const Text& text) { font_.paint(picture_, text); }

private:
    /// Mixes a colour into all pixels between lo and hi: `coverage` and `color` are functions of a
    /// pixel's centre.
    template <class Coverage, class Color>
    void fill(const glm::dvec2& lo, const glm::dvec2& hi, const Coverage& coverage,
              const Color& color);

    Framebuffer& picture_;
    const LabelFont& font_;
};

template <class Coverage, class Color>
void ShapePainter::fill(const glm::dvec2& lo, const glm::dvec2& hi, const Coverage& coverage,
                        const Color& color) {
    const auto clamped = [](double at, int end) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(end)));
    };
    const int last_col = clamped(std::ceil(hi.x + 0.5), picture_.width);
    const int last_row = clamped(std::ceil(hi.y + 0.5), picture_.height);
    for (int row = clamped(std::floor(lo.y - 0.5), picture_.height); row < last_row; ++row) {
        for (int col = clamped(std::floor(lo.x - 0.5), picture_.width); col < last_col; ++col) {
            const glm::dvec2 centre(col + 0.5, row + 0.5);
            const double part = coverage(centre);
            if (!(part > 0)) continue;
            std::uint32_t& pixel = picture_.color[picture_.index(col, row)];
            pixel = blended(pixel, color(centre), part);
        }
    }
}

void ShapePainter::operator()(const Circle& circle) {
    const bool filled = !(circle.line > 0);
    const double half = 0.5 * circle.line;
    const auto coverage = [&](const glm::dvec2& p) {
        const double distance = glm::distance(p, circle.middle) - circle.radius;
        return filled ? within(distance) : within(distance - half) - within(distance + half);
    };
    const glm::dvec2 reach(circle.radius + half);
    fill(circle.middle - reach, circle.middle + reach, coverage,
         [&](const glm::dvec2&) { return circle.color; });
}

void ShapePainter::operator()(const RoundedRectangle& rectangle) {
    const glm::dvec2 middle = 0.5 * (rectangle.lo + rectangle.hi);
    const glm::dvec2 half = 0.5 * (rectangle.hi - rectangle.lo);
    const double radius = std::min({rectangle.radius, half.x, half.y});
    const auto coverage = [&](const glm::dvec2& p) {
        const glm::dvec2 beyond = glm::abs(p - middle) - half + radius;
        const double distance = glm::length(glm::max(beyond, glm::dvec2(0.0))) +
                                std::min(std::max(beyond.x, beyond.y), 0.0) - radius;
        const double inner = rectangle.line > 0 ? within(distance + rectangle.line) : 0.0;
        return within(distance) - inner;
    };
    fill(rectangle.lo, rectangle.hi, coverage, [&](const glm::dvec2&) { return rectangle.color; });
}

void ShapePainter::operator()(const ConvexPolygon& polygon) {
    const std::size_t count = polygon.corners.size();
    if (count < 3) return;
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x * b.y - a.y * b.x;
    };
    glm::dvec2 lo = polygon.corners[0];
    glm::dvec2 hi = lo;
    double area = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2& corner = polygon.corners[i];
        lo = glm::min(lo, corner);
        hi = glm::max(hi, corner);
        area += cross(corner, polygon.corners[(i + 1) % count]);
    }
    const double turn = area < 0 ? -1.0 : 1.0;
    const auto coverage = [&](const glm::dvec2& p) {
        double distance = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec2& from = polygon.corners[i];
            const glm::dvec2 along = polygon.corners[(i + 1) % count] - from;
            const double length = glm::length(along);
            if (length > 0) distance = std::max(distance, -turn * cross(along, p - from) / length);
        }
        return within(distance);
    };
    fill(lo, hi, coverage, [&](const glm::dvec2&) { return polygon.color; });
}

/// Fills whole pixels: a bar with smooth ends would seem to end in another colour.
void ShapePainter::operator()(const MapBar& bar) {
    const glm::dvec2 lo = glm::round(bar.lo);
    const glm::dvec2 hi = glm::round(bar.hi);
    const auto coverage = [&](const glm::dvec2& p) {
        return p.x > lo.x && p.x < hi.x && p.y > lo.y && p.y < hi.y ? 1.0 : 0.0;
    };
    fill(lo, hi, coverage, [&](const glm::dvec2& p) {
        return shown_color_at(bar.map, (p.x - lo.x) / (hi.x - lo.x));
    });
}

}  // namespace

void paint_shapes(Framebuffer& picture, const Shapes& shapes, const LabelFont& font) {
    ShapePainter painter(picture, font);
    for (const Shape& shape : shapes)
        std::visit(painter, shape);
}

}  // namespace zeroset
