#include "document/import/pov_camera.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

/// How the scene's coordinates are turned for a camera: `right`, `up` and `direction` before it
/// looks at its target.
PovAxes axes_for(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& direction,
                 const glm::dvec3& sky) {
    if (!(glm::dot(glm::cross(up, direction), right) < 0.0)) return PovAxes::LeftHanded;
    const bool z_is_up = std::abs(sky.z) > std::max(std::abs(sky.x), std::abs(sky.y));
    return z_is_up ? PovAxes::RightHandedZUp : PovAxes::RightHanded;
}

}  // namespace

Placement placement_of(PovAxes axes) {
    Placement result;
    if (axes == PovAxes::LeftHanded) result.linear = glm::dmat3(1, 0, 0, 0, 0, 1, 0, 1, 0);
    if (axes == PovAxes::RightHanded) result.linear = glm::dmat3(1, 0, 0, 0, 0, 1, 0, -1, 0);
    return result;
}

std::optional<PovCamera> read_pov_camera(PovScript& script, PovModifiers& modifiers,
                                         ImportedDocument& result) {
    if (!script.take_sign("{")) return std::nullopt;
    const std::size_t line = script.line();
    glm::dvec3 eye(0.0), target(0.0, 0.0, 1.0), sky(0.0, 1.0, 0.0), right(4.0 / 3.0, 0.0, 0.0),
        up(0.0, 1.0, 0.0), direction(0.0, 0.0, 1.0);
    std::optional<double> angle;  // across the picture's width
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
        take("direction", direction);
        if (word.text == "angle") angle = modifiers.number(word);
        if (word.text == "orthographic") parallel = true;
        if (script.at_sign("{")) script.skip_block();
    }
    const double usual = 0.5 * glm::length(right) / glm::length(direction);
    const double half = angle ? std::tan(std::clamp(*angle, 0.1, 170.0) * std::numbers::pi / 360.0)
                              : (usual > 0.0 && usual < 1e3 ? usual : 2.0 / 3.0);
    const double ratio = glm::length(right) > 0.0 ? glm::length(up) / glm::length(right) : 1.0;
    const PovAxes axes = axes_for(right, up, direction, sky);
    const Placement here = placement_of(axes);
    const Camera camera{
        .eye = here.of(placement.of(eye)),
        .look_at = here.of(placement.of(target)),
        .up = here.linear * (placement.linear * sky),
        .fov_rad = 2.0 * std::atan(half * ratio),
        .projection = parallel ? Projection::Orthographic : Projection::Perspective};
    if (camera_defect(camera) == nullptr) return PovCamera{.camera = camera, .axes = axes};
    result.note(line, "camera", tr("it cannot see anything; it is left out"));
    return std::nullopt;
}

}  // namespace zeroset
