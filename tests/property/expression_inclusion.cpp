#include "tests/property/expression_inclusion.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/interpret/interpret.hpp"
#include "tests/support/random_expression.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

namespace zeroset::test {
namespace {

constexpr int points_a_formula_box = 3;

/// Checks the facts of the formula against the claims for a box. Facts are found in double, so a
/// kernel in double knows as much; one in float may not see that a constant is just outside a
/// domain.
template <class Real>
void check_facts(const Expr& expr, const Facts& facts, const Outcome<Real>& outcome,
                 InclusionTally& tally) {
    const auto place = [&] { return "formula " + expr.canonical(); };
    if (facts.nonnegative && outcome.value.neg_lo > 0) {
        tally.note("below 0, but known not to be negative", place);
    }
    if (facts.undefined && outcome.somewhere && std::is_same_v<Real, double>) {
        tally.note("known to be undefined, but with a range", place);
    }
}

template <class Real>
void check_point(const Expr& expr, const Facts& facts, const Box4<Real>& box,
                 const Outcome<Real>& outcome, RandomNumbers& random, InclusionTally& tally) {
    std::array<double, 4> at{};
    for (std::size_t v = 0; v < at.size(); ++v)
        at.at(v) = random.point_in(box.at(v));
    const Reference truth = reference(expr, at);
    const auto place = [&] {
        return "formula " + expr.canonical() + "\n" + described(box) + "  at (" + hex(at[0]) +
               ", " + hex(at[1]) + ", " + hex(at[2]) + ", " + hex(at[3]) + ")";
    };
    tally.note(complaint(outcome, truth, tally), place);
    if (facts.undefined && truth.defined && !truth.is_unknown())
        tally.note("known to be undefined, but defined", place);
}

}  // namespace

template <class Real>
Boxes<Real> random_boxes(RandomNumbers& random) {
    const double smallest = sizeof(Real) == 4 ? -20 : -48;
    const bool usual = random.one_in(2);
    const auto draw = [&] {
        if (!usual) return random.interval<Real>();
        const auto lo = static_cast<Real>(random.uniform(-3, 3));
        const auto size = static_cast<Real>(std::exp2(random.uniform(smallest, 2)));
        return Interval<Real>{-lo, lo + size};
    };
    const Interval<Real> w = draw();
    Boxes<Real> result{};
    for (Box4<Real>& box : result)
        box = {draw(), draw(), draw(), w};
    return result;
}

/// Calls the kernel without its own check of the rounding mode, which the mutant fails.
template <class Batch>
void run(const KernelFunction<Batch>& function, const Batch& batch) {
    function.call(function.code.get(), &batch);
}

template <class Real>
Ranges<Real> ranges_of(const Kernel& kernel, const Boxes<Real>& boxes) {
    using Row = std::array<Real, boxes_a_batch>;
    std::array<Row, 3> neg_lo{};
    std::array<Row, 3> hi{};
    for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t i = 0; i < boxes_a_batch; ++i) {
            neg_lo[v][i] = boxes[i][v].neg_lo;
            hi[v][i] = boxes[i][v].hi;
        }
    }
    const std::array<Real, 2> uniforms{boxes[0][3].neg_lo, boxes[0][3].hi};
    Row f_neg_lo{};
    Row f_hi{};
    std::array<ContinuityMask<Real>, boxes_a_batch> continuous{};
    const RangeBatchOf<Real> batch{boxes_a_batch,
                                   {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                                   {hi[0].data(), hi[1].data(), hi[2].data()},
                                   uniforms.data(),
                                   f_neg_lo.data(),
                                   f_hi.data(),
                                   continuous.data()};
    if constexpr (std::is_same_v<Real, float>) {
        run(kernel.in_float.range, batch);
    } else {
        run(kernel.in_double.range, batch);
    }
    Ranges<Real> result{};
    for (std::size_t i = 0; i < boxes_a_batch; ++i) {
        const bool somewhere = f_hi[i] != -std::numeric_limits<Real>::infinity();
        const bool proved = continuous[i] != 0;
        result[i] = {{f_neg_lo[i], f_hi[i]}, somewhere, proved, proved};
    }
    return result;
}

template <class Real>
std::string described(const Box4<Real>& box) {
    return "  x " + hex(box[0]) + "\n  y " + hex(box[1]) + "\n  z " + hex(box[2]) + "\n  w " +
           hex(box[3]) + "\n";
}

template <class Real>
void check_expression(const Expr& expr, RandomNumbers& random, InclusionTally& tally) {
    const Facts facts = facts_of(expr).back();
    const Boxes<Real> boxes = random_boxes<Real>(random);
    const Ranges<Real> ranges = in_tested_mode(ranges_of<Real>, interpret(expr), boxes);
    for (std::size_t i = 0; i < boxes_a_batch; ++i) {
        check_facts(expr, facts, ranges.at(i), tally);
        for (int k = 0; k < points_a_formula_box; ++k)
            check_point(expr, facts, boxes.at(i), ranges.at(i), random, tally);
    }
}

template <class Real>
void check_random_expression(int depth, RandomNumbers& random, InclusionTally& tally) {
    check_expression<Real>(random_expression(random, depth), random, tally);
}

template Boxes<float> random_boxes(RandomNumbers&);
template Boxes<double> random_boxes(RandomNumbers&);
template Ranges<float> ranges_of(const Kernel&, const Boxes<float>&);
template Ranges<double> ranges_of(const Kernel&, const Boxes<double>&);
template std::string described(const Box4<float>&);
template std::string described(const Box4<double>&);
template void check_expression<float>(const Expr&, RandomNumbers&, InclusionTally&);
template void check_expression<double>(const Expr&, RandomNumbers&, InclusionTally&);
template void check_random_expression<float>(int, RandomNumbers&, InclusionTally&);
template void check_random_expression<double>(int, RandomNumbers&, InclusionTally&);

}  // namespace zeroset::test
