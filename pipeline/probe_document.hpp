#pragma once

#include "engine/measure/probe.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/settings.hpp"
#include "pipeline/formula.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// What pixels show, for the window and the command line.

namespace zeroset {

/// f as it was typed of the program's surfaces that are shown, for probe().
std::vector<Kernel> typed_formulas(const Program& program, const std::vector<std::size_t>& shown);

/// How far the depths of a frame traced in this type may be from the surface, world units; a guess
/// where the criterion bounds nothing.
double depth_tolerance(const Box& clip, const StopCriterion& stop, Precision precision);

}  // namespace zeroset
