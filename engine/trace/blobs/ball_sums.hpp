#pragma once

#include "engine/trace/blobs/ball_bins.hpp"

#include <cstdint>

namespace zeroset {

/// A cell of a beam: rays within the radii of (u, v), between two depths.
struct BallCell {
    double u, v, u_radius, v_radius;
    double s, s_radius;
};

/// The sum of balls less a level on a cell, as FormBatchOf has f: in
///   c + along_u eu + along_v ev + along_s et + [-error, error].
struct BallForm {
    double c = 0, along_u = 0, along_v = 0, along_s = 0;
    double error = 0;
    double slope_lo = 0, slope_hi = 0;  ///< of its slope along the rays
};

/// What is common to the cells of a tile.
struct BallForms {
    BlobKind kind;
    double level;
    double tail;         ///< bounds what is not counted
    double slope_tail;   ///< so, of slopes along rays
    double distance;     ///< as TileRays has it
    double place_error;  ///< bounds that of places in double
};

/// Encloses the balls of a bin on a cell; all that reach it are among them. Floats or doubles. In
/// upward rounding.
BallForm form_by_floats(const BallForms& of, const BallBin& bin, const BallCell& cell);
BallForm form_by_doubles(const BallForms& of, const BallBin& bin, const BallCell& cell);

/// The sum of balls less a level, and its slopes to the right, up and along the view.
struct BallValue {
    double value, slope[3];
};
/// At a place of the view: to the right, up and along it from the point looked at.
BallValue value_of(const BallForms& of, const BallBin& bin, double x, double y, double z);

}  // namespace zeroset
