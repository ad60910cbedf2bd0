#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/real/field.hpp"

#include <memory>

namespace zeroset {

/// What f is where it is field(x, y, z) - level, or the negative of that: kept in Kernel::memory by
/// who knows the formula, before tracers ask for it.
struct FieldLevel {
    std::shared_ptr<const Field> field;  ///< nullptr: f is none, or it is not known
    PointFunction level;                 ///< of the uniforms alone: the same at all points
    KernelFunction<RangeBatchOf<double>> level_range = {};  ///< encloses the level
};

}  // namespace zeroset
