#include "engine/draw/shown_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

/// How far beside a curve its two sides are looked at, in parts of the clip box.
constexpr double side_part = 1e-6;
/// How far from a surface a point of it may be, in parts of the clip box.
constexpr double zero_slack = 1e-8;

/// The surface's function at a point.
ValueAndGradient surface_at(const Scene& scene, std::size_t surface, const glm::dvec3& point) {
    return value_at(scene.surfaces[surface].kernel, scene.uniforms, point);
}

/// Points beside the border: where it is above 0 and where it is below.
struct Sides {
    glm::dvec3 above, below;
};

Sides sides_of(const Kernel& border, const Scene& scene, const glm::dvec3& point) {
    const glm::dvec3 gradient = value_at(border, scene.uniforms, point).gradient;
    const glm::dvec3 step = side_part * scene.clip.size() * glm::normalize(gradient);
    return {.above = point + step, .below = point - step};
}

/// How much a continuous function may change between the sides, to first order with some room.
double most_change(const ValueAndGradient& above, const ValueAndGradient& below,
                   const Scene& scene) {
    constexpr double slack = 8.0;
    const double steepness = std::max(glm::length(above.gradient), glm::length(below.gradient));
    return slack * side_part * scene.clip.size() * steepness;
}

double larger_side(const ValueAndGradient& above, const ValueAndGradient& below) {
    return std::max(std::abs(above.value), std::abs(below.value));
}

}  // namespace

ShownAt where_piece_counts(const Scene& scene, std::size_t surface, const Expr& piece,
                           const KernelMaker& make_kernel) {
    return [&scene, surface, code = make_kernel(piece)](const CurvePoint& point) {
        const glm::dvec3 steepness = value_at(code, scene.uniforms, point.place).gradient;
        const double f = surface_at(scene, surface, point.place).value;
        return std::abs(f) <= zero_slack * scene.clip.size() * glm::length(steepness);
    };
}

ShownAt where_defined(const Scene& scene, std::size_t surface) {
    return [&scene, surface](const CurvePoint& point) {
        return !std::isnan(surface_at(scene, surface, point.place).value);
    };
}

// Across the curve the piece is a quadratic form to second order. A definite one vanishes on the
// curve only.
ShownAt where_branches_meet(const Scene& scene, const Expr& piece, const KernelMaker& make_kernel) {
    return [&scene, code = make_kernel(piece)](const CurvePoint& point) {
        constexpr double step_part = 1e-5;
        constexpr double least_part = 1e-3;  // of the larger curvature, for the form to be definite
        const double step = step_part * scene.clip.size();
        const auto change = [&](const glm::dvec3& along) {
            const glm::dvec3 ahead = point.place + step * along;
            const glm::dvec3 behind = point.place - step * along;
            return value_at(code, scene.uniforms, ahead).gradient -
                   value_at(code, scene.uniforms, behind).gradient;
        };
        const glm::dvec3 any =
            std::abs(point.tangent.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(point.tangent, any));
        const glm::dvec3 v = glm::cross(point.tangent, u);
        const glm::dvec3 change_u = change(u);
        const double uu = glm::dot(u, change_u);
        const double uv = glm::dot(v, change_u);
        const double vv = glm::dot(v, change(v));
        const double size = uu * uu + 2.0 * uv * uv + vv * vv;
        return !(uu * vv - uv * uv > least_part * size);
    };
}

ShownAt where_edge(const Scene& scene, std::size_t surface, const Expr& whole, const Expr& border,
                   const KernelMaker& make_kernel) {
    return [&scene, surface, code = make_kernel(whole),
            border_code = make_kernel(border)](const CurvePoint& point) {
        constexpr double least_sine = 1e-3;
        const Sides sides = sides_of(border_code, scene, point.place);
        const ValueAndGradient above = value_at(code, scene.uniforms, sides.above);
        const ValueAndGradient below = value_at(code, scene.uniforms, sides.below);
        const glm::dvec3& a = above.gradient;
        const glm::dvec3& b = below.gradient;
        const double steepness = std::max(glm::length(a), glm::length(b));
        const double f = surface_at(scene, surface, point.place).value;
        return std::abs(f) <= zero_slack * scene.clip.size() * steepness &&
               larger_side(above, below) <= most_change(above, below, scene) &&
               glm::length(glm::cross(a, b)) > least_sine * glm::length(a) * glm::length(b);
    };
}

ShownAt where_jump(const Scene& scene, std::size_t surface, const Expr& border,
                   const KernelMaker& make_kernel) {
    return [&scene, surface, border_code = make_kernel(border)](const CurvePoint& point) {
        const Sides sides = sides_of(border_code, scene, point.place);
        const ValueAndGradient above = surface_at(scene, surface, sides.above);
        const ValueAndGradient below = surface_at(scene, surface, sides.below);
        const double change = most_change(above, below, scene);
        return std::min(std::abs(above.value), std::abs(below.value)) <= change &&
               larger_side(above, below) > change;
    };
}

ShownAt where_end(const Scene& scene, std::size_t surface, const Expr& border,
                  const KernelMaker& make_kernel) {
    return [&scene, surface, border_code = make_kernel(border)](const CurvePoint& point) {
        const Sides sides = sides_of(border_code, scene, point.place);
        const bool above = std::isnan(surface_at(scene, surface, sides.above).value);
        const bool below = std::isnan(surface_at(scene, surface, sides.below).value);
        return above != below;
    };
}

}  // namespace zeroset
