#pragma once

#include "engine/expr/expr.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/kernel/surface_facts.hpp"
#include "engine/rewrite/surface_functions.hpp"
#include "engine/scene/scene.hpp"
#include "engine/volume/volume.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

// Scenes of one volume, made without a file.

namespace zeroset::test {

/// A volume of the numbers that `value(i, j, k)` gives.
template <class Value>
std::shared_ptr<const Volume> volume_from(const GridSize& size, const Geometry& place,
                                          const Value& value, const VolumeOptions& options = {}) {
    const auto numbers = std::make_shared<std::vector<float>>();
    for (std::uint64_t k = 0; k < size[2]; ++k) {
        for (std::uint64_t j = 0; j < size[1]; ++j) {
            for (std::uint64_t i = 0; i < size[0]; ++i)
                numbers->push_back(static_cast<float>(
                    value(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k))));
        }
    }
    const auto data =
        VolumeData::make({.type = SampleType::Float,
                          .size = size,
                          .data = std::shared_ptr<const void>(numbers, numbers->data())},
                         place);
    return Volume::make(data.value(), options, "volume(\"test\")");
}

/// volume(x, y, z) - level.
inline Expr level_set(std::shared_ptr<const Volume> volume, double level) {
    ExprBuilder nodes;
    const NodeId field =
        nodes.look_up(std::move(volume), nodes.variable(0), nodes.variable(1), nodes.variable(2));
    return nodes.finish(nodes.apply(Op::Subtract, field, nodes.constant(level)));
}

/// The kernel of a formula with what the pipeline adds to it.
inline Kernel kernel_with_level(const Expr& f) {
    Kernel kernel = interpret(f);
    if (const auto is = level_of_field(f)) {
        kernel.facts = std::make_shared<const SurfaceFacts>(SurfaceFacts{
            .field = {.field = is->field, .level = interpret(is->level).in_double.range}});
    }
    return kernel;
}

/// The box about a volume.
inline Box box_of(const Volume& volume) {
    const auto bounds = volume.data().bounds();
    return {{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
}

inline Scene scene_of_level(const std::shared_ptr<const Volume>& volume, double level) {
    Scene scene{{{.kernel = kernel_with_level(level_set(volume, level))}}, box_of(*volume), {}};
    scene.uniforms.set(0, 0.0);
    return scene;
}

}  // namespace zeroset::test
