#pragma once

#include "engine/measure/probe.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {

/// The line of JSON that `render --probe` prints for a pixel. `surface`: number of the hit surface
/// in the text, from 1; `reading`: how that surface was read.
std::string json_line(int col, int row, const std::optional<PointFacts>& facts, std::size_t surface,
                      const std::string& reading);

}  // namespace zeroset
