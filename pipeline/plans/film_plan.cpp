#include "pipeline/plans/film_plan.hpp"

#include "document/framing.hpp"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

/// Steps of a turn at which the camera is set back far enough to see the whole box.
constexpr int framing_steps = 72;

glm::dvec3 turned(const glm::dvec3& vector, const CameraTurn& turn, double progress) {
    const double angle = glm::radians(turn.degrees) * progress;
    const glm::dmat4 rotation = glm::rotate(glm::dmat4(1.0), angle, glm::normalize(turn.axis));
    return glm::dvec3(rotation * glm::dvec4(vector, 0.0));
}

Camera turned(const Camera& camera, const CameraTurn& turn, double progress) {
    Camera result = camera;
    result.eye = camera.look_at + turned(camera.eye - camera.look_at, turn, progress);
    result.up = turned(camera.up, turn, progress);
    return result;
}

/// The camera, as far back as the farthest of those that see the whole box on the turn.
Camera framed_for_turn(const Camera& camera, const CameraTurn& turn, const Box& box,
                       double aspect) {
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
      first_(camera_of(document_, aspect)),
      path_(plan_.path, plan_.end == FilmEnd::Loop) {
    if (!document_.camera && plan_.turn)
        first_ = framed_for_turn(first_, *plan_.turn, box_in_view(document_), aspect);
}

Camera FilmScript::camera_at(double progress) const {
    const Camera camera = path_.empty() ? first_ : path_.at(progress);
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
