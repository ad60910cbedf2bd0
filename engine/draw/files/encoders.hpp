#pragma once

#include "engine/draw/files/drawing_style.hpp"

#include <cstdint>
#include <expected>
#include <optional>
#include <string>

namespace zeroset {

// The writers behind the table of formats. Each has a source of its own.

/// The drawing as a PDF of one page of its size, with true curves; or the reason why it cannot be
/// made.
std::expected<std::string, std::string> pdf_of(const LineDrawing& drawing,
                                               const DrawingStyle& style);

/// The drawing as a file of Scalable Vector Graphics 1.1: a group for each kind of curve, visible
/// or hidden, with an id such as "visible-silhouette"; paths of the class "surface-1" and so on.
std::string svg_of(const LineDrawing& drawing, const DrawingStyle& style);

/// The drawing as a TikZ picture, to be read by \input in a LaTeX document that uses tikz: a scope
/// for each kind of curve.
std::string tikz_of(const LineDrawing& drawing, const DrawingStyle& style);

/// Width of the line in a style; nothing where it is hidden and such lines are left out.
std::optional<double> shown_width(const DrawnLine& line, const DrawingStyle& style);

/// How far below the middle of a text its baseline is, in em, in DejaVu Sans.
inline constexpr double below_middle_em = 0.365;

/// The six hexadecimal digits of a colour 0xRRGGBB, in capitals.
std::string hex_digits(std::uint32_t color);

/// The number with up to `decimals` digits after the point, without zeros at the end, for a file.
std::string file_number(double number, int decimals);

}  // namespace zeroset
