#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/volume/samples.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/sample_grid.hpp"

#include <cstdint>

namespace zeroset {

/// Signed distances at the samples of a grid.
struct DistanceGrid {
    Samples samples;             ///< as float32; below 0 where f is
    std::uint64_t unproved = 0;  ///< samples that may be off by more than the tolerance
    double worst = 0;            ///< by how much those may be off; infinite: not known
};

/// The distance from each sample of the plan to the nearest zero of f, wherever that lies, negative
/// where f < 0 there and NaN where f is not defined. It is off by at most `tolerance`, which is
/// proved by enclosures of f, but for `unproved` samples: there it is the least that it may be, as
/// no zero is proved to be near enough. On all cores. An error where the box surely has no zero,
/// and where f's zeros take too many cells to enclose.
OrInputError<DistanceGrid> sampled_distance(const Expr& f, const Uniforms& uniforms,
                                            const GridPlan& plan, double tolerance);

}  // namespace zeroset
