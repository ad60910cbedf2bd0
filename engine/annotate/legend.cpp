#include "engine/annotate/legend.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/base/utf8.hpp"
#include "engine/image/frame_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

// Lengths of the card, in units of its style.
constexpr double card_width = 15.0;
constexpr double narrowest = 9.0;
constexpr double padding = 0.7;
constexpr double bar_height = 0.8;
constexpr double below_bar = 0.25;
constexpr double line_em = 1.35;
constexpr double between_numbers = 0.4;
constexpr double corner_radius = 0.5;
constexpr double stripe = 0.5;
constexpr double before_mark = 1.4;  ///< words of a pixel's mark begin there

/// The parts of a picture that a card may take, so that most of a small one stays free.
constexpr double most_of_width = 0.62;
constexpr double most_for_marks = 0.95;  ///< of the width, where the words of marks need it
constexpr double most_of_height = 0.45;

const char* const ellipsis = "\xE2\x80\xA6";

/// The number in few digits; never "-0".
std::string end_text(double value) {
    return localized(short_number(value == 0.0 ? 0.0 : value, 4));
}

/// The text cut with an ellipsis to `space`.
std::string fitting(std::string text, double space, const CardStyle& style) {
    const auto fits = [&](const std::string& words) {
        return style.width(words, style.em) <= space;
    };
    if (fits(text)) return text;
    while (!text.empty() && !fits(text + ellipsis)) {
        do
            text.pop_back();
        while (!text.empty() && continues_character(text.back()));
    }
    return text + ellipsis;
}

/// The card's content, line by line downwards.
class Card {
public:
    Card(const glm::dvec2& lo, double width, const CardStyle& style, Shapes& shapes)
        : at_(lo), width_(width), style_(style), shapes_(shapes) {}

    void add_title(const std::string& words) {
        add(fitting(words, width_, style_), at_.x, Anchor::TopLeft, style_.colors.text);
        at_.y += line_em * style_.unit;
    }
    void add_scale(const ValueRange& range, const Legend& legend);
    void add_directions();
    void add_mark(PixelMark mark, const char* words) {
        const double unit = style_.unit;
        append(shapes_,
               swatch_shapes(at_ + glm::dvec2(0.0, 0.05 * unit), 0.9 * unit, mark, style_));
        add(fitting(words, width_ - before_mark * unit, style_), at_.x + before_mark * unit,
            Anchor::TopLeft, style_.colors.quiet);
        at_.y += line_em * unit;
    }

private:
    void add(std::string words, double x, Anchor anchor, std::uint32_t color) {
        shapes_.emplace_back(Text{.words = std::move(words),
                                  .at = {x, at_.y},
                                  .anchor = anchor,
                                  .em = style_.em,
                                  .color = color});
    }

    glm::dvec2 at_;
    double width_;
    const CardStyle& style_;
    Shapes& shapes_;
};

/// Adds the map's colours with the numbers at its ends and, where there is room, in its middle.
void Card::add_scale(const ValueRange& range, const Legend& legend) {
    const double unit = style_.unit;
    shapes_.emplace_back(
        MapBar{.lo = at_, .hi = at_ + glm::dvec2(width_, bar_height * unit), .map = legend.map});
    at_.y += (bar_height + below_bar) * unit;
    const std::string lo = end_text(range.lo);
    const std::string hi = end_text(range.hi);
    const std::string middle =
        end_text(legend.logarithmic ? std::sqrt(range.lo * range.hi) : 0.5 * (range.lo + range.hi));
    add(lo, at_.x, Anchor::TopLeft, style_.colors.quiet);
    add(hi, at_.x + width_, Anchor::TopRight, style_.colors.quiet);
    const auto width = [&](const std::string& words) { return style_.width(words, style_.em); };
    const double free = 0.5 * (width_ - width(middle)) - between_numbers * unit;
    if (std::max(width(lo), width(hi)) < free)
        add(middle, at_.x + 0.5 * width_, Anchor::TopMiddle, style_.colors.quiet);
    at_.y += line_em * unit;
}

