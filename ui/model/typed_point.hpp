#pragma once

#include <glm/ext/vector_double3.hpp>

#include <optional>
#include <string>

namespace zeroset::ui {

/// Reads a point as people type it: "1, 2, 3", "(1; 2; 3)", "1 2 3"; behind semicolons and blanks
/// decimal commas are read, too. Nothing where it is none; all coordinates are at most
/// largest_number in size.
std::optional<glm::dvec3> point_typed(const std::string& text);

}  // namespace zeroset::ui
