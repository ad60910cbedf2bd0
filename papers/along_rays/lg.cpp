// The second step of LG-surfaces along rays [Kalra89; Florez08, fig. 4.12]: roots are isolated by
// bounds of the slope.
//   T       a stretch [t1, t2] of the ray      g     f along the ray
//   tm, d   its middle and half its length     L     a Lipschitz constant of g on T
//   F'      the enclosure of dg/dt over T
// T is rejected where |g(tm)| > L d. Where g is monotone on T it has one root at most, and has one
// if its signs at t1 and t2 differ: that is refined. Else T is divided.
//
// Differs from the source:
// - L is the largest size in F', where the source asks for a constant for each formula.
// - G, the Lipschitz constant of dg/dt with which the source shows |g'(tm)| > G d, is left out: F'
//   tells itself whether it contains 0.
// - The first step, an octree of which boxes are rejected by L, is left out.
// - g(tm) and the signs are those of enclosures; roots are proved as in mitchell.cpp.

#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/root_refinement.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

#include <algorithm>

namespace zeroset {
namespace {

/// Whether g is so far from 0 in the middle of T that it has no root there. In upward rounding.
bool is_beyond_reach(const Interval<double>& g_middle, const Interval<double>& slope,
                     const Stretch& t) {
    const double half = std::max(t.to - t.middle(), t.middle() - t.from);
    const double reach = std::max(slope.neg_lo, slope.hi) * half;
    return std::min(g_middle.neg_lo, g_middle.hi) < -reach;
}

template <class Real>
class Lipschitz {
public:
    explicit Lipschitz(RayField<Real>& field) : field_(field), roots_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        FormsOnRays<Real>& forms = field_.forms;
        forms.clear();
        field_.ranges.clear();
        for (const RayTask& task : tasks) {
            forms.push(task.pixel, task.stretch);
            field_.ranges.push(task.pixel, task.stretch.middle());
        }
        forms.evaluate();
        field_.ranges.evaluate();
        isolating_.clear();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            const Interval<double> slope = forms.slope(i);
            if (forms.is_nowhere(i) ||
                is_beyond_reach(field_.ranges.of(i), slope, tasks[i].stretch)) {
                outcomes[i].reject();
            } else if (field_.is_narrow_form(i)) {
                outcomes[i].stop();
            } else if (excludes_zero(slope)) {
                isolating_.push_back(i);
            } else {
                outcomes[i].bisect(tasks[i].stretch);
            }
        }
        roots_.decide(tasks, isolating_, outcomes);
    }

private:
    RayField<Real>& field_;
    IsolatedRoots<Real> roots_;
    std::vector<std::size_t> isolating_;
};

}  // namespace

void trace_tile_lg(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters) {
    trace_along_rays<Lipschitz>(frame, tile, hits, counters);
}

}  // namespace zeroset
