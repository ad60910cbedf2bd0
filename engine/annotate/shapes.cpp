#include "engine/annotate/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace zeroset {

void append(Shapes& shapes, Shapes more) {
    shapes.insert(shapes.end(), std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
}

namespace {

/// Moves a shape of any kind.
struct Mover {
    glm::dvec2 by;

    void operator()(Line& line) const {
        line.from += by;
        line.to += by;
    }
    void operator()(Circle& circle) const { circle.middle += by; }
    void operator()(RoundedRectangle& rectangle) const {
        rectangle.lo += by;
        rectangle.hi += by;
    }
    void operator()(ConvexPolygon& polygon) const {
        for (glm::dvec2& corner : polygon.corners)
            corner += by;
    }
    void operator()(MapBar& bar) const {
        bar.lo += by;
        bar.hi += by;
    }
    void operator()(Text& text) const { text.at += by; }
};

}  // namespace

Shapes moved(Shapes shapes, const glm::dvec2& by) {
    for (Shape& shape : shapes)
        std::visit(Mover{by}, shape);
    return shapes;
}

std::array<glm::dvec2, 8> outline_offsets(double em) {
    constexpr double reach_em = 0.09;
    const double r = std::max(reach_em * em, 1.0);
    return {{{-r, -r}, {0, -r}, {r, -r}, {-r, 0}, {r, 0}, {-r, r}, {0, r}, {r, r}}};
}

std::uint32_t faded(std::uint32_t color, double opacity) {
    const double alpha = opacity * static_cast<double>(color >> 24U);
    return (color & 0xFFFFFFU) | static_cast<std::uint32_t>(std::lround(alpha)) << 24U;
}

}  // namespace zeroset
