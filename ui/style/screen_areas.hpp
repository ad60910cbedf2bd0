#pragma once

#include "engine/view/image_point.hpp"
#include "ui/model/edited.hpp"

#include <imgui/imgui.h>

// The areas that the window is divided into. All lengths are in window coordinates.

namespace zeroset::ui {

/// The rectangle that a picture fills, in window coordinates.
struct PictureArea {
    ImVec2 lo, hi;

    [[nodiscard]] float height() const { return hi.y - lo.y; }
    /// Returns the point of the window at a place of the picture.
    [[nodiscard]] ImVec2 at(const ViewPoint& place) const {
        return {0.5F * (lo.x + hi.x) + static_cast<float>(place.x) * height(),
                0.5F * (lo.y + hi.y) - static_cast<float>(place.y) * height()};
    }
    /// Returns the place in the picture of a point of the window.
    [[nodiscard]] ViewPoint place(const ImVec2& p) const {
        const auto unit = static_cast<double>(height());
        return {.x = static_cast<double>(p.x - 0.5F * (lo.x + hi.x)) / unit,
                .y = static_cast<double>(0.5F * (lo.y + hi.y) - p.y) / unit};
    }
    [[nodiscard]] bool holds(const ImVec2& p) const {
        return p.x >= lo.x && p.x < hi.x && p.y >= lo.y && p.y < hi.y;
    }
};

/// Least width of the side panel in em, and the largest part of the window's width that it takes.
/// The least width wins where they conflict.
inline constexpr float narrowest_em = 17.0F;
inline constexpr float most_of_window = 0.6F;

/// Width of the side panel in window coordinates; 0 when it is folded, and in a presentation.
float side_panel_width(const Layout& layout);

/// Height of the status line along the window's bottom.
float status_bar_height();

/// Height of the window without the status line; in a presentation there is none.
float picture_height(const Layout& layout);

/// The area of the picture: the window without the side panel and the status line.
PictureArea viewport_area(const Layout& layout);

}  // namespace zeroset::ui