/// Adds how the three directions look.
void Card::add_directions() {
    constexpr std::array<std::pair<const char*, std::uint32_t>, 3> axes{
        {{"x", 0xFF8080FFU}, {"y", 0xFF80FF80U}, {"z", 0xFFFF8080U}}};
    const double unit = style_.unit;
    double left = at_.x;
    for (const auto& [name, color] : axes) {
        const double size = bar_height * unit;
        const glm::dvec2 lo(left, at_.y + 0.1 * unit);
        shapes_.emplace_back(RoundedRectangle{
            .lo = lo, .hi = lo + glm::dvec2(size), .radius = 0.15 * unit, .color = color});
        add(name, left + size + 0.4 * unit, Anchor::TopLeft, style_.colors.quiet);
        left += 3.0 * unit;
    }
    at_.y += line_em * unit;
}

/// The kinds of marked pixels that the legend explains, each with its text.
std::vector<std::pair<PixelMark, const char*>> marks_of(const CornerLegend& legend) {
    if (!legend.undecided) return {};
    std::vector<std::pair<PixelMark, const char*>> marks{
        {PixelMark::UndecidedDrawn, tr("undecided, drawn")},
        {PixelMark::UndecidedNotDrawn, tr("undecided, not drawn")}};
    if (legend.coarse) marks.emplace_back(PixelMark::Coarse, tr("certified, coarse"));
    return marks;
}

/// The height of the card, in units.
double height_of(const CornerLegend& legend) {
    double height = 2.0 * padding - below_bar;
    if (legend.legend != nullptr) {
        height += 2.0 * line_em;
        if (legend.legend->range) height += bar_height + below_bar;
    }
    if (legend.sections != nullptr) height += 2.0 * line_em + bar_height + below_bar;
    return height + static_cast<double>(marks_of(legend).size()) * line_em;
}

/// The width that the words of the marks need.
double width_of_marks(const CornerLegend& legend, const CardStyle& style) {
    double widest = 0.0;
    for (const auto& [mark, words] : marks_of(legend))
        widest = std::max(widest, style.width(words, style.em));
    return widest + (before_mark + 2.0 * padding) * style.unit;
}

std::string height_title(const glm::dvec3& up) {
    const char axis = up.x != 0.0 ? 'x' : up.y != 0.0 ? 'y' : 'z';
    const bool down = up.x + up.y + up.z < 0.0;
    return filled(tr("height: {0}"), {(down ? "\xE2\x88\x92" : "") + std::string(1, axis)});
}

/// The part of the polygon where x + y is on the side of `bound` that `above` says.
std::vector<glm::dvec2> cut(const std::vector<glm::dvec2>& polygon, double bound, bool above) {
    const auto inside = [&](const glm::dvec2& p) {
        return above ? p.x + p.y - bound : bound - p.x - p.y;
    };
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& from = polygon[i];
        const glm::dvec2& to = polygon[(i + 1) % polygon.size()];
        const double at_from = inside(from);
        const double at_to = inside(to);
        if (at_from >= 0) kept.push_back(from);
        if ((at_from < 0) != (at_to < 0))
            kept.push_back(glm::mix(from, to, at_from / (at_from - at_to)));
    }
    return kept;
}

}  // namespace

const char* shown_name(ColorBy by) {
    switch (by) {
        case ColorBy::Plain: return tr_in("what colors show", "surface and side");
        case ColorBy::Normal: return tr_in("what colors show", "normal");
        case ColorBy::Height: return tr_in("what colors show", "height");
        case ColorBy::Depth: return tr_in("what colors show", "distance from the eye");
        case ColorBy::MeanCurvature: return tr_in("what colors show", "mean curvature");
        case ColorBy::GaussianCurvature: return tr_in("what colors show", "Gaussian curvature");
        case ColorBy::Gradient: return tr_in("what colors show", "length of the gradient");
        case ColorBy::Expression: return tr_in("what colors show", "expression");
    }
    return "";
}

