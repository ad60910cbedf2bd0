#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace zeroset {

/// w and the parameters, the same for a whole batch. Item 0 is w. An interval [lo, hi] is stored
/// as (-lo, hi), like every interval in this project. For kernels in float and in double.
struct Uniforms {
    std::vector<float> neg_lo_hi;  ///< -lo, hi of item 0, -lo, hi of item 1, ...
    std::vector<float> middle;     ///< one value for each item, for point evaluation
    std::vector<double> neg_lo_hi_double;
    std::vector<double> middle_double;

    /// The item's enclosures become [lo, hi] in double and the floats around it: NaN is unknown, an
    /// end beyond all numbers the largest of them and all above.
    void set(std::size_t item, double lo, double hi);
    void set(std::size_t item, double value) { set(item, value, value); }

    /// The `uniforms` of batches in this type: over boxes and over points.
    template <class Real>
    [[nodiscard]] const Real* boxes() const {
        return all_boxes<Real>().data();
    }
    template <class Real>
    [[nodiscard]] const Real* points() const {
        return all_points<Real>().data();
    }
    /// Two numbers an item, and one.
    template <class Real>
    [[nodiscard]] std::span<const Real> all_boxes() const {
        if constexpr (std::is_same_v<Real, float>) {
            return neg_lo_hi;
        } else {
            return neg_lo_hi_double;
        }
    }
    template <class Real>
    [[nodiscard]] std::span<const Real> all_points() const {
        if constexpr (std::is_same_v<Real, float>) {
            return middle;
        } else {
            return middle_double;
        }
    }
};

}  // namespace zeroset
