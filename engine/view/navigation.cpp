#include "engine/view/navigation.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// Direction of the point under `at` on the ball of radius 1/2 about the centre, seen from far
/// along the third axis; beyond 45 degrees a hyperbola continues the ball [Henriksen04].
glm::dvec3 on_ball(const ViewPoint& at) {
    constexpr double squared_radius = 0.25;
    const double squared = at.x * at.x + at.y * at.y;
    const double height = squared < 0.5 * squared_radius
                              ? std::sqrt(squared_radius - squared)
                              : 0.5 * squared_radius / std::sqrt(squared);
    return glm::normalize(glm::dvec3(at.x, at.y, height));
}

/// Rotation from the camera's axes (right, up, towards the eye) to the world's.
glm::dmat3 world_from_camera(const Camera& camera) {
    const ViewFrame frame(camera);
    return {frame.right, frame.up, -frame.forward};
}

/// `camera` turned about the point looked at by a rotation of the world's space.
Camera turned(const Camera& camera, const glm::dquat& turn) {
    const ViewFrame frame(camera);
    Camera result = camera;
    result.eye = camera.look_at - frame.look_distance * glm::normalize(turn * frame.forward);
    result.up = turn * frame.up;
    return result;
}

}  // namespace

glm::dvec3 outward(Side side, const glm::dvec3& up) {
    const glm::dmat3 axes = front_axes(up);
    switch (side) {
        case Side::Front: return -axes[1];
        case Side::Back: return axes[1];
        case Side::Right: return axes[0];
        case Side::Left: return -axes[0];
        case Side::Top: return axes[2];
        case Side::Bottom: return -axes[2];
        case Side::Corner: return glm::normalize(axes[0] - axes[1] + axes[2]);
    }
    return {};
}

Camera seen_from(const Camera& camera, const glm::dvec3& outward, const glm::dvec3& up) {
    const double distance = glm::distance(camera.eye, camera.look_at);
    const double height = glm::dot(glm::normalize(outward), glm::normalize(up));
    const bool from_pole = 1.0 - std::abs(height) < 1e-12;
    Camera moved = camera;
    moved.eye = camera.look_at + distance * glm::normalize(outward);
    moved.up = from_pole ? std::copysign(1.0, height) * front_axes(up)[1] : up;
    return moved;
}

Camera orbit_about(const Camera& camera, const glm::dvec3& up, double yaw_rad, double pitch_rad) {
    constexpr double tilt_rad = 0.01;
    Camera upright = camera;
    upright.up = up;
    if (camera_defect(upright) != nullptr) {
        const ViewFrame frame(camera);
        const double from_above = glm::dot(frame.forward, up) < 0 ? 1.0 : -1.0;
        upright.eye =
            camera.look_at - frame.look_distance * (std::cos(tilt_rad) * frame.forward +
                                                    from_above * std::sin(tilt_rad) * frame.up);
    }
    return orbit(upright, yaw_rad, pitch_rad);
}

Camera roll_ball(const Camera& camera, const ViewPoint& from, const ViewPoint& to) {
    const glm::dvec3 grabbed = on_ball(from);
    const glm::dvec3 released = on_ball(to);
    const glm::dvec3 axis = glm::cross(grabbed, released);
    const double sine = glm::length(axis);
    if (sine == 0) return camera;
    const double angle = std::atan2(sine, glm::dot(grabbed, released));
    // The camera turns opposite to what it shows.
    return turned(camera, glm::angleAxis(-angle, world_from_camera(camera) * (axis / sine)));
}

Camera centred(const Camera& camera, const glm::dvec3& point) {
    const ViewFrame frame(camera);
    const glm::dvec3 drawn = camera.stretch * point;
    const double depth =
        frame.parallel() ? frame.look_distance : glm::dot(drawn - camera.eye, frame.forward);
    if (!(depth > 0)) return camera;
    Camera moved = camera;
    moved.look_at = drawn;
    moved.eye = drawn - depth * frame.forward;
    return camera_defect(moved) == nullptr ? moved : camera;
}

Camera between(const Camera& from, const Camera& to, double part) {
    if (part >= 1.0) return to;
    const glm::dquat start = glm::quat_cast(world_from_camera(from));
    const glm::dquat end = glm::quat_cast(world_from_camera(to));
    const glm::dmat3 axes = glm::mat3_cast(glm::slerp(start, end, part));
    const double near = glm::distance(from.eye, from.look_at);
    const double ratio = glm::distance(to.eye, to.look_at) / near;
    Camera camera = to;
    camera.look_at = glm::mix(from.look_at, to.look_at, part);
    camera.eye = camera.look_at + near * std::pow(ratio, part) * axes[2];
    camera.up = axes[1];
    camera.fov_rad = std::lerp(from.fov_rad, to.fov_rad, part);
    return camera_defect(camera) == nullptr ? camera : to;
}

double shown_height(const Camera& camera) {
    return 2.0 * std::tan(0.5 * camera.fov_rad) * glm::distance(camera.eye, camera.look_at);
}

Camera with_shown_height(const Camera& camera, double height) {
    Camera shows = camera;
    shows.fov_rad = 2.0 * std::atan(0.5 * height / glm::distance(camera.eye, camera.look_at));
    return shows;
}

}  // namespace zeroset
