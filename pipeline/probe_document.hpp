#pragma once

#include "engine/measure/probe.hpp"
#include "engine/measure/special_point.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/settings.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/picture_request.hpp"

#include <glm/ext/vector_double3.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

// Formulas and tolerances for probing pixels, used by the window and the command line.

/// The formulas, as they were typed, of the program's surfaces in `shown`, for probe(), in the
/// world that is drawn; `formula`: the code that drew them, nullptr if there was no time for any.
std::vector<Kernel> typed_formulas(const Program& program, const Formula* formula,
                                   const std::vector<std::size_t>& shown);

/// The facts of a pixel in a world that is drawn stretched (Camera), with point, normal and
/// `within` in the formula's; the distance from the eye is that of the drawn world.
PointFacts unstretched(PointFacts facts, const glm::dvec3& stretch);

/// Largest distance of the depths of a frame traced in this precision from the surface, world
/// units; a guess if the criterion bounds nothing.
double depth_tolerance(const Box& clip, const StopCriterion& stop, Precision precision);

/// f, as typed, with its derivatives.
DerivedFormula derived_formula(const Expr& f);

/// The special point nearest to `from` of all surfaces that the picture shows, numerical; see
/// nearest_special_point. Thread-safe; takes milliseconds, longer for large formulas.
std::optional<SpecialPoint> special_point_of(const PictureRequest& picture, const glm::dvec3& from,
                                             const glm::dvec3& up);

}  // namespace zeroset
