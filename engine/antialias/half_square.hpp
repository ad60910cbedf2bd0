#pragma once

#include "engine/antialias/square_rays.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

/// A linear function on the square [-1, 1]^2: value + by_x x + by_y y.
struct LinearOnSquare {
    double value, by_x, by_y;

    [[nodiscard]] double at(const SquareRay& place) const {
        return value + by_x * place.x + by_y * place.y;
    }
    /// How steep it is.
    [[nodiscard]] double slope() const {
        // Scale first, since squares may overflow; std::hypot is slow.
        const double most = std::max(std::abs(by_x), std::abs(by_y));
        const double part = std::min(std::abs(by_x), std::abs(by_y)) / most;
        return most > 0.0 ? most * std::sqrt(1.0 + part * part) : 0.0;
    }
    LinearOnSquare operator-() const { return {.value = -value, .by_x = -by_x, .by_y = -by_y}; }
    friend LinearOnSquare operator-(const LinearOnSquare& a, const LinearOnSquare& b) {
        return {.value = a.value - b.value, .by_x = a.by_x - b.by_x, .by_y = a.by_y - b.by_y};
    }
};

/// A part of the square: its share of the whole, and its centre of gravity.
struct SquarePart {
    double share;
    double x, y;  ///< 0 where there is nothing

    /// All of the square but this.
    [[nodiscard]] SquarePart rest() const;
};

/// Where the function is at most 0.
SquarePart part_below_zero(const LinearOnSquare& f);

}  // namespace zeroset
