#pragma once

#include "engine/view/pixel_ray.hpp"
#include "tests/ui/panels.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/screen_areas.hpp"

#include <algorithm>
#include <memory>

namespace zeroset::ui {

/// Layers over the picture under a pointer that presses and drags.
class PictureLayers : public Panels {
protected:
    /// Shows a picture whose pixels all have this depth.
    void show(float distance) {
        Framebuffer frame = disc();
        std::ranges::fill(frame.color, 0xFF808080U);
        std::ranges::fill(frame.depth, distance);
        state_.shown.picture.frame = std::make_shared<const Framebuffer>(frame);
    }
    [[nodiscard]] glm::vec2 at(const glm::dvec3& point) const {
        const auto seen = place_in_view(ViewFrame(state_.shown.picture.camera), point);
        const ImVec2 place = viewport_area(state_.edited.layout).at(seen->place);
        return {place.x, place.y};
    }
    /// Presses at one point of the window and moves to another in steps; the button stays down.
    void drag(const glm::vec2& from, const glm::vec2& to) {
        OffscreenWindow::point(from, false);
        draw_frame();
        for (const float part : {0.0F, 0.4F, 1.0F}) {
            OffscreenWindow::point(from + part * (to - from), true);
            draw_frame();
        }
    }
    void let_go(const glm::vec2& at) {
        OffscreenWindow::point(at, false);
        draw_frame();
        draw_frame();
    }
};

}  // namespace zeroset::ui
