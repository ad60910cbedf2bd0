#pragma once

#include "ui/theme.hpp"

#include <glm/ext/vector_double2.hpp>
#include <imgui/imgui.h>

#include <string>

namespace zeroset::ui {

/// The area that a picture fills, window coordinates.
struct PictureArea {
    ImVec2 lo, hi;

    [[nodiscard]] float height() const { return hi.y - lo.y; }
    /// Where a place in heights of the picture from its centre, to the right and upwards, is.
    [[nodiscard]] ImVec2 at(const glm::dvec2& place) const {
        return {0.5F * (lo.x + hi.x) + static_cast<float>(place.x) * height(),
                0.5F * (lo.y + hi.y) - static_cast<float>(place.y) * height()};
    }
    /// The place that is at a point of the window.
    [[nodiscard]] glm::dvec2 place(const ImVec2& p) const {
        return glm::dvec2(p.x - 0.5F * (lo.x + hi.x), 0.5F * (lo.y + hi.y) - p.y) /
               static_cast<double>(height());
    }
    [[nodiscard]] bool holds(const ImVec2& p) const {
        return p.x >= lo.x && p.x < hi.x && p.y >= lo.y && p.y < hi.y;
    }
};

/// A few words `gap` beside a dot in the picture, at the left of it where they would leave the
/// area.
void draw_tag(ImDrawList& canvas, const PictureArea& area, const ImVec2& dot, float gap,
              const std::string& text, float opacity, const Palette& colors);

}  // namespace zeroset::ui
