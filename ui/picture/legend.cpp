#include "ui/picture/legend.hpp"

#include "ui/style/fonts.hpp"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr float width_em = 15.0F;
constexpr float padding_em = 0.7F;
constexpr float bar_em = 0.8F;
constexpr float line_em = 1.35F;

std::string short_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value == 0.0 ? 0.0 : value);
    return text.data();
}

/// In the small font.
class SmallText {
public:
    explicit SmallText(ImDrawList& canvas)
        : canvas_(canvas),
          font_(font(FontRole::Small)),
          size_(font_->FontSize * ImGui::GetIO().FontGlobalScale) {}

    [[nodiscard]] float width(const std::string& text) const {
        return font_->CalcTextSizeA(size_, 1e9F, 0.0F, text.c_str()).x;
    }
    void draw(const ImVec2& at, std::uint32_t color, const std::string& text) {
        canvas_.AddText(font_, size_, at, color, text.c_str());
    }
    /// Cut with an ellipsis to `room`.
    [[nodiscard]] std::string fitting(std::string text, float room) const {
        if (width(text) <= room) return text;
        while (!text.empty() && width(text + "\xE2\x80\xA6") > room) {
            do
                text.pop_back();
            while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U);
        }
        return text + "\xE2\x80\xA6";
    }

private:
    ImDrawList& canvas_;
    ImFont* font_;
    float size_;
};

/// The card's content, line by line downwards.
class Card {
public:
    Card(ImDrawList& canvas, const ImVec2& lo, float width, const Palette& colors)
        : canvas_(canvas), text_(canvas), at_(lo), width_(width), colors_(colors) {}

    void title(const std::string& words) {
        text_.draw(at_, colors_.text, text_.fitting(words, width_));
        at_.y += em(line_em);
    }
    void scale(const ValueRange& range, ColorMap map) {
        draw_map_bar(canvas_, at_, ImVec2(at_.x + width_, at_.y + em(bar_em)), map);
        at_.y += em(bar_em + 0.25F);
        const std::string lo = short_text(range.lo);
        const std::string hi = short_text(range.hi);
        const std::string middle = short_text(0.5 * (range.lo + range.hi));
        const float middle_width = text_.width(middle);
        text_.draw(at_, colors_.quiet, lo);
        text_.draw(ImVec2(at_.x + width_ - text_.width(hi), at_.y), colors_.quiet, hi);
        const float left = at_.x + 0.5F * (width_ - middle_width);
        const bool fits = left > at_.x + text_.width(lo) + em(0.4F) &&
                          left + middle_width < at_.x + width_ - text_.width(hi) - em(0.4F);
        if (fits) text_.draw(ImVec2(left, at_.y), colors_.quiet, middle);
        at_.y += em(line_em);
    }
    /// How the three directions look.
    void directions() {
        constexpr std::array<std::pair<const char*, std::uint32_t>, 3> axes{
            {{"x", 0xFF8080FFU}, {"y", 0xFF80FF80U}, {"z", 0xFFFF8080U}}};
        float left = at_.x;
        for (const auto& [name, color] : axes) {
            const float size = em(bar_em);
            canvas_.AddRectFilled(ImVec2(left, at_.y + em(0.1F)),
                                  ImVec2(left + size, at_.y + em(0.1F) + size), color, em(0.15F));
            text_.draw(ImVec2(left + size + em(0.4F), at_.y), colors_.quiet, name);
            left += em(3.0F);
        }
        at_.y += em(line_em);
    }
    void mark(Mark mark, const char* words) {
        draw_mark_swatch(canvas_, ImVec2(at_.x, at_.y + em(0.05F)), em(0.9F), mark, colors_);
        text_.draw(ImVec2(at_.x + em(1.4F), at_.y), colors_.quiet, words);
        at_.y += em(line_em);
    }

private:
    ImDrawList& canvas_;
    SmallText text_;
    ImVec2 at_;
    float width_;
    const Palette& colors_;
};

float height_of(const CornerLegend& what) {
    float height = 0.0F;
    if (what.legend != nullptr) {
        height += 2.0F * line_em;
        if (what.legend->range) height += bar_em + 0.25F;
    }
    if (what.undecided) height += (what.coarse ? 3.0F : 2.0F) * line_em;
    return em(height - 0.25F + 2.0F * padding_em);
}

