#pragma once

#include "engine/trace/camera.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace zeroset {

/// Where points of the world show in an image: ViewFrame::point the other way round.
class ImagePlane {
public:
    ImagePlane(const Camera& camera, int width_px, int height_px)
        : view_(camera), width_(width_px), height_(height_px) {}

    /// (u, v, c), affine in the point, which shows u / c to the right and v / c upwards of the
    /// image's centre, in half heights of the image; not at all where c <= 0.
    [[nodiscard]] glm::dvec3 homogeneous(const glm::dvec3& point) const {
        const glm::dvec3 to = point - view_.eye;
        const double along = view_.parallel() ? view_.look_distance : glm::dot(to, view_.forward);
        return {glm::dot(to, view_.right), glm::dot(to, view_.up), view_.half_height * along};
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
        const glm::dvec3 to = point - view_.eye;
        return view_.parallel() ? glm::dot(to, view_.forward) : glm::length(to);
    }

    [[nodiscard]] const ViewFrame& view() const { return view_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

private:
    ViewFrame view_;
    int width_, height_;
};

}  // namespace zeroset
