#pragma once

#include "engine/tape/tape.hpp"

#include <optional>
#include <span>

namespace zeroset {

/// A smooth minimum m - q or q - m, or a smooth maximum m + q, of a and b: m is their min or max,
/// and q is at least 0 and made of max(k - |a - b|, 0), with which it vanishes.
struct Blend {
    Tape::Index extreme;  ///< the step m
    Tape::Index hat;      ///< max(k - |a - b|, 0)
    double height;        ///< an upper bound of k
    double reach;         ///< of k + q
};

/// The blend that the step, a sum or difference, ends.
std::optional<Blend> blend_of(const Tape& tape, const Tape::Step& sum);

/// Sets the band of each step, from the last one down, whose zeros alone matter. Steps whose blends
/// are marked must be so before. A step that is no more than the q of a smooth minimum keeps what
/// it heeds; others lose it.
void mark_bands(const TapeGraph& graph, std::span<Tape::Step> steps);

}  // namespace zeroset
