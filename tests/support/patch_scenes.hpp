#pragma once

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/patch_code.hpp"
#include "engine/taylor/patch_models.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

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
    Scene scene{{patch_kernel(std::move(point), own_box, modeler)}, clip, {}};
    scene.region = region;
    scene.uniforms.set(0, 0.0);
    return scene;
}

}  // namespace zeroset::test
