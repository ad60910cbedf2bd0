#include "engine/annotate/shapes_svg.hpp"

#include "engine/image/color_map.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <variant>

namespace zeroset {
namespace {

std::string number(double value) {
    std::array<char, 40> text{};
    const double rounded = std::round(100.0 * value) / 100.0;
    std::snprintf(text.data(), text.size(), "%g", rounded == 0.0 ? 0.0 : rounded);
    return text.data();
}

std::string attribute(const char* name, double value) {
    return std::string(" ") + name + "=\"" + number(value) + "\"";
}

/// `name`="#RRGGBB", and its opacity where it is not opaque.
std::string paint(const char* name, std::uint32_t color) {
    std::array<char, 8> hex{};
    std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x", color & 0xffU, color >> 8U & 0xffU,
                  color >> 16U & 0xffU);
    const std::uint32_t alpha = color >> 24U;
    std::string text = std::string(" ") + name + "=\"" + hex.data() + "\"";
    if (alpha < 255) text += attribute((std::string(name) + "-opacity").c_str(), alpha / 255.0);
    return text;
}

/// Fill, or the line of a frame.
std::string filled_or_line(std::uint32_t color, double line) {
    if (line > 0.0)
        return " fill=\"none\"" + paint("stroke", color) + attribute("stroke-width", line);
    return paint("fill", color);
}

std::string rectangle(const glm::dvec2& lo, const glm::dvec2& hi, double radius,
                      const std::string& style) {
    return "<rect" + attribute("x", lo.x) + attribute("y", lo.y) + attribute("width", hi.x - lo.x) +
           attribute("height", hi.y - lo.y) + (radius > 0.0 ? attribute("rx", radius) : "") +
           style + "/>\n";
}

std::string escaped(const std::string& words) {
    std::string text;
    for (const char letter : words) {
        switch (letter) {
            case '&': text += "&amp;"; break;
            case '<': text += "&lt;"; break;
            case '>': text += "&gt;"; break;
            default: text += letter;
        }
    }
    return text;
}

struct SvgOf {
    std::string operator()(const Line& line) const {
        return "<line" + attribute("x1", line.from.x) + attribute("y1", line.from.y) +
               attribute("x2", line.to.x) + attribute("y2", line.to.y) +
               paint("stroke", line.color) + attribute("stroke-width", line.width) + "/>\n";
    }
    std::string operator()(const Circle& circle) const {
        return "<circle" + attribute("cx", circle.middle.x) + attribute("cy", circle.middle.y) +
               attribute("r", circle.radius) + filled_or_line(circle.color, circle.line) + "/>\n";
    }
    std::string operator()(const RoundedRectangle& box) const {
        const double inside = 0.5 * box.line;
        return rectangle(box.lo + inside, box.hi - inside, box.radius,
                         filled_or_line(box.color, box.line));
    }
    std::string operator()(const ConvexPolygon& polygon) const {
        std::string points;
        for (const glm::dvec2& corner : polygon.corners)
            points += (points.empty() ? "" : " ") + number(corner.x) + "," + number(corner.y);
        return "<polygon points=\"" + points + "\"" + paint("fill", polygon.color) + "/>\n";
    }
    std::string operator()(const MapBar& bar) const {
        constexpr int steps = 64;
        std::string text;
        const double step = (bar.hi.x - bar.lo.x) / steps;
        for (int i = 0; i < steps; ++i) {
            const glm::dvec2 lo(bar.lo.x + i * step, bar.lo.y);
            text += rectangle(lo, {lo.x + step, bar.hi.y}, 0.0,
                              paint("fill", shown_color_at(bar.map, (i + 0.5) / steps)));
        }
        return text;
    }
    std::string operator()(const Text& text) const {
        const bool from_top = text.anchor != Anchor::Middle;
        const double down = (from_top ? 0.0 : -digits_middle_em) + baseline_em;
        const char* const anchor = text.anchor == Anchor::TopLeft    ? "start"
                                   : text.anchor == Anchor::TopRight ? "end"
                                                                     : "middle";
        std::string outline;
        if (text.outline != 0)
            outline = paint("stroke", text.outline) + attribute("stroke-width", 0.16 * text.em) +
                      " paint-order=\"stroke\"";
        return "<text" + attribute("x", text.at.x) + attribute("y", text.at.y + down * text.em) +
               attribute("font-size", text.em) + " text-anchor=\"" + anchor + "\"" +
               paint("fill", text.color) + outline + ">" + escaped(text.words) + "</text>\n";
    }
};

}  // namespace

std::string svg_of(const Shapes& shapes, const glm::dvec2& size, std::uint32_t ground) {
    const std::string width = number(size.x);
    const std::string height = number(size.y);
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "version=\"1.1\" width=\"" +
        width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
        "\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n";
    text += rectangle({0.0, 0.0}, size, 0.0, paint("fill", ground));
    for (const Shape& shape : shapes)
        text += std::visit(SvgOf(), shape);
    return text + "</svg>\n";
}

}  // namespace zeroset
