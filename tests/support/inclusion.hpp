#pragma once

#include "engine/expr/expr.hpp"
#include "engine/num/interval.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/mpfr_number.hpp"

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <set>
#include <string>

// Helpers of the inclusion tests. Intervals are computed inside `in_tested_mode` only, everything
// else in round-to-nearest.

namespace zeroset::test {

#if defined(ZEROSET_MUTANT_ROUNDS_TO_NEAREST)
inline constexpr int tested_mode = FE_TONEAREST;
#else
inline constexpr int tested_mode = FE_UPWARD;
#endif

/// The result of function(arguments...) in the rounding mode under test. The volatile pointer keeps
/// the compiler from moving the work out of the guard's life.
template <class Result, class... Arguments>
Result in_tested_mode(Result (*function)(const Arguments&...), const Arguments&... arguments) {
    Result (*volatile opaque)(const Arguments&...) = function;
    const RoundingGuard<tested_mode> guard;
    return opaque(arguments...);
}

/// An enclosure and its claims about the function on the box.
template <class Real>
struct Outcome {
    Interval<Real> value;
    bool somewhere = true;   ///< false: claimed undefined on the whole box
    bool everywhere = true;  ///< claimed defined on the whole box
    bool continuous = true;  ///< claimed continuous where defined
    std::optional<Interval<Real>> gap{};
};

template <class Real>
bool contains(const Interval<Real>& range, const MpfrNumber& value) {
    if (std::isnan(range.neg_lo) || std::isnan(range.hi)) return false;
    const bool below = value < -static_cast<double>(range.neg_lo);
    const bool above = value > static_cast<double>(range.hi);
    const bool two_parts = range.neg_lo < 0 && range.hi < 0;  // as RangeBatch says
    return two_parts ? !(below && above) : !below && !above;
}

/// Whether the value does not lie inside the gap of Enclosure::gap.
template <class Real>
bool is_beside(const Interval<Real>& gap, const MpfrNumber& value) {
    return !(value > static_cast<double>(gap.hi) && value < -static_cast<double>(gap.neg_lo));
}

inline std::string hex(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    return text;
}

template <class Real>
std::string hex(const Interval<Real>& a) {
    return "[" + hex(-static_cast<double>(a.neg_lo)) + ", " + hex(static_cast<double>(a.hi)) + "]";
}

/// Counts of the checks of inclusion.
struct InclusionTally {
    std::uint64_t checks = 0;    ///< points at which a claim was compared with the truth
    std::uint64_t failures = 0;  ///< claims that were found wrong
    std::string first;           ///< describes the first failure
    std::set<Op> operators;      ///< in the formulas that were tried

    void note_operators(const Expr& expr) {
        for (const Node& node : expr.nodes())
            operators.insert(node.op);
    }
    /// Counts a failure unless `reason` is empty. `place()` describes where it is.
    void note(const std::string& reason, const auto& place) {
        if (reason.empty()) return;
        if (failures++ == 0) first = reason + "\n" + place();
    }
    InclusionTally& operator+=(const InclusionTally& other) {
        if (failures == 0) first = other.first;
        checks += other.checks;
        failures += other.failures;
        return *this;
    }
};

/// The first wrong claim of `outcome` at a point of the box where the function is `truth`, or an
/// empty text. `whole_turns`: the value counts up to a multiple of 2 pi.
template <class Real>
std::string complaint(const Outcome<Real>& outcome, const Reference& truth, InclusionTally& tally,
                      bool whole_turns = false) {
    if (truth.is_unknown()) return {};
    ++tally.checks;
    if (!truth.defined) return outcome.everywhere ? "undefined there, but claimed defined" : "";
    if (!outcome.somewhere) return "defined there, but claimed undefined";
    if (outcome.gap && !is_beside(*outcome.gap, truth.value)) {
        return "not enclosed: " + truth.value.text() + " between the sides " + hex(*outcome.gap);
    }
    if (contains(outcome.value, truth.value)) return {};
    if (whole_turns) {
        const MpfrNumber turn = pi() + pi();
        if (contains(outcome.value, truth.value + turn) ||
            contains(outcome.value, truth.value - turn)) {
            return {};
        }
    }
    return "not enclosed: " + truth.value.text() + " by " + hex(outcome.value);
}

}  // namespace zeroset::test
