#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/real/field.hpp"

#include <memory>
#include <vector>

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

struct PatchCode;

/// All that is known of a surface's function beside its code (Kernel::facts): found once, by who
/// knows the formula. All functions are in upward rounding. Read-only; any thread.
struct SurfaceFacts {
    /// Ranges of functions whose zeros are zeros of f (engine/rewrite/surface_functions.hpp).
    std::vector<KernelFunction<RangeBatchOf<double>>> witnesses = {};
    bool defined_everywhere = false;  ///< f is surely defined for all values of the variables
    /// Ranges of a function that is continuous only where f is defined; none: not known.
    KernelFunction<RangeBatchOf<double>> domain = {};
    FieldLevel field = {};  ///< what f is a level of
    /// It has no inside, whatever the sign of f is beside it: a part of a plane. Sections do not
    /// fill it.
    bool is_sheet = false;
    std::shared_ptr<const PatchCode> patch = nullptr;  ///< of a parametric surface; else nullptr
};

/// The facts of a kernel's function: none, where no one has told.
const SurfaceFacts& surface_facts(const Kernel& kernel);

}  // namespace zeroset
