#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace zeroset {

/// A number, vector or colour of POV-Ray: one to five numbers.
using PovValue = std::vector<double>;

/// The values under + - * /, part by part; a number counts as a vector of equal parts.
PovValue joined(const PovValue& a, char sign, const PovValue& b);

/// A vector of three parts; a number counts as one of equal parts, what is missing as 0.
glm::dvec3 vector_of(const PovValue& value);

/// The value of a function of POV-Ray's language (not of its function { } blocks); nothing for
/// others.
std::optional<PovValue> pov_function(std::string_view name, std::span<const PovValue> arguments);

/// The values of names that are always there: pi, x, clock (0), White and others of colors.inc.
std::optional<PovValue> pov_constant(std::string_view name);

}  // namespace zeroset
