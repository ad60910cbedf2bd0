#pragma once

#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace zeroset {

/// Where points of the world show in an image: ViewFrame::point the other way round.
class ImagePlane {
public:
    ImagePlane(const Camera& camera, int width_px, int height_px)
        : view_(camera), width_(width_px), height_(height_px) {}

    /// As ViewFrame's.
    [[nodiscard]] glm::dvec3 homogeneous(const glm::dvec3& point) const {
        return view_.homogeneous(point);
    }
    /// Column and row of such a place; a pixel's centre is at (i + 0.5, j + 0.5).
    [[nodiscard]] glm::dvec2 pixel(const glm::dvec3& place) const {
        return {0.5 * (width_ + height_ * place.x / place.z),
                0.5 * height_ * (1 - place.y / place.z)};
    }
    [[nodiscard]] std::optional<glm::dvec2> pixel_of(const glm::dvec3& point) const {
        const glm::dvec3 place = homogeneous(point);
        if (!(place.z > 0)) return std::nullopt;
        return pixel(place);
    }
    /// As Framebuffer::depth of a pixel that shows the point.
    [[nodiscard]] double distance(const glm::dvec3& point) const {
        return view_.distance_of(point);
    }

    [[nodiscard]] const ViewFrame& view() const { return view_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

private:
    ViewFrame view_;
    int width_, height_;
};

}  // namespace zeroset
