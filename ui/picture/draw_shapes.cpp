#include "ui/picture/draw_shapes.hpp"

#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

namespace zeroset::ui {
namespace {

/// Sides of a circle: none is seen as such at the sizes of markers.
constexpr int circle_sides = 32;
/// Pieces of a bar are about so wide; the colours between their ends are mixed by OpenGL.
constexpr float piece_em = 0.25F;

float in_float(double value) { return static_cast<float>(value); }

/// ImGui's size of a font: the height of its lines.
float line_height(double em) { return in_float(line_height_em * em); }

float text_width(std::string_view words, double em) {
    return font(FontRole::Small)
        ->CalcTextSizeA(line_height(em), FLT_MAX, 0.0F, words.data(), words.data() + words.size())
        .x;
}

class ShapeDrawer {
public:
    ShapeDrawer(ImDrawList& list, const ImVec2& origin) : list_(list), origin_(origin) {}

    void operator()(const Line& line) {
        list_.AddLine(place(line.from), place(line.to), line.color, in_float(line.width));
    }
    void operator()(const Circle& circle) {
        const ImVec2 middle = place(circle.middle);
        const float radius = in_float(circle.radius);
        if (circle.line > 0) {
            // ImGui draws a ring half a unit within its radius.
            list_.AddCircle(middle, radius + 0.5F, circle.color, circle_sides,
                            in_float(circle.line));
        } else {
            list_.AddCircleFilled(middle, radius, circle.color, circle_sides);
        }
    }
    void operator()(const RoundedRectangle& rectangle) {
        const ImVec2 lo = place(rectangle.lo);
        const ImVec2 hi = place(rectangle.hi);
        const float radius = in_float(rectangle.radius);
        if (rectangle.line > 0) {
            // ImGui draws the frame's middle half a unit within the edges.
            const float inset = 0.5F * in_float(rectangle.line) - 0.5F;
            list_.AddRect(ImVec2(lo.x + inset, lo.y + inset), ImVec2(hi.x - inset, hi.y - inset),
                          rectangle.color, radius, 0, in_float(rectangle.line));
        } else {
            list_.AddRectFilled(lo, hi, rectangle.color, radius);
        }
    }
    void operator()(const ConvexPolygon& polygon) {
        std::vector<ImVec2> corners;
        corners.reserve(polygon.corners.size());
        for (const glm::dvec2& corner : polygon.corners)
            corners.push_back(place(corner));
        list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), polygon.color);
    }
    void operator()(const MapBar& bar);
    void operator()(const Text& text);

private:
    [[nodiscard]] ImVec2 place(const glm::dvec2& at) const {
        return {origin_.x + in_float(at.x), origin_.y + in_float(at.y)};
    }

    ImDrawList& list_;
    ImVec2 origin_;
};

void ShapeDrawer::operator()(const MapBar& bar) {
    const ImVec2 lo = place(bar.lo);
    const ImVec2 hi = place(bar.hi);
    const float width = hi.x - lo.x;
    const int parts = std::max(1, static_cast<int>(std::ceil(width / em(piece_em))));
    const auto at = [&](int k) {
        return lo.x + width * static_cast<float>(k) / static_cast<float>(parts);
    };
    const auto color = [&](int k) {
        return shown_color_at(bar.map, static_cast<double>(k) / parts);
    };
    for (int i = 0; i < parts; ++i) {
        list_.AddRectFilledMultiColor(ImVec2(at(i), lo.y), ImVec2(at(i + 1), hi.y), color(i),
                                      color(i + 1), color(i + 1), color(i));
    }
}

void ShapeDrawer::operator()(const Text& text) {
    const float size = line_height(text.em);
    ImVec2 at = place(text.at);
    const float width = text.anchor == Anchor::TopLeft ? 0.0F : text_width(text.words, text.em);
    if (text.anchor == Anchor::TopRight) at.x -= width;
    if (text.anchor == Anchor::TopMiddle) at.x -= 0.5F * width;
    const bool middle = text.anchor == Anchor::Middle;
    if (middle) at = ImVec2(at.x - 0.5F * width, at.y - in_float(digits_middle_em * text.em));
    const auto draw = [&](const glm::dvec2& aside, std::uint32_t color) {
        const ImVec2 corner(at.x + in_float(aside.x), at.y + in_float(aside.y));
        // ImGui rounds down, which would move what is centred.
        list_.AddText(font(FontRole::Small), size,
                      middle ? ImVec2(std::round(corner.x), std::round(corner.y)) : corner, color,
                      text.words.data(), text.words.data() + text.words.size());
    };
    if (text.outline >> 24U != 0) {
        for (const glm::dvec2& aside : outline_offsets(text.em))
            draw(aside, text.outline);
    }
    draw({0.0, 0.0}, text.color);
}

}  // namespace

void draw_shapes(ImDrawList& list, const ImVec2& origin, const Shapes& shapes) {
    ShapeDrawer drawer(list, origin);
    for (const Shape& shape : shapes)
        std::visit(drawer, shape);
}

double small_em() {
    const auto size =
        static_cast<double>(font(FontRole::Small)->FontSize * ImGui::GetIO().FontGlobalScale);
    return size / line_height_em;
}

CardStyle card_style(Theme theme) {
    const Palette& colors = palette(theme);
    return {.colors = {.card = colors.card,
                       .border = colors.border,
                       .text = colors.text,
                       .quiet = colors.quiet,
                       .accent = colors.accent,
                       .undecided = colors.undecided,
                       .undecided_pale = colors.undecided_pale,
                       .coarse = colors.coarse},
            .unit = static_cast<double>(em(1.0F)),
            .em = small_em(),
            .width = [](std::string_view words, double em) {
                return static_cast<double>(text_width(words, em));
            }};
}

}  // namespace zeroset::ui
