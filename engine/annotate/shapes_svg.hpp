#pragma once

#include "engine/annotate/shapes.hpp"

#include <glm/ext/vector_double2.hpp>

#include <cstdint>
#include <string>

namespace zeroset {

/// The shapes on a canvas of a size in pixels, over a ground of one colour, as a file of Scalable
/// Vector Graphics 1.1. Texts stay texts.
std::string svg_of(const Shapes& shapes, const glm::dvec2& size, std::uint32_t ground);

}  // namespace zeroset
