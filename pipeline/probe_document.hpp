#pragma once

#include "engine/measure/probe.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/settings.hpp"
#include "pipeline/formula.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Formulas and tolerances for probing pixels, used by the window and the command line.

namespace zeroset {

/// The formulas, as they were typed, of the program's surfaces in `shown`, for probe(); `formula`:
/// the code that drew them, nullptr if there was no time for any.
std::vector<Kernel> typed_formulas(const Program& program, const Formula* formula,
                                   const std::vector<std::size_t>& shown);

/// Largest distance of the depths of a frame traced in this precision from the surface, world
/// units; a guess if the criterion bounds nothing.
double depth_tolerance(const Box& clip, const StopCriterion& stop, Precision precision);

}  // namespace zeroset
