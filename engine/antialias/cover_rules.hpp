#pragma once

// How far pixels are divided, and what is good enough.

namespace zeroset {

/// Squares of these levels are not divided: where surfaces begin one before the other's end, at
/// edges that are no lines, at such edges in walls of the clip region, where f is not known to be
/// continuous, and for their colours. 16 squares of five rays each tell as much of an edge without
/// a name as it is worth.
inline constexpr int last_level = 4;
inline constexpr int last_edge_level = 2;
inline constexpr int last_wall_level = 5;
inline constexpr int last_broken_level = 1;
inline constexpr int last_color_level = 2;
/// The last level for edges where f may have kinks, which may show more than one colour.
inline constexpr int last_kinked_edge_level = 2;
/// From this level on an edge has one colour where f changes the same way at all rays.
inline constexpr int first_one_slope_level = 1;
/// From this level on rays that agree stand for a square.
inline constexpr int first_flat_level = 2;
/// From this level on an edge at walls of the clip region between rays without roots is found by f
/// at one end of their stretches, whatever walls these end in (one_end_samples). In larger squares
/// walls meet too often between rays and corners.
inline constexpr int first_one_end_level = 3;
/// The width of the enclosure of normal . view from which on a square is looked at closely for its
/// colours; and where f may have kinks.
inline constexpr double most_turn = 0.5;
inline constexpr double most_turn_at_kinks = 0.15;
constexpr double most_turn_of(bool kinked) { return kinked ? most_turn_at_kinks : most_turn; }
/// The error of the f of a cell, in parts of its change across the square, from which on the cell
/// is halved rather than the square divided.
inline constexpr double most_cell_error = 0.25;
/// most_cell_error where the pixels around look like the square's own: it holds no thread.
inline constexpr double most_calm_cell_error = 1.0;
/// How far an edge may be off from a line: in pixels, and in parts of the square's side.
inline constexpr double most_error_of_line = 1.0 / 68;
inline constexpr double most_error_of_edge = 1.0 / 8;
/// The width, in pixels, of threads that are drawn where no ray is known to have a root; and half
/// the width from which on a root would be known.
inline constexpr double thread_width = 1.0 / 8;
inline constexpr double thinnest_thread = 1.0 / 80;
/// The first cell of a pixel whose own ray hits nothing, in its widths.
inline constexpr double first_widths = 8.0;
/// How much longer than their slabs cells are at both ends, in pixels' widths.
inline constexpr double cell_margin = 1.0 / 1024;
/// How well roots are known, in pixels' widths.
inline constexpr double root_error = 1.0 / 1024;
/// The least share of a square that is worth a search.
inline constexpr double least_share = 1e-3;

}  // namespace zeroset
