#pragma once

#include "engine/kernel/kernel.hpp"
#include "tests/support/random_numbers.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset::test {

/// The answers of a kernel, as bits. All NaNs are made equal, and so are all gradients where f is
/// NaN: the sign of a NaN decides about the slope of abs, and IEEE 754 leaves it open.
struct Bits {
    std::vector<std::uint64_t> range;  ///< -lo, hi, continuous of each box
    std::vector<std::uint64_t> value;  ///< f, df/dx, df/dy, df/dz of each point

    bool operator==(const Bits&) const = default;
};

/// The bits of the answers for a single item.
Bits one_item(const Interval<float>& range, bool continuous, float value,
              const std::array<float, 3>& gradient);
/// The bits of one item of a batch.
Bits item(const Bits& batch, std::size_t item);

/// Boxes, points and one w, equal for all kernels.
template <class Real>
class KernelBatchOf {
public:
    /// `count`: a multiple of batch_multiple.
    KernelBatchOf(RandomNumbers& random, std::size_t count);

    /// All answers of the kernel, computed in upward rounding.
    [[nodiscard]] Bits run(const Kernel& kernel) const;

    [[nodiscard]] std::array<Interval<Real>, 3> box(std::size_t item) const;
    [[nodiscard]] std::array<Real, 3> point(std::size_t item) const;

    Uniforms uniforms;

private:
    void run_range(const Kernel& kernel, std::vector<std::uint64_t>& bits) const;
    void run_value(const Kernel& kernel, std::vector<std::uint64_t>& bits) const;

    std::size_t count_;
    std::vector<Real> neg_lo_[3];
    std::vector<Real> hi_[3];
    std::vector<Real> x_[3];
};

using KernelBatch = KernelBatchOf<float>;

}  // namespace zeroset::test
