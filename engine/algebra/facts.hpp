#pragma once

#include "engine/num/interval.hpp"

#include <optional>
#include <type_traits>

namespace zeroset {

/// Facts of a node that the structure of the formula tells, for every value of the variables.
struct Facts {
    bool nonnegative = false;  ///< also in the computed enclosure: -lo is never above 0
    bool uniform = false;      ///< depends on w and parameters only
    std::optional<Interval<double>> constant;  ///< enclosure of a subexpression without variables
    bool undefined = false;  ///< surely, on whatever box: the constant operands leave no value
    double middle = 0.0;     ///< of the constant's enclosure, to nearest
    float middle_float = 0.0F;

    /// The constant in the type of a kernel.
    template <class Real>
    [[nodiscard]] Interval<Real> constant_box() const {
        return {upper_end(Real{}, constant->neg_lo), upper_end(Real{}, constant->hi)};
    }
    template <class Real>
    [[nodiscard]] Real constant_point() const {
        if constexpr (std::is_same_v<Real, float>) {
            return middle_float;
        } else {
            return middle;
        }
    }

    /// Whether the node is the same known double everywhere.
    [[nodiscard]] bool exact() const { return constant && -constant->neg_lo == constant->hi; }
};

}  // namespace zeroset
