#pragma once

#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace zeroset {

/// Projection of points of the world into an image in pixels, the inverse of ViewFrame::point.
class ImagePlane {
public:
    ImagePlane(const Camera& camera, const ImageSize& image) : view_(camera), image_(image) {}

    /// Place of a point as of ViewFrame::homogeneous.
    [[nodiscard]] glm::dvec3 homogeneous(const glm::dvec3& point) const {
        return view_.homogeneous(point);
    }
    /// Column and row of a place from homogeneous; a pixel's centre is at (i + 0.5, j + 0.5).
    [[nodiscard]] glm::dvec2 pixel(const glm::dvec3& place) const {
        return {0.5 * (image_.width + image_.height * place.x / place.z),
                0.5 * image_.height * (1 - place.y / place.z)};
    }
    [[nodiscard]] std::optional<glm::dvec2> pixel_of(const glm::dvec3& point) const {
        const glm::dvec3 place = homogeneous(point);
        if (!(place.z > 0)) return std::nullopt;
        return pixel(place);
    }
    /// Distance of the point along its ray, as in Framebuffer::depth.
    [[nodiscard]] double distance(const glm::dvec3& point) const {
        return view_.distance_of(point);
    }

    [[nodiscard]] const ViewFrame& view() const { return view_; }
    [[nodiscard]] const ImageSize& image() const { return image_; }

private:
    ViewFrame view_;
    ImageSize image_;
};

}  // namespace zeroset
