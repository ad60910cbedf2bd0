#include "tests/oracle/kernel_inclusion.hpp"

#include "tests/support/oracle/mpfi_evaluator.hpp"
#include "tests/support/random_expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace zeroset::test {
namespace {

constexpr int places_a_box = 4;
constexpr mpfr_prec_t kernel_bits = 256;

using Place = std::array<double, 4>;

template <class Real>
Place random_place(const Box4<Real>& box, RandomNumbers& random) {
    Place at{};
    for (std::size_t v = 0; v < at.size(); ++v)
        at.at(v) = random.point_in(box.at(v));
    return at;
}

/// The smallest box that holds both points.
std::vector<MpfiInterval> box_between(const Place& a, const Place& b) {
    std::vector<MpfiInterval> box;
    for (std::size_t v = 0; v < a.size(); ++v)
        box.emplace_back(std::min(a.at(v), b.at(v)), std::max(a.at(v), b.at(v)));
    return box;
}

/// The claim for the whole box that the values of f on a part of it disprove, or an empty text.
template <class Real>
std::string disproved_by(const MpfiEnclosure& part, const Outcome<Real>& outcome) {
    if (!part.somewhere) {
        return outcome.everywhere ? "undefined somewhere, but claimed defined" : "";
    }
    if (!part.everywhere) return "";
    if (!outcome.somewhere) return "defined somewhere, but claimed undefined";
    if (meets(outcome.value, part.range)) return "";
    return "not enclosed: values in " + part.range.text() + " by " + hex(outcome.value);
}

}  // namespace

template <class Real>
std::string disproved(const Expr& expr, const Box4<Real>& box, const Outcome<Real>& outcome,
                      InclusionTally& tally) {
    const WorkingPrecision precision(kernel_bits);
    MpfiEvaluator evaluator(expr);
    RandomNumbers random(9);
    Place last = random_place(box, random);
    for (int k = 0; k < places_a_box; ++k) {
        const Place at = random_place(box, random);
        for (const Place& other : {at, last}) {
            ++tally.checks;
            std::string reason = disproved_by(evaluator.over(box_between(at, other)), outcome);
            if (!reason.empty()) return reason;
        }
        last = at;
    }
    return "";
}

template <class Real>
std::string disproved(MakeKernel make, const FormulaOnBox<Real>& on) {
    Boxes<Real> boxes;
    boxes.fill(on.box);
    const Ranges<Real> ranges = in_tested_mode(ranges_of<Real>, make(on.expr), boxes);
    InclusionTally tally;
    return disproved(on.expr, on.box, ranges.front(), tally);
}

template <class Real>
void check_kernel(MakeKernel make, int depth, RandomNumbers& random, InclusionTally& tally) {
    const Expr expr = random_expression(random, depth);
    tally.note_operators(expr);
    const Boxes<Real> boxes = random_boxes<Real>(random);
    const Ranges<Real> ranges = in_tested_mode(ranges_of<Real>, make(expr), boxes);
    for (std::size_t i = 0; i < boxes_a_batch; ++i) {
        const std::string reason = disproved(expr, boxes.at(i), ranges.at(i), tally);
        tally.note(reason, [&] {
            const auto fails = [&](const auto& on) { return !disproved(make, on).empty(); };
            const auto small = shrunk(FormulaOnBox<Real>{expr, boxes.at(i)}, fails);
            return "formula " + small.expr.canonical() + "\n" + described(small.box) +
                   "  there: " + disproved(make, small) + "\nmade of " + expr.canonical() + "\n" +
                   described(boxes.at(i));
        });
    }
}

template std::string disproved(const Expr&, const Box4<float>&, const Outcome<float>&,
                               InclusionTally&);
template std::string disproved(const Expr&, const Box4<double>&, const Outcome<double>&,
                               InclusionTally&);
template std::string disproved(MakeKernel, const FormulaOnBox<float>&);
template std::string disproved(MakeKernel, const FormulaOnBox<double>&);
template void check_kernel<float>(MakeKernel, int, RandomNumbers&, InclusionTally&);
template void check_kernel<double>(MakeKernel, int, RandomNumbers&, InclusionTally&);

}  // namespace zeroset::test
