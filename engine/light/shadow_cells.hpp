#pragma once

#include "engine/kernel/form_cells.hpp"
#include "engine/light/shadow_search.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The state of a cell on the way from hits to the light, as far as it is known.
enum class Shade : std::uint8_t {
    Free,  ///< no root but the hits
    Dark,  ///< a root on all rays
    Open,
};
struct ShadeVerdict {
    Shade shade;
    RaySign sign =
        RaySign::Unknown;  ///< of f at the end towards the light, on all rays, of a free cell
};

inline RaySign sign_of(bool positive) { return positive ? RaySign::Positive : RaySign::Negative; }

/// The hits of a beam: in the next cell, or behind it as the light sees it.
enum class Start : std::uint8_t {
    Roots,   ///< in it, the hits: roots of the surface's own function
    Above,   ///< in it, hits at which f is 0 or above
    Others,  ///< in it, hits of other surfaces, or on caps
    Behind,  ///< the hits are behind it
};

/// f on a cell of a beam, at the place t in [-1, 1] from its end towards the light to the other:
/// within `aside` of c + along t.
template <class Real>
struct CellLine {
    Real c, along, aside;
    bool falls, rises;  ///< f surely falls, or rises, with depth
    bool continuous, nowhere;
};

/// The line of cell i of beams that are as wide as the cells' frustum.
template <class Real, std::size_t room>
CellLine<Real> line_of(const FormCells<Real, room>& cells, std::size_t i) {
    return {.c = cells.c[i],
            .along = cells.k[2][i],
            .aside = std::abs(cells.k[0][i]) + std::abs(cells.k[1][i]) + cells.e[i],
            .falls = cells.slope_hi[i] < 0,
            .rises = cells.slope_neg_lo[i] < 0,
            .continuous = cells.continuous[i] != 0,
            .nowhere = cells.nowhere[i] != 0};
}

/// Judges a cell. `sign`: that of f at the cell's end away from the light, where the hits are
/// behind it. In upward rounding.
template <class Real>
ShadeVerdict judge(const CellLine<Real>& f, Start start, RaySign sign) {
    const Real steepness = std::abs(f.along);
    const Real size = std::abs(f.c);
    if (f.nowhere) return {.shade = Shade::Free};
    // Where f is not continuous, the form is of another function with its zeros, not its signs.
    if (size > steepness + f.aside)
        return {.shade = Shade::Free, .sign = f.continuous ? sign_of(f.c > 0) : RaySign::Unknown};
    if (!f.continuous) return {.shade = Shade::Open};
    if (f.falls || f.rises) {
        // Depths fall towards the light: f goes away from 0 there, from the hits, or from where its
        // sign is known.
        const RaySign ahead = sign_of(f.falls);
        const bool away = start == Start::Behind && sign == ahead;
        const bool leaves =
            start == Start::Roots || (start == Start::Above && ahead == RaySign::Positive);
        if (leaves || away) return {.shade = Shade::Free, .sign = ahead};
    }
    if (start != Start::Behind) return {.shade = Shade::Open};
    const bool turned = (sign == RaySign::Positive && f.c - f.along + f.aside < 0) ||
                        (sign == RaySign::Negative && f.along - f.c + f.aside < 0);
    const bool opposite_signs = steepness > size + f.aside;
    return {.shade = turned || opposite_signs ? Shade::Dark : Shade::Open};
}

}  // namespace zeroset
