#include "engine/tape/tape_marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

using Step = Tape::Step;

Band negative(const Band& band) { return {.lo = -band.hi, .hi = -band.lo}; }
Band hull(const Band& a, const Band& b) {
    return {.lo = std::min(a.lo, b.lo), .hi = std::max(a.hi, b.hi)};
}
/// The band of x, from that of c x with c > 0 in the interval.
Band divided(const Band& band, const Interval<double>& c) {
    const double least = -c.neg_lo;
    const double most = c.hi;
    const auto far = [](double end, double by) { return end / by + 0x1p-50 * std::abs(end / by); };
    return {.lo = -far(-band.lo, band.lo < 0 ? least : most),
            .hi = far(band.hi, band.hi > 0 ? least : most)};
}
/// The band of x, from that of x + c with c in the interval.
Band moved_back(const Band& band, const Interval<double>& c) {
    const double lo = band.lo - c.hi;
    const double hi = band.hi + c.neg_lo;
    return {.lo = lo - 0x1p-50 * std::abs(lo), .hi = hi + 0x1p-50 * std::abs(hi)};
}

/// The bands of operands, from that of a step.
class Bands {
public:
    Bands(const TapeGraph& graph, std::span<const Step> steps) : graph_(graph), steps_(steps) {}

    /// The band of operand k of the step.
    [[nodiscard]] Band of_operand(const Step& step, std::size_t k) const;

private:
    [[nodiscard]] Band of_factor(const Step& step, std::size_t k) const;
    [[nodiscard]] const Node& node(const Step& step) const { return graph_.expr.node(step.node); }
    [[nodiscard]] const Facts& facts(const Step& step) const { return graph_.facts[step.node]; }

    const TapeGraph& graph_;
    std::span<const Step> steps_;
};

Band Bands::of_operand(const Step& step, std::size_t k) const {
    const Op op = node(step).op;
    if (is_choice(op)) return is_alternative(op, k) ? step.band : Band::everything();
    if (op == Op::Negate) return negative(step.band);
    if (op == Op::SmoothMin) return band_of_alternative(op, step.band);
    if (op == Op::Multiply) return of_factor(step, k);
    if (!is_sum(op)) return Band::everything();
    const Band band = op == Op::Subtract && k == 1 ? negative(step.band) : step.band;
    const Step& operand = steps_[step.operands[k]];
    const Step& other = steps_[step.operands[1 - k]];
    if (step.reach > 0) {
        if (operand.tells == Tape::no_choice) return Band::nothing();
        return node(operand).op == Op::Min ? Band{.lo = band.lo, .hi = band.hi + step.reach}
                                           : Band{.lo = band.lo - step.reach, .hi = band.hi};
    }
    if (!facts(other).constant) return Band::everything();
    const Interval<double>& c = *facts(other).constant;
    const bool minus = op == Op::Subtract;
    return moved_back(band, minus ? -c : c);
}

Band Bands::of_factor(const Step& step, std::size_t k) const {
    const auto& c = facts(steps_[step.operands[1 - k]]).constant;
    if (!c || (c->neg_lo >= 0 && c->hi >= 0)) return Band::everything();
    return c->neg_lo < 0 ? divided(step.band, *c) : negative(divided(step.band, -*c));
}

}  // namespace

void mark_bands(const TapeGraph& graph, std::span<Tape::Step> steps) {
    const Bands bands(graph, steps);
    for (Step& step : steps)
        step.band = Band::nothing();
    steps.back().band = {.lo = 0, .hi = 0};
    for (std::size_t i = steps.size(); i-- > 0;) {
        Step& step = steps[i];
        if (step.band.empty()) continue;  // the q of a smooth minimum
        for (std::size_t k = 0; k < graph.operand_counts[step.node]; ++k) {
            Band& band = steps[step.operands[k]].band;
            band = hull(band, bands.of_operand(step, k));
        }
    }
    for (Step& step : steps) {
        if (!step.band.empty()) {
            step.heeds = Tape::no_choice;  // it is asked for elsewhere
        } else {
            step.band = Band::everything();
        }
    }
}

}  // namespace zeroset
