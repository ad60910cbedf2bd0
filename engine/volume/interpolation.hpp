#pragma once

#include "engine/real/field_answers.hpp"

#include <array>
#include <limits>

// Answers of the ways to interpolate between samples, at points and over boxes.

namespace zeroset {

/// Second derivatives by the indices.
template <class Number>
struct Bends {
    std::array<Number, 3> mixed{};  ///< by j and k, i and k, i and j
    std::array<Number, 3> own{};    ///< twice by i, j, k
};

/// The range in the part of a box in the grid.
struct InterpolationRange {
    ValueBounds value{};
    double largest = 0;                   ///< the largest number about the box, in size
    bool somewhere = true;                ///< false: no number about it is finite
    bool holes = false;                   ///< whether the box may meet a hole
    bool exact = false;                   ///< whether the numbers were taken one by one
    std::array<ValueBounds, 3> slopes{};  ///< by the indices; only if asked for
};

/// Value and derivatives by the indices in the cell of a point; not a number in holes.
template <class Wide>
struct InterpolationPoint {
    Wide value = std::numeric_limits<Wide>::quiet_NaN();
    std::array<Wide, 3> slope{};
    Bends<Wide> bend{};
};

}  // namespace zeroset
