// The interval Newton method with the operator of Alefeld and Hansen [Florez08, fig. 4.8 and
// eq. 4.2; Caprani00].
//   T       a stretch [t1, t2] of the ray      F, F'   enclosures of f and df/dt over T
//   tm      its middle                         AH(T)   tm - F(tm) / F'(T) in extended arithmetic
// As newton.cpp, but where F' contains 0 and F(tm) does not, AH(T) leaves none, one or two parts of
// T, each no wider than half of it; only where both contain 0, T is divided.
//
// Differs from the source: as newton.cpp. The printed 1 / F'(T) = [-inf, 1/t1] u [t2, inf] stands
// for [1/t2, inf].

#include "papers/along_rays/newton_step.hpp"
#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

namespace zeroset {
namespace {

template <class Real>
class AlefeldHansen {
public:
    explicit AlefeldHansen(RayField<Real>& field) : field_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        field_.reject_by_ranges(tasks, outcomes, open_);
        field_.find_slopes(tasks, open_);
        field_.ranges.clear();
        for (const std::size_t i : open_)
            field_.ranges.push(tasks[i].pixel, tasks[i].stretch.middle());
        field_.ranges.evaluate();
        for (std::size_t k = 0; k < open_.size(); ++k) {
            const Stretch& t = tasks[open_[k]].stretch;
            TaskOutcome& outcome = outcomes[open_[k]];
            const Interval<double> slope = field_.forms.slope(k);
            const Interval<double> middle = field_.ranges.of(k);
            if (excludes_zero(slope)) {
                take_newton_step(t, middle, slope, outcome);
            } else if (excludes_zero(middle) && field_.forms.continuous(k)) {
                take_alefeld_hansen_step(t, middle, slope, outcome);
            } else {
                outcome.bisect(t);
            }
        }
    }

private:
    RayField<Real>& field_;
    std::vector<std::size_t> open_;
};

}  // namespace

void trace_tile_alefeld_hansen(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                               Counters& counters) {
    trace_along_rays<AlefeldHansen>(frame, tile, hits, counters);
}

}  // namespace zeroset
