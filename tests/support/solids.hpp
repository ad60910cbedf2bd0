#pragma once

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/mesh/solid.hpp"
#include "engine/rewrite/differences/derivatives.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace zeroset::test {

/// The points of a box where all these texts, f or f = 0, are <= 0; by the interpreter.
inline MeshSolid solid_of(const std::vector<std::string>& texts, const Box& box) {
    MeshSolid solid;
    solid.box = box;
    solid.cuts = cuts_of(box, {});
    solid.uniforms.set(0, 0.0);
    solid.surface_parts = texts.size();
    for (const std::string& text : texts) {
        const auto f = parse(text);
        if (!f) {
            ADD_FAILURE() << text;
            return solid;
        }
        const Kernel kernel = interpret(*f);
        SolidPart part{.range = kernel.in_double.range,
                       .gradient = {},
                       .value = kernel.in_double.value,
                       .branches = kernel.branches};
        const std::array<Expr, 3> slopes = gradient_of(*f);
        for (std::size_t axis = 0; axis < 3; ++axis)
            part.gradient[axis] = interpret(slopes[axis]).in_double.range;
        solid.parts.push_back(std::move(part));
        const auto own = static_cast<std::uint32_t>(solid.parts.size() - 1);
        const std::uint32_t leaf = solid.add({.a = own});
        if (own > 0) solid.add({.kind = SolidNode::Kind::Max, .a = leaf - 1, .b = leaf});
    }
    return solid;
}

/// The ball of radius 1 in [-2, 2]^3.
inline MeshSolid unit_ball() { return solid_of({"x^2 + y^2 + z^2 - 1"}, Box::cube(2)); }

}  // namespace zeroset::test
