#pragma once

#include "engine/antialias/square_field.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <span>

namespace zeroset {

/// Evaluates the next cell of a surface's front in each of some squares, all of one level, and
/// takes the fronts on by what it says. In upward rounding.
void advance_fronts(const TraceFrame& frame, std::size_t surface, SquareField& field,
                    std::span<const std::size_t> squares, Counters& counters);

}  // namespace zeroset
