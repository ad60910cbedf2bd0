#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/real/field.hpp"

#include <memory>

namespace zeroset {

/// The field and the level of an f that is field(x, y, z) - level, or the negative of that.
struct FieldLevel {
    std::shared_ptr<const Field> field;  ///< nullptr: f is none, or it is not known
    /// Encloses the level, which is of the uniforms alone: the same in all boxes.
    KernelFunction<RangeBatchOf<double>> level;

    struct Value {
        double middle, error;  ///< NaN where the level may be undefined
    };
    /// The level for some values of the uniforms, in upward rounding.
    [[nodiscard]] Value at(const Uniforms& uniforms) const;
};

}  // namespace zeroset
