#pragma once

#include "engine/tape/tape.hpp"

#include <span>

namespace zeroset {

/// Sets the band of each step, from the last one down, whose zeros alone matter. Steps whose blends
/// are marked must be so before. A step that is no more than the q of a smooth minimum keeps what
/// it heeds; others lose it.
void mark_bands(const TapeGraph& graph, std::span<Tape::Step> steps);

}  // namespace zeroset
