#pragma once

#include "engine/kernel/form_cells.hpp"
#include "engine/light/shadow_search.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// What a cell on the way from hits to the light is known to hold.
enum class Shade : std::uint8_t {
    Free,  ///< no root but the hits
    Dark,  ///< a root on all rays
    Open,
};
struct ShadeVerdict {
    Shade shade;
    Sign sign = Sign::Unknown;  ///< of f at the end towards the light, on all rays, of a free cell
};

inline Sign sign_of(bool positive) { return positive ? Sign::Positive : Sign::Negative; }

/// What is in a cell, or behind it as the light sees it.
enum class Start : std::uint8_t {
    Roots,   ///< in it, the hits: roots of the surface's own function
    Others,  ///< in it, hits of other surfaces, or on caps
    Behind,  ///< the hits are behind it
};

/// Judges cell i. `sign`: that of f at its end away from the light, where the hits are behind it.
template <class Real, std::size_t room>
ShadeVerdict judge(const FormCells<Real, room>& cells, std::size_t i, Start start, Sign sign) {
    const Real aside = std::abs(cells.k[0][i]) + std::abs(cells.k[1][i]) + cells.e[i];
    const Real steepness = std::abs(cells.k[2][i]);
    const Real size = std::abs(cells.c[i]);
    if (cells.nowhere[i] != 0) return {Shade::Free};
    if (size > steepness + aside) return {Shade::Free, sign_of(cells.c[i] > 0)};
    if (cells.continuous[i] == 0) return {Shade::Open};
    // Depths fall towards the light.
    const bool falls = cells.slope_neg_lo[i] < 0;
    const bool rises = cells.slope_hi[i] < 0;
    if (falls || rises) {
        // f goes away from 0: from the hits, or from where its sign is known.
        const Sign ahead = sign_of(rises);
        const bool away = start == Start::Behind && sign == ahead;
        if (start == Start::Roots || away) return {Shade::Free, ahead};
    }
    if (start != Start::Behind) return {Shade::Open};
    // f is c - k at the end towards the light, but for what it changes aside.
    const Real k = cells.k[2][i];
    const bool turned = (sign == Sign::Positive && cells.c[i] - k + aside < 0) ||
                        (sign == Sign::Negative && k - cells.c[i] + aside < 0);
    const bool opposite_signs = steepness > size + aside;
    return {turned || opposite_signs ? Shade::Dark : Shade::Open};
}

}  // namespace zeroset
