#pragma once

#include "engine/measure/probe.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {

/// What `render --probe` says of a pixel: one line of JSON. `surface`: the hit surface's number
/// among those of the text, from 1; `reading`: how it was read.
std::string json_line(int col, int row, const std::optional<PointFacts>& facts, std::size_t surface,
                      const std::string& reading);

}  // namespace zeroset
