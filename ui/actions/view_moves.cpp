#include "ui/actions/view_moves.hpp"

#include "engine/view/camera.hpp"
#include "engine/view/navigation.hpp"
#include "ui/model/steering.hpp"
#include "ui/model/ui_state.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <optional>

namespace zeroset::ui {
namespace {

constexpr double step_of_orbit = 1.0 / 12.0;  ///< in heights of the picture: 15 degrees

/// The camera at the end of the move under way; without a move, the current camera.
const Camera& destination(const UiState& state) {
    return state.input.move ? state.input.move->to : *state.edited.document.camera;
}

void step(UiState& state, const PointerMotion& motion) {
    Document& document = state.edited.document;
    if (!document.camera) return;
    document.camera = steer(destination(state), motion, turn_mode_of(document));
    state.input.move.reset();
}

/// Turns the view so that the world's up direction points up in the picture.
void turn_upright(UiState& state) {
    if (!state.edited.document.camera) return;
    const Camera& camera = destination(state);
    move_view(state, seen_from(camera, camera.eye - camera.look_at, state.edited.document.up));
}

}  // namespace

void move_view(UiState& state, const Camera& camera) {
    if (camera_defect(camera) != nullptr) return;
    ++state.input.gesture;  // makes the move an undo step of its own
    const Camera& from = *state.edited.document.camera;
    state.input.move =
        ViewMove{.from = from, .to = camera, .last = from, .elapsed_s = 0.0, .begun = false};
}

void follow_move(UiState& state, double elapsed_s) {
    if (!state.input.move) return;
    ViewMove& move = *state.input.move;
    std::optional<Camera>& camera = state.edited.document.camera;
    if (camera != move.last) return state.input.move.reset();
    // The elapsed time of the first frame does not count: the window may have slept before it.
    move.elapsed_s += move.begun ? elapsed_s : 0.0;
    move.begun = true;
    const double part = std::min(move.elapsed_s / view_move_s, 1.0);
    move.last = between(move.from, move.to, part * part * (3.0 - 2.0 * part));
    camera = move.last;
    if (part >= 1.0) state.input.move.reset();
}

void look_from(UiState& state, const glm::dvec3& outward) {
    if (!state.edited.document.camera) return;
    move_view(state, seen_from(destination(state), outward, state.edited.document.up));
}

bool looks_from(const UiState& state, const glm::dvec3& outward) {
    if (!state.edited.document.camera) return false;
    const Camera& camera = destination(state);
    const Camera moved = seen_from(camera, outward, state.edited.document.up);
    const double turn = glm::distance(moved.eye, camera.eye) + glm::distance(moved.up, camera.up);
    return turn < 1e-9 * glm::distance(camera.eye, camera.look_at);
}

void look_from(UiState& state, Side side) {
    look_from(state, outward(side, state.edited.document.up));
}

void look_from_opposite(UiState& state) {
    if (!state.edited.document.camera) return;
    const Camera& camera = destination(state);
    look_from(state, camera.look_at - camera.eye);
}

void centre_on(UiState& state, const glm::dvec3& point) {
    if (state.edited.document.camera) move_view(state, centred(destination(state), point));
}

void set_up(UiState& state, const glm::dvec3& up) {
    state.edited.document.up = up;
    turn_upright(state);
}

void set_trackball(UiState& state, bool freely) {
    state.edited.document.trackball = freely;
    if (!freely) turn_upright(state);
}

void orbit_step(UiState& state, const glm::ivec2& steps) {
    PointerMotion motion;
    // The picture turns opposite to the eye.
    motion.orbit = {.x = -step_of_orbit * steps.x, .y = -step_of_orbit * steps.y};
    step(state, motion);
}

void zoom_step(UiState& state, double notches) {
    PointerMotion motion;
    motion.wheel = notches;
    step(state, motion);
}

}  // namespace zeroset::ui
