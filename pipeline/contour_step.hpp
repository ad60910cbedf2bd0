#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/scene/scene.hpp"

namespace zeroset {

/// The greatest of 1, 2, 5 times a power of ten that is no more than `length`.
double even_step(double length);

/// The step between contour lines of a number, of 1, 2, 5 times a power of ten, that makes some ten
/// of them on the scene's surfaces: by where those pass a coarse grid in the clip box, or by all of
/// that where they pass none. The view does not matter. 1 where the number has no values.
double contour_step(const Scene& scene, const PointFunction& number);

}  // namespace zeroset
