#pragma once

#include "engine/mesh/field_on_boxes.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// A direction along which all these gradients surely rise, of length 1; nothing where none was
/// found. In upward rounding.
std::optional<glm::dvec3> common_rise(std::span<const GradientBox> gradients);

/// A lower bound of the slopes of these gradients along `direction`. In upward rounding.
double least_slope(const GradientBox& gradient, const glm::dvec3& direction);

}  // namespace zeroset
