#pragma once

#include "engine/trace/blobs/ball_bins.hpp"

#include <array>
#include <cstddef>

namespace zeroset {

/// The most cells or places that are evaluated at once.
inline constexpr std::size_t most_ball_lanes = 16;
using BallNumbers = std::array<double, most_ball_lanes>;

/// Cells of beams: rays within the radii of (u, v), between two depths.
struct BallCells {
    std::size_t count = 0;
    double u_radius = 0, v_radius = 0;
    BallNumbers u, v, s, s_radius;
};

/// The sum of balls less a level on a cell, as FormBatchOf has f: in
///   c + along[0] eu + along[1] ev + along[2] et + [-error, error].
struct BallForm {
    double c = 0, along[3] = {0, 0, 0};
    double error = 0;
    double slope_lo = 0, slope_hi = 0;  ///< of its slope along the rays
};

/// The numbers that the enclosures of all cells of a tile share.
struct BallForms {
    BlobKind kind;
    double level;
    double tail;         ///< bounds what is not counted
    double slope_tail;   ///< bounds what is not counted of slopes along rays
    double distance;     ///< as TileRays has it
    double place_error;  ///< bounds the error of places in double
};

BallForms ball_forms(const BallBins& bins, const BlobSurface& surface);

/// Encloses the balls of a bin on each cell; all that reach them are among them. By floats or
/// doubles. In upward rounding.
void forms_by_floats(const BallForms& of, const BallBin& bin, const BallCells& cells,
                     BallForm* forms);
void forms_by_doubles(const BallForms& of, const BallBin& bin, const BallCells& cells,
                      BallForm* forms);

template <class Real>
void find_forms(const BallForms& of, const BallBin& bin, const BallCells& cells, BallForm* forms) {
    if constexpr (sizeof(Real) == sizeof(float)) {
        forms_by_floats(of, bin, cells, forms);
    } else {
        forms_by_doubles(of, bin, cells, forms);
    }
}

/// Places of the view: to the right, up and along it from the point looked at; the sum of balls
/// less a level there, and its slopes the same ways.
struct BallPoints {
    std::size_t count = 0;
    BallNumbers x, y, z;
    BallNumbers value;                 ///< out
    std::array<BallNumbers, 3> slope;  ///< out
};
void find_values(const BallForms& of, const BallBin& bin, BallPoints& points);

}  // namespace zeroset
