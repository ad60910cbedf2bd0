#pragma once

#include "engine/kernel/field_level.hpp"
#include "engine/kernel/kernel.hpp"

#include <memory>
#include <vector>

namespace zeroset {

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
