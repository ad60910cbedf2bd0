#include "pipeline/plans/film_plan.hpp"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace zeroset {
namespace {

/// Steps of a turn at which the camera is set back far enough to see the whole box.
constexpr int framing_steps = 72;
/// Steps between two cameras of a path by which its length is measured.
constexpr int path_steps = 256;

glm::dvec3 turned(const glm::dvec3& vector, const Turn& turn, double progress) {
    const double angle = glm::radians(turn.degrees) * progress;
    const glm::dmat4 rotation = glm::rotate(glm::dmat4(1.0), angle, glm::normalize(turn.axis));
    return glm::dvec3(rotation * glm::dvec4(vector, 0.0));
}

Camera turned(const Camera& camera, const Turn& turn, double progress) {
    Camera result = camera;
    result.eye = camera.look_at + turned(camera.eye - camera.look_at, turn, progress);
    result.up = turned(camera.up, turn, progress);
    return result;
}

/// The camera, as far back as the farthest of those that see the whole box on the turn.
Camera framed_for_turn(const Camera& camera, const Turn& turn, const Box& box, double aspect) {
    double distance = 0.0;
    for (int step = 0; step < framing_steps; ++step) {
        const Camera there =
            framed(turned(camera, turn, double(step) / framing_steps), box, aspect);
        distance = std::max(distance, glm::distance(there.eye, there.look_at));
    }
    Camera result = camera;
    result.look_at = 0.5 * (box.lo + box.hi);
    result.eye = result.look_at + distance * glm::normalize(camera.eye - camera.look_at);
    return result;
}

/// A point of the curve by Catmull and Rom between b (t = 0) and c (t = 1).
glm::dvec3 spline(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                  const glm::dvec3& d, double t) {
    const glm::dvec3 leaves = 0.5 * (c - a);
    const glm::dvec3 arrives = 0.5 * (d - b);
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * b + (t3 - 2 * t2 + t) * leaves + (3 * t2 - 2 * t3) * c +
           (t3 - t2) * arrives;
}

/// The camera at a parameter of a path: whole numbers are its cameras.
Camera on_path(const std::vector<Camera>& path, bool closed, double at) {
    const auto count = static_cast<std::ptrdiff_t>(path.size());
    const auto last = closed ? count - 1 : count - 2;
    const auto part =
        std::clamp(static_cast<std::ptrdiff_t>(std::floor(at)), std::ptrdiff_t{0}, last);
    const double t = at - static_cast<double>(part);
    const auto camera = [&](std::ptrdiff_t i) -> const Camera& {
        const std::ptrdiff_t index = part + i;
        return path[static_cast<std::size_t>(
            closed ? (index + count) % count : std::clamp(index, std::ptrdiff_t{0}, count - 1))];
    };
    Camera result = camera(t < 0.5 ? 0 : 1);
    const auto point = [&](glm::dvec3 Camera::* member) {
        return spline(camera(-1).*member, camera(0).*member, camera(1).*member, camera(2).*member,
                      t);
    };
    result.eye = point(&Camera::eye);
    result.look_at = point(&Camera::look_at);
    result.up = point(&Camera::up);
    result.fov_rad = std::lerp(camera(0).fov_rad, camera(1).fov_rad, t);
    return result;
}

/// How far apart two cameras of a path are, for its speed.
double distance(const Camera& a, const Camera& b) {
    return glm::distance(a.eye, b.eye) + glm::distance(a.look_at, b.look_at);
}

double path_length(const FilmPlan& plan) {
    const bool closed = plan.end == FilmEnd::Loop;
    return static_cast<double>(closed ? plan.path.size() : plan.path.size() - 1);
}

/// The way at equal steps of the parameter.
std::vector<double> way_along(const FilmPlan& plan) {
    if (plan.path.size() < 2) return {};
    const bool closed = plan.end == FilmEnd::Loop;
    const int steps = path_steps * static_cast<int>(path_length(plan));
    std::vector<double> way{0.0};
    for (int step = 1; step <= steps; ++step) {
        const double at = double(step) / path_steps;
        const Camera before = on_path(plan.path, closed, at - 1.0 / path_steps);
        way.push_back(way.back() + distance(before, on_path(plan.path, closed, at)));
    }
    return way;
}

/// The parameter of a path where this part of the whole way is behind.
double parameter_at(const std::vector<double>& way, double part) {
    const double wanted = part * way.back();
    const auto above = std::ranges::upper_bound(way, wanted);
    if (above == way.end()) return static_cast<double>(way.size() - 1) / path_steps;
    const auto index = static_cast<std::size_t>(above - way.begin());
    const double step = way[index] - way[index - 1];
    const double beyond = step > 0 ? (wanted - way[index - 1]) / step : 0.0;
    return (static_cast<double>(index - 1) + beyond) / path_steps;
}

double eased(double progress, Easing easing) {
    return easing == Easing::Smooth ? progress * progress * (3 - 2 * progress) : progress;
}

}  // namespace

double progress_at(const FilmPlan& plan, double frame) {
    const double frames = plan.frames;
    switch (plan.end) {
        case FilmEnd::Stop:
            return eased(frames > 1 ? std::clamp(frame / (frames - 1), 0.0, 1.0) : 0.0,
                         plan.easing);
        case FilmEnd::Loop: {
            const double part = frame / frames;
            return eased(part - std::floor(part), plan.easing);
        }
        case FilmEnd::Bounce: {
            // The way back has the numbers of the way there, to the last bit.
            const double place = frame - frames * std::floor(frame / frames);
            return eased(2 * std::min(place, frames - place) / frames, plan.easing);
        }
    }
    return 0.0;
}

std::vector<double> moments_of(const FilmPlan& plan, int frame) {
    if (plan.blur <= 1) return {static_cast<double>(frame)};
    std::vector<double> moments;
    for (int i = 0; i < plan.blur; ++i) {
        const double place = (i + 0.5) / plan.blur - 0.5;
        moments.push_back(frame + plan.shutter * place);
    }
    return moments;
}

FilmScript::FilmScript(FilmPlan plan, Document document, double aspect)
    : plan_(std::move(plan)),
      document_(std::move(document)),
      first_(document_.camera.value_or(default_camera(document_.clip, aspect, document_.up))),
      way_(way_along(plan_)) {
    if (!document_.camera && plan_.turn)
        first_ = framed_for_turn(first_, *plan_.turn, document_.clip, aspect);
}

Camera FilmScript::camera_at(double progress) const {
    Camera camera = first_;
    if (!way_.empty()) {
        const bool closed = plan_.end == FilmEnd::Loop;
        camera = on_path(plan_.path, closed, parameter_at(way_, progress));
    }
    return plan_.turn ? turned(camera, *plan_.turn, progress) : camera;
}

Document FilmScript::document_at(double frame) const {
    const double progress = progress_at(plan_, frame);
    Document document = document_;
    document.camera = camera_at(progress);
    for (const Sweep& sweep : plan_.sweeps) {
        Slider& slider = sweep.name == "w" ? document.w : document.parameters[sweep.name];
        set_value(slider, std::lerp(sweep.from, sweep.to, progress));
    }
    return document;
}

}  // namespace zeroset