Legend cost_legend() {
    return {.title = tr("evaluations a pixel"),
            .map = cost_map,
            .range = ValueRange{.lo = cheapest_pixel, .hi = dearest_pixel},
            .logarithmic = true};
}

Legend legend_of(const Coloring& coloring, const std::string& expression) {
    Legend legend{
        .title = shown_name(coloring.by), .by = coloring.by, .map = coloring.map, .range = {}};
    if (has_range(coloring.by)) legend.range = coloring.range;
    if (coloring.by == ColorBy::Height) legend.title = height_title(coloring.up);
    if (coloring.by == ColorBy::Expression) legend.title = expression;
    return legend;
}

Legend section_legend(const SectionValues& values) {
    return {.title = tr("values in sections"), .map = values.map, .range = values.range};
}

Shapes swatch_shapes(const glm::dvec2& lo, double size, PixelMark mark, const CardStyle& style) {
    const CardColors& colors = style.colors;
    const bool striped = mark != PixelMark::UndecidedNotDrawn;
    const std::uint32_t solid = mark == PixelMark::Coarse ? colors.coarse : colors.undecided;
    const std::uint32_t pale = mark == PixelMark::Coarse ? colors.border : colors.undecided_pale;
    const glm::dvec2 hi = lo + glm::dvec2(size);
    Shapes shapes{RoundedRectangle{.lo = lo, .hi = hi, .color = striped ? pale : solid}};
    if (!striped) return shapes;
    const std::vector<glm::dvec2> square{lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
    const double step = stripe * style.unit;
    // Stripes run up to the right; their width is measured across.
    const double half = 0.5 * 0.7 * step * std::sqrt(2.0);
    for (double at = step; at < 2.0 * size; at += 2.0 * step) {
        const double middle = lo.x + lo.y + at;
        std::vector<glm::dvec2> corners =
            cut(cut(square, middle - half, true), middle + half, false);
        if (corners.size() >= 3)
            shapes.emplace_back(ConvexPolygon{.corners = std::move(corners), .color = solid});
    }
    return shapes;
}

Shapes legend_shapes(const CornerLegend& legend, const glm::dvec2& corner, const glm::dvec2& space,
                     const CardStyle& style) {
    if (legend.legend == nullptr && legend.sections == nullptr && !legend.undecided) return {};
    const double unit = style.unit;
    const double usual = std::min((card_width + 2.0 * padding) * unit, most_of_width * space.x);
    const double width =
        std::max(usual, std::min(width_of_marks(legend, style), most_for_marks * space.x));
    const double height = height_of(legend) * unit;
    if (width < narrowest * unit || height > most_of_height * space.y) return {};
    const glm::dvec2 lo = corner - glm::dvec2(width, height);
    const double radius = corner_radius * unit;
    Shapes shapes{
        RoundedRectangle{.lo = lo, .hi = corner, .radius = radius, .color = style.colors.card},
        RoundedRectangle{
            .lo = lo, .hi = corner, .radius = radius, .color = style.colors.border, .line = 1.0}};
    Card card(lo + glm::dvec2(padding * unit), width - 2.0 * padding * unit, style, shapes);
    if (legend.legend != nullptr) {
        card.add_title(legend.legend->title);
        if (legend.legend->range) {
            card.add_scale(*legend.legend->range, *legend.legend);
        } else {
            card.add_directions();
        }
    }
    if (legend.sections != nullptr) {
        card.add_title(legend.sections->title);
        card.add_scale(*legend.sections->range, *legend.sections);
    }
    for (const auto& [mark, words] : marks_of(legend))
        card.add_mark(mark, words);
    return shapes;
}

}  // namespace zeroset
