#pragma once

#include "engine/measure/special_point.hpp"
#include "pipeline/picture_request.hpp"

#include <glm/ext/vector_double3.hpp>

#include <optional>

namespace zeroset {

/// f, as typed, with its derivatives.
DerivedFormula derived_formula(const Expr& f);

/// The special point nearest to `from` of all surfaces that the picture shows, numerical; see
/// nearest_special_point. Thread-safe; takes milliseconds, longer for large formulas.
std::optional<SpecialPoint> special_point_of(const PictureRequest& picture, const glm::dvec3& from,
                                             const glm::dvec3& up);

}  // namespace zeroset
