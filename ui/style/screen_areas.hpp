#pragma once

#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double2.hpp>
#include <imgui/imgui.h>

// How the window is divided. Lengths in window coordinates.

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

/// The side panel is at least so wide, and takes at most this part of the window.
inline constexpr float narrowest_em = 17.0F;
inline constexpr float most_of_window = 0.6F;

/// Width of the side panel; 0 when it is folded.
float side_panel_width(const UiState& state);

/// Height of the line along the window's bottom.
float status_bar_height();

/// Height of what the status line leaves of the window.
float picture_height();

/// The area that the picture fills: what the panels leave of the window.
PictureArea viewport_area(const UiState& state);

}  // namespace zeroset::ui
