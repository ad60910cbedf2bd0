#pragma once

#include "app/formula.hpp"
#include "engine/measure/probe.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"

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

/// What `render --probe` says of a pixel: one line of JSON. `surface`: the hit surface's number
/// among those of the text, from 1; `reading`: how it was read.
std::string json_line(int col, int row, const std::optional<PointFacts>& facts, std::size_t surface,
                      const std::string& reading);

}  // namespace zeroset
