#pragma once

#include "engine/expr/op.hpp"
#include "engine/num/interval.hpp"
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

/// The values of a step that matter: outside the band, only on which side the value lies does.
struct Band {
    double lo, hi;

    static constexpr Band everything() { return {.lo = -infinity, .hi = infinity}; }
    /// The band of a value that nobody asks for.
    static constexpr Band nothing() { return {.lo = everything().hi, .hi = everything().lo}; }
    [[nodiscard]] constexpr bool empty() const { return lo > hi; }
};

/// The band of an operand that min, max or a smooth minimum may take, from that of the result: an
/// operand above hi + 1 has no part in a smooth minimum of at most hi.
constexpr Band band_of_alternative(Op op, const Band& band) {
    return op == Op::SmoothMin ? Band{.lo = band.lo, .hi = band.hi + 1} : band;
}

/// Sets the band of each step, from the last one down, whose zeros alone matter. Steps whose blends
/// are marked must be so before. A step that is no more than the q of a smooth minimum keeps what
/// it heeds; others lose it.
void mark_bands(const TapeGraph& graph, std::span<Tape::Step> steps);

}  // namespace zeroset