std::string height_title(const glm::dvec3& up) {
    const char axis = up.x != 0.0 ? 'x' : up.y != 0.0 ? 'y' : 'z';
    const bool down = up.x + up.y + up.z < 0.0;
    return std::string("height: ") + (down ? "\xE2\x88\x92" : "") + axis;
}

}  // namespace

const char* shown_name(ColorBy by) {
    switch (by) {
        case ColorBy::Plain: return "surface and side";
        case ColorBy::Normal: return "normal";
        case ColorBy::Height: return "height";
        case ColorBy::Depth: return "distance from the eye";
        case ColorBy::MeanCurvature: return "mean curvature";
        case ColorBy::GaussianCurvature: return "Gaussian curvature";
        case ColorBy::Gradient: return "length of the gradient";
        case ColorBy::Expression: return "expression";
    }
    return "";
}

Legend legend_of(const Coloring& coloring, const std::string& expression) {
    Legend legend{shown_name(coloring.by), coloring.by, coloring.map, {}};
    if (has_range(coloring.by)) legend.range = coloring.range;
    if (coloring.by == ColorBy::Height) legend.title = height_title(coloring.up);
    if (coloring.by == ColorBy::Expression) legend.title = expression;
    return legend;
}

void draw_map_bar(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi, ColorMap map) {
    const float width = hi.x - lo.x;
    const int parts = std::max(1, static_cast<int>(std::ceil(width / em(0.25F))));
    for (int i = 0; i < parts; ++i) {
        const auto at = [&](int k) { return static_cast<float>(k) / static_cast<float>(parts); };
        const auto color = [&](int k) {
            return shown_color_at(map, static_cast<double>(k) / parts);
        };
        canvas.AddRectFilledMultiColor(ImVec2(lo.x + at(i) * width, lo.y),
                                       ImVec2(lo.x + at(i + 1) * width, hi.y), color(i),
                                       color(i + 1), color(i + 1), color(i));
    }
}

void draw_mark_swatch(ImDrawList& canvas, const ImVec2& lo, float size, Mark mark,
                      const Palette& colors) {
    const ImVec2 hi(lo.x + size, lo.y + size);
    const bool striped = mark != Mark::UndecidedNotDrawn;
    const std::uint32_t solid = mark == Mark::Coarse ? colors.coarse : colors.undecided;
    const std::uint32_t between = mark == Mark::Coarse ? colors.border : colors.undecided_pale;
    canvas.PushClipRect(lo, hi, true);
    canvas.AddRectFilled(lo, hi, striped ? between : solid);
    const float step = em(0.5F);
    for (float at = step; striped && at < 2.0F * size; at += 2.0F * step) {
        canvas.AddLine(ImVec2(lo.x + at, lo.y - 1.0F), ImVec2(lo.x + at - size - 1.0F, hi.y), solid,
                       0.7F * step);
    }
    canvas.PopClipRect();
}

void draw_corner_legend(ImDrawList& canvas, const ImVec2& corner, const ImVec2& room,
                        const CornerLegend& what, const Palette& colors) {
    if (what.legend == nullptr && !what.undecided) return;
    // It must leave most of a small picture free.
    const float width = std::min(em(width_em + 2.0F * padding_em), 0.62F * room.x);
    const float height = height_of(what);
    if (width < em(9.0F) || height > 0.45F * room.y) return;
    const ImVec2 lo(corner.x - width, corner.y - height);
    canvas.AddRectFilled(lo, corner, colors.card, em(0.5F));
    canvas.AddRect(lo, corner, colors.border, em(0.5F));
    Card card(canvas, ImVec2(lo.x + em(padding_em), lo.y + em(padding_em)),
              width - em(2.0F * padding_em), colors);
    if (what.legend != nullptr) {
        card.title(what.legend->title);
        if (what.legend->range) {
            card.scale(*what.legend->range, what.legend->map);
        } else {
            card.directions();
        }
    }
    if (what.undecided) {
        card.mark(Mark::UndecidedDrawn, "undecided, drawn");
        card.mark(Mark::UndecidedNotDrawn, "undecided, not drawn");
        if (what.coarse) card.mark(Mark::Coarse, "certified, coarse");
    }
}

}  // namespace zeroset::ui
