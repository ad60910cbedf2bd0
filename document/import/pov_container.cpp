#include "document/import/pov_container.hpp"

#include "engine/base/translation.hpp"

#include <array>
#include <cmath>

namespace zeroset {
namespace {

PovContainer ball_of(const glm::dvec3& centre, double radius) {
    return {.ball = true, .centre = centre, .radius = std::abs(radius)};
}

PovContainer box_between(const glm::dvec3& a, const glm::dvec3& b) {
    return {.lo = glm::min(a, b), .hi = glm::max(a, b)};
}

}  // namespace

PovContainer PovContainers::read() {
    script_.take_sign("{");
    const ScriptToken word = script_.peek();
    const auto known = declared_.find(word.text);
    std::optional<PovContainer> container;
    if (known != declared_.end()) {
        script_.next();
        container = known->second;
    } else {
        container = shape();
    }
    if (!container)
        result_.note(
            word.line, "contained_by " + std::string(word.text.substr(0, 60)),
            tr("a container is a sphere or a box; a box from -1 to 1 stands in its place"));
    script_.skip_rest_of_block();
    return container.value_or(PovContainer{});
}

/// Reads "sphere { ... }" or "box { ... }"; nothing where another shape, or none, is next.
std::optional<PovContainer> PovContainers::shape() {
    const ScriptToken word = script_.peek();
    const bool ball = word.text == "sphere";
    if (word.kind != ScriptKind::Name || (!ball && word.text != "box")) return std::nullopt;
    if (!script_.sign_follows("{")) return std::nullopt;
    script_.next();
    script_.take_sign("{");
    const auto first = modifiers_.vector(word);
    script_.take_sign(",");
    std::optional<PovContainer> result;
    if (ball) {
        const auto radius = modifiers_.number(word);
        if (first && radius && *radius != 0.0) result = ball_of(*first, *radius);
    } else {
        const auto second = modifiers_.vector(word);
        if (first && second) result = box_between(*first, *second);
    }
    script_.skip_rest_of_block();
    return result;
}

bool PovContainers::declare(const std::string& name) {
    const bool is_shape = script_.at_name("sphere") || script_.at_name("box");
    if (!is_shape || !script_.sign_follows("{")) return false;
    if (const auto container = shape()) declared_.insert_or_assign(name, *container);
    return true;
}

std::string inside_formula(const PovContainer& container) {
    constexpr std::array letters{"x", "y", "z"};
    const auto moved = [&](int axis, double by) {
        std::string letter = letters[static_cast<std::size_t>(axis)];
        if (by == 0.0) return letter;
        return letter + (by < 0.0 ? " + " : " - ") + exact_number(std::abs(by));
    };
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        if (container.ball) {
            const std::string part = moved(axis, container.centre[axis]);
            text += (axis > 0 ? " + " : "") + (part.size() > 1 ? "(" + part + ")" : part) + "^2";
            continue;
        }
        const double centre = 0.5 * (container.lo[axis] + container.hi[axis]);
        const double half = 0.5 * (container.hi[axis] - container.lo[axis]);
        text += (axis > 0 ? ", " : "") + ("abs(" + moved(axis, centre)) + ") - " +
                exact_number(half, true);
    }
    return container.ball ? text + " - " + exact_number(container.radius * container.radius) : text;
}

Box box_of(const PovContainer& container, const Placement& placed) {
    const glm::dvec3 lo = container.ball ? container.centre - container.radius : container.lo;
    const glm::dvec3 hi = container.ball ? container.centre + container.radius : container.hi;
    Box box{.lo = placed.of(lo), .hi = placed.of(lo)};
    for (int corner = 1; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? hi.x : lo.x, (corner & 2) != 0 ? hi.y : lo.y,
                            (corner & 4) != 0 ? hi.z : lo.z);
        box.lo = glm::min(box.lo, placed.of(at));
        box.hi = glm::max(box.hi, placed.of(at));
    }
    return box;
}

}  // namespace zeroset
