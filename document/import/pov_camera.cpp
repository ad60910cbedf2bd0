#include "document/import/pov_camera.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

/// (x, y, z) of POV-Ray here, and back.
glm::dvec3 swapped(const glm::dvec3& v) { return {v.x, v.z, v.y}; }

}  // namespace

std::optional<Camera> read_pov_camera(PovScript& script, PovModifiers& modifiers,
                                      ImportedDocument& result) {
    if (!script.take_sign("{")) return std::nullopt;
    const std::size_t line = script.line();
    glm::dvec3 eye(0.0), target(0.0, 0.0, 1.0), sky(0.0, 1.0, 0.0), right(4.0 / 3.0, 0.0, 0.0),
        up(0.0, 1.0, 0.0);
    double angle = 67.380135;
    bool parallel = false;
    Placement placement;
    while (!script.take_sign("}") && script.peek().kind != ScriptKind::End) {
        if (const auto step = modifiers.transformation()) {
            placement = placement.then(*step);
            continue;
        }
        const ScriptToken word = script.next();
        const auto take = [&](std::string_view name, glm::dvec3& into) {
            if (word.text != name) return;
            if (const auto value = modifiers.vector(word)) into = *value;
        };
        take("location", eye);
        take("look_at", target);
        take("sky", sky);
        take("right", right);
        take("up", up);
        if (word.text == "angle") angle = modifiers.number(word).value_or(angle);
        if (word.text == "orthographic") parallel = true;
        if (script.at_sign("{")) script.skip_block();
    }
    const double half = std::tan(std::clamp(angle, 0.1, 170.0) * std::numbers::pi / 360.0);
    const double ratio = glm::length(right) > 0.0 ? glm::length(up) / glm::length(right) : 1.0;
    const Camera camera{
        .eye = swapped(placement.of(eye)),
        .look_at = swapped(placement.of(target)),
        .up = swapped(placement.linear * sky),
        .fov_rad = 2.0 * std::atan(half * ratio),
        .projection = parallel ? Projection::Orthographic : Projection::Perspective};
    if (camera_defect(camera) == nullptr) return camera;
    result.note(line, "camera", tr("it cannot see anything; it is left out"));
    return std::nullopt;
}

}  // namespace zeroset
