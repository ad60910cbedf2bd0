#pragma once

#include "engine/draw/files/drawing_style.hpp"

#include <string>

namespace zeroset {

/// The drawing as a TikZ picture, to be read by \input in a LaTeX document that uses tikz: a scope
/// for each kind of curve.
std::string tikz_of(const LineDrawing& drawing, const DrawingStyle& style);

}  // namespace zeroset
