#include "engine/view/camera.hpp"

#include "engine/base/enum_names.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

constexpr auto projections = enum_names<Projection>("perspective", "orthographic");

}  // namespace

std::string_view name_of(Projection projection) { return projections.of(projection); }

std::optional<Projection> projection_named(std::string_view name) {
    return projections.named(name);
}

ViewFrame::ViewFrame(const Camera& camera)
    : eye(camera.eye),
      forward(glm::normalize(camera.look_at - camera.eye)),
      look_distance(glm::distance(camera.look_at, camera.eye)),
      half_height(std::tan(0.5 * camera.fov_rad)),
      projection(camera.projection),
      stretch(camera.stretch) {
    right = glm::normalize(glm::cross(forward, camera.up));
    up = glm::cross(right, forward);
}

glm::dvec3 ViewFrame::across(const PixelPoint& at, const ImageSize& image) const {
    const double size = pixel_size(image.height);
    const double u = (at.col - 0.5 * image.width) * size;
    const double v = (0.5 * image.height - at.row) * size;
    return u * right + v * up;
}

glm::dvec3 ViewFrame::direction(const PixelPoint& at, const ImageSize& image) const {
    return parallel() ? forward : forward + across(at, image);
}

glm::dvec3 ViewFrame::origin(const PixelPoint& at, const ImageSize& image) const {
    return parallel() ? eye + look_distance * across(at, image) : eye;
}

glm::dvec3 ViewFrame::point(const PixelPoint& at, const ImageSize& image, double distance) const {
    return (origin(at, image) + distance * glm::normalize(direction(at, image))) / stretch;
}

glm::dmat3 front_axes(const glm::dvec3& up) {
    const glm::dvec3 above = glm::normalize(up);
    const glm::dvec3 size = glm::abs(above);
    const bool x_is_up = size.x > size.y && size.x > size.z;
    const glm::dvec3 sideways = x_is_up ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 behind = glm::normalize(glm::cross(above, sideways));
    return {glm::cross(behind, above), behind, above};
}

glm::dvec3 ViewFrame::homogeneous(const glm::dvec3& point) const {
    const glm::dvec3 to = stretch * point - eye;
    const double along = parallel() ? look_distance : glm::dot(to, forward);
    return {glm::dot(to, right), glm::dot(to, up), half_height * along};
}

double ViewFrame::distance_of(const glm::dvec3& point) const {
    const glm::dvec3 to = stretch * point - eye;
    return parallel() ? glm::dot(to, forward) : glm::length(to);
}

Camera default_camera(const Box& box, double aspect, const glm::dvec3& up,
                      const glm::dvec3& stretch) {
    Camera camera;
    camera.stretch = stretch;
    camera.look_at = stretch * box.centre();
    camera.eye = camera.look_at + front_axes(up) * default_view_direction;
    camera.up = up;
    camera.fov_rad = glm::radians(default_fov_deg);
    return framed(camera, box, aspect);
}

Camera framed(const Camera& camera, const Box& box, double aspect) {
    constexpr double margin = 1.04;
    const ViewFrame frame(camera);
    const glm::dvec3 half = 0.5 * camera.stretch * (box.hi - box.lo);
    double distance = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                              (corner & 4) != 0 ? 1 : -1);
        const glm::dvec3 offset = half * sign;
        const double across = std::max(std::abs(glm::dot(offset, frame.right)) / aspect,
                                       std::abs(glm::dot(offset, frame.up)));
        // In perspective, what is nearer shows larger.
        const double nearer = frame.parallel() ? 0.0 : -glm::dot(offset, frame.forward);
        const double needed = margin * across / frame.half_height + nearer;
        distance = std::max(distance, needed);
    }
    Camera moved = camera;
    moved.look_at = camera.stretch * box.centre();
    moved.eye = moved.look_at - distance * frame.forward;
    return moved;
}

Camera suite_camera(double half_edge) {
    Camera camera;
    camera.eye = 4.0 * half_edge * glm::normalize(default_view_direction);
    camera.fov_rad = glm::radians(default_fov_deg);
    return camera;
}

const char* camera_defect(const Camera& camera) {
    const auto finite = [](const glm::dvec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    if (!finite(camera.eye) || !finite(camera.look_at) || !finite(camera.up)) {
        return tr("the camera has a coordinate that is not a finite number");
    }
    const glm::dvec3 view = camera.look_at - camera.eye;
    if (glm::length(view) == 0) return tr("the eye is at the point looked at; move one of them");
    const glm::dvec3 side = glm::cross(view, camera.up);
    if (glm::length(side) <= 1e-9 * glm::length(view) * glm::length(camera.up)) {
        return tr("the up direction is zero or along the view; choose another, for example 0,0,1");
    }
    if (!(camera.fov_rad > 0 && camera.fov_rad < std::numbers::pi)) {
        return tr("the field of view must be above 0 and below 180 degrees");
    }
    return nullptr;
}

Camera orbit(const Camera& camera, double yaw_rad, double pitch_rad) {
    constexpr double pole_margin = 0.01;
    const glm::dvec3 axis = glm::normalize(camera.up);
    const glm::dvec3 offset = camera.eye - camera.look_at;
    const double distance = glm::length(offset);
    const double height = std::clamp(glm::dot(offset, axis) / distance, -1.0, 1.0);
    const double elevation =
        std::clamp(std::asin(height) + pitch_rad, -0.5 * std::numbers::pi + pole_margin,
                   0.5 * std::numbers::pi - pole_margin);
    const ViewFrame frame(camera);
    // Orthogonal to `axis`, towards the eye
    const glm::dvec3 level = glm::normalize(glm::cross(frame.right, axis));
    const glm::dvec3 outward = std::cos(yaw_rad) * level + std::sin(yaw_rad) * frame.right;
    Camera turned = camera;
    turned.eye =
        camera.look_at + distance * (std::cos(elevation) * outward + std::sin(elevation) * axis);
    return turned;
}

Camera pan(const Camera& camera, const ViewShift& by) {
    const ViewFrame frame(camera);
    const double height = 2.0 * frame.half_height * frame.look_distance;
    const glm::dvec3 step = height * (by.x * frame.right + by.y * frame.up);
    Camera moved = camera;
    moved.eye += step;
    moved.look_at += step;
    return moved;
}

Camera zoom(const Camera& camera, double factor, const glm::dvec3& fixed) {
    constexpr double nearest = 0x1p-46;  // relative to the coordinates: at least 64 ulp
    Camera moved = camera;
    const glm::dvec3 drawn = camera.stretch * fixed;
    moved.eye = drawn + factor * (camera.eye - drawn);
    moved.look_at = drawn + factor * (camera.look_at - drawn);
    const double distance = glm::distance(moved.eye, moved.look_at);
    return factor < 1.0 && distance < nearest * glm::length(moved.look_at) ? camera : moved;
}

glm::dvec3 point_under(const Camera& camera, const ViewPoint& cursor,
                       std::optional<double> distance) {
    const ViewFrame frame(camera);
    const PixelPoint at = pixel_point(cursor, unit_image);
    const double at_look = frame.look_distance * glm::length(frame.direction(at, unit_image));
    return frame.point(at, unit_image, distance.value_or(at_look));
}

}  // namespace zeroset
