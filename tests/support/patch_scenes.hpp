#pragma once

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/patch_code.hpp"
#include "engine/taylor/patch_models.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::test {

/// How leaves of parametric surfaces are searched.
enum class Way : std::uint8_t { ByModels, WithoutModels };

/// A surface by the texts of its coordinates, where (x, y) runs over the unit square.
inline Scene patch_scene(const std::array<std::string, 3>& texts, Way way, const Box& clip,
                         const Region& region = {},
                         const std::optional<std::array<double, 6>>& own_box = std::nullopt) {
    std::array<Kernel, 3> point;
    std::array<Expr, 3> graphs;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const auto expr = parse(texts.at(i));
        if (!expr) {
            ADD_FAILURE() << texts.at(i) << ": " << expr.error().reason;
            return {};
        }
        point.at(i) = interpret(*expr);
        point.at(i).has_double = true;
        graphs.at(i) = *expr;
    }
    const auto modeler = way == Way::ByModels ? patch_modeler(graphs) : nullptr;
    Scene scene{{{.kernel = patch_kernel(std::move(point), own_box, modeler)}}, clip, {}};
    scene.region = region;
    scene.uniforms.set(0, 0.0);
    return scene;
}

/// The roots of a function that is quadratic on rays.
inline std::vector<double> quadratic_roots(const Ray& ray, const std::function<double(double)>& f) {
    const double middle = 0.5 * (ray.t_in + ray.t_out);
    const double half = 0.5 * (ray.t_out - ray.t_in);
    const double before = f(ray.t_in);
    const double behind = f(ray.t_out);
    const double c = f(middle);
    const double a = 0.5 * (before + behind) - c;
    const double b = 0.5 * (behind - before);
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return {};
    const double large = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    return {middle + half * large / a, middle + half * c / large};
}

}  // namespace zeroset::test
