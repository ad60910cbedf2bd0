#pragma once

#include "engine/expr/expr.hpp"
#include "engine/num/interval.hpp"

#include <optional>
#include <vector>

namespace zeroset {

/// What the structure of the formula tells of a node, for every value of the variables.
struct Facts {
    bool nonnegative = false;  ///< also in the computed enclosure: -lo is never above 0
    bool uniform = false;      ///< depends on w and parameters only
    std::optional<Interval<double>> constant;  ///< enclosure of a subexpression without variables
    double middle = 0.0;                       ///< of the constant's enclosure, to nearest
    float middle_float = 0.0F;

    /// Whether the node is the same known double everywhere.
    [[nodiscard]] bool exact() const { return constant && -constant->neg_lo == constant->hi; }
};

/// Facts of each node, in the graph's order. A constant subexpression that is undefined (1/0,
/// sqrt(-1)) has no `constant`.
std::vector<Facts> facts_of(const Expr& expr);

}  // namespace zeroset
