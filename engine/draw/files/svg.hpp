#pragma once

#include "engine/draw/files/drawing_style.hpp"

#include <string>

namespace zeroset {

/// The drawing as a file of Scalable Vector Graphics 1.1: a group for each kind of curve, visible
/// or hidden, with an id such as "visible-silhouette"; paths of the class "surface-1" and so on.
std::string svg_of(const LineDrawing& drawing, const DrawingStyle& style);

}  // namespace zeroset
