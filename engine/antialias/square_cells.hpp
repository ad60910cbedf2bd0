#pragma once

#include "engine/antialias/square_field.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <span>

namespace zeroset {

/// Takes a surface's fronts in some squares, all of one level, on: by one cell each; or, where
/// there is only this surface, until none goes on. In upward rounding.
void advance_fronts(const TraceFrame& frame, std::size_t surface, SquareField& field,
                    std::span<const std::size_t> squares, Counters& counters);

}  // namespace zeroset
