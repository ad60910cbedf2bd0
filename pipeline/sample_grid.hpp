#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/view/box.hpp"
#include "engine/volume/geometry.hpp"
#include "engine/volume/samples.hpp"

namespace zeroset {

/// A grid whose outermost samples lie on the box's faces.
struct GridPlan {
    Box box;
    GridSize size{};  ///< at least two along each axis
};

/// Where the samples of the plan lie.
Geometry geometry_of(const GridPlan& plan);

/// f at the samples, as float32, NaN where it is not defined: on all cores, by the interpreter in
/// double. `uniforms`: w and the parameters, in the graph's order.
Samples sampled(const Expr& f, const Uniforms& uniforms, const GridPlan& plan);

}  // namespace zeroset
