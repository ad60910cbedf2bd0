#include "engine/rewrite/traceable.hpp"

#include "engine/rewrite/differences/differences.hpp"
#include "engine/rewrite/differences/removable_poles.hpp"
#include "engine/rewrite/passes.hpp"
#include "engine/rewrite/polynomial/polynomial_candidates.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"
#include "engine/rewrite/sample/form_sample.hpp"

#include <cstddef>

namespace zeroset {
namespace {

/// Larger formulas are not measured.
constexpr std::size_t most_nodes_compared = 500;
/// A form that is estimated to take less than this share of the time surely takes less.
constexpr double clear_gain = 0.9;

/// The tightened formula, unless beams are surely traced faster through the one as it was: that
/// has other enclosures than interval arithmetic, and the operators that make these tighter may
/// cost more than they save.
Expr quicker(const Expr& expr, const Expr& tight, const SampleRegion& region) {
    const double time = time_of_cell(expr);
    const double time_of_tight = time_of_cell(tight);
    if (time_of_tight <= time || tight.nodes().size() > most_nodes_compared) return tight;
    const FormSample sample(expr, region);
    const bool saves = time * sample.open() < clear_gain * time_of_tight * sample.open(tight);
    return saves ? expr : tight;
}

}  // namespace

Expr traceable(const Expr& expr, const SampleRegion& region) {
    const Expr folded =
        with_folds(with_plain_conditions(without_removable_poles(expr).value_or(expr)));
    const Expr smooth = with_smooth_minima(with_log_sums(plain_angles(folded)));
    const Expr short_form = with_collected_terms(smooth, region);
    const Expr plain = without_poles(without_small_differences(short_form), region);
    return polar_form(quicker(plain, tightened(plain, region), region));
}

}  // namespace zeroset
