#pragma once

#include "engine/kernel/kernel.hpp"

#include <array>
#include <mutex>
#include <vector>

namespace zeroset {

/// Whether floats can tell where a function vanishes, or its numbers leave their range (1e38 and
/// 1e-38, as of exp and high powers) and only doubles can. Any thread.
class FloatCheck {
public:
    /// `ranges`: the function's kernel, of which the ranges in both types are asked.
    explicit FloatCheck(const Kernel& ranges);

    /// In this box, for these uniforms; the last answer is remembered.
    [[nodiscard]] bool suffices(const std::array<double, 3>& lo, const std::array<double, 3>& hi,
                                const Uniforms& uniforms) const;

private:
    [[nodiscard]] bool measured(const std::array<double, 3>& lo, const std::array<double, 3>& hi,
                                const Uniforms& uniforms) const;

    KernelFunction<RangeBatchOf<float>> in_float_;
    KernelFunction<RangeBatchOf<double>> in_double_;

    mutable std::mutex mutex_;  ///< of the following
    mutable std::array<double, 3> lo_{}, hi_{};
    mutable std::vector<double> uniforms_;
    mutable bool known_ = false;
    mutable bool suffices_ = true;
};

}  // namespace zeroset
