#define GLM_ENABLE_EXPERIMENTAL  // for squad
#include "pipeline/plans/camera_path.hpp"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace zeroset {
namespace {

/// Steps between two cameras by which the way's length is measured.
constexpr int steps_between = 256;
/// Steepest view from above or below of a path that keeps what is up, radians.
constexpr double steepest_rad = 0.5 * std::numbers::pi - 0.01;

template <class Value>
using Four = std::array<Value, 4>;

/// A point of the curve by Catmull and Rom between the second (t = 0) and the third (t = 1).
template <class Value>
Value spline(const Four<Value>& p, double t) {
    const Value leaves = 0.5 * (p[2] - p[0]);
    const Value arrives = 0.5 * (p[3] - p[1]);
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * p[1] + (t3 - 2 * t2 + t) * leaves + (3 * t2 - 2 * t3) * p[2] +
           (t3 - t2) * arrives;
}

template <class Function>
auto of_each(const Four<Camera>& cameras, const Function& function) {
    return Four<decltype(function(cameras[0]))>{function(cameras[0]), function(cameras[1]),
                                                function(cameras[2]), function(cameras[3])};
}

/// The angles, each by less than half a turn from the one before.
Four<double> unwound(Four<double> angles) {
    for (std::size_t i = 1; i < angles.size(); ++i)
        angles[i] = angles[i - 1] + std::remainder(angles[i] - angles[i - 1], 2 * std::numbers::pi);
    return angles;
}

/// The direction from the point looked at to the eye, about the direction that is up in all.
glm::dvec3 upright_direction(const Four<Camera>& cameras, double t) {
    const glm::dmat3 axes = front_axes(cameras[1].up);
    const auto along = [&axes](const Camera& camera) {
        return glm::normalize((camera.eye - camera.look_at) * axes);
    };
    const double azimuth = spline(unwound(of_each(cameras,
                                                  [&](const Camera& camera) {
                                                      const glm::dvec3 d = along(camera);
                                                      return std::atan2(d.y, d.x);
                                                  })),
                                  t);
    const double elevation = std::clamp(
        spline(of_each(cameras, [&](const Camera& camera) { return std::asin(along(camera).z); }),
               t),
        -steepest_rad, steepest_rad);
    return axes * glm::dvec3(std::cos(elevation) * std::cos(azimuth),
                             std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
}

/// The turn from the world's axes to the camera's: to the right, up and backwards.
glm::dquat orientation(const Camera& camera) {
    const ViewFrame view(camera);
    return glm::quat_cast(glm::dmat3(view.right, view.up, -view.forward));
}

glm::dquat between_orientations(const Four<Camera>& cameras, double t) {
    Four<glm::dquat> q = of_each(cameras, orientation);
    for (std::size_t i = 1; i < q.size(); ++i) {
        if (glm::dot(q[i - 1], q[i]) < 0) q[i] = -q[i];
    }
    return glm::normalize(glm::squad(q[1], q[2], glm::intermediate(q[0], q[1], q[2]),
                                     glm::intermediate(q[1], q[2], q[3]), t));
}

bool same_direction(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::distance(glm::normalize(a), glm::normalize(b)) < 1e-9;
}

/// How far two cameras that are near each other are apart: about as far as what they show moves.
double distance(const Camera& a, const Camera& b) {
    const ViewFrame from(a);
    const ViewFrame to(b);
    const double moves = glm::distance(a.eye, b.eye) + glm::distance(a.look_at, b.look_at);
    const double rolls = std::abs(glm::dot(from.right, to.up));
    const double zooms = std::abs(to.half_height - from.half_height);
    return std::max(moves, from.look_distance * std::max(rolls, zooms));
}

}  // namespace

CameraPath::CameraPath(std::vector<Camera> through, bool closed)
    : through_(std::move(through)), closed_(closed) {
    if (through_.empty()) return;
    upright_ = std::ranges::all_of(through_, [this](const Camera& camera) {
        return same_direction(camera.up, through_.front().up);
    });
    const auto parts = static_cast<int>(through_.size()) - (closed_ ? 0 : 1);
    way_.push_back(0.0);
    Camera before = between(0.0);
    for (int step = 1; step <= parts * steps_between; ++step) {
        const Camera there = between(double(step) / steps_between);
        way_.push_back(way_.back() + distance(before, there));
        before = there;
    }
}

const Camera& CameraPath::camera(int index) const {
    const auto count = static_cast<int>(through_.size());
    return through_[static_cast<std::size_t>(closed_ ? (index + count) % count
                                                     : std::clamp(index, 0, count - 1))];
}

Camera CameraPath::between(double parameter) const {
    const auto count = static_cast<int>(through_.size());
    const int part =
        std::clamp(static_cast<int>(std::floor(parameter)), 0, closed_ ? count - 1 : count - 2);
    const double t = parameter - part;
    const Four<Camera> near{camera(part - 1), camera(part), camera(part + 1), camera(part + 2)};
    Camera result = near[t < 0.5 ? 1 : 2];
    result.look_at = spline(of_each(near, [](const Camera& view) { return view.look_at; }), t);
    result.fov_rad = std::lerp(near[1].fov_rad, near[2].fov_rad, t);
    const double far = std::exp(spline(
        of_each(near,
                [](const Camera& view) { return std::log(glm::distance(view.eye, view.look_at)); }),
        t));
    if (upright_) {
        result.eye = result.look_at + far * upright_direction(near, t);
        return result;
    }
    const glm::dquat turned = between_orientations(near, t);
    result.up = turned * glm::dvec3(0, 1, 0);
    result.eye = result.look_at + far * (turned * glm::dvec3(0, 0, 1));
    return result;
}

Camera CameraPath::at(double part) const {
    const double wanted = part * way_.back();
    const auto above = std::ranges::upper_bound(way_, wanted);
    if (above == way_.end()) return between(static_cast<double>(way_.size() - 1) / steps_between);
    const auto index = static_cast<std::size_t>(above - way_.begin());
    const double step = way_[index] - way_[index - 1];
    const double beyond = step > 0 ? (wanted - way_[index - 1]) / step : 0.0;
    return between((static_cast<double>(index - 1) + beyond) / steps_between);
}

}  // namespace zeroset
