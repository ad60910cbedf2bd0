// The conditions of MRFro with the interval Newton method along rays [Florez08, sec. 4.3.4].
//   T       a stretch [t1, t2] of the ray      F, F'   enclosures of f and df/dt over T
//   tm      its middle                         N(T)    tm - F(tm) / F'(T)
// F is evaluated over T only where its signs at t1 and t2 are not opposite. Where F' excludes 0, T
// has no root if the signs are the same, else it becomes N(T) and T; it is divided while F'
// contains 0.
//
// Differs from the source, which only names the method: what is done where is ours; else as
// mrfro.cpp and newton.cpp.

#include "papers/along_rays/end_signs.hpp"
#include "papers/along_rays/newton_step.hpp"
#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

namespace zeroset {
namespace {

template <class Real>
class MrfRoNewton {
public:
    explicit MrfRoNewton(RayField<Real>& field) : field_(field), signs_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        signs_.reject_by_ends(tasks, outcomes, open_);
        field_.find_slopes(tasks, open_);
        field_.ranges.clear();
        for (const std::size_t i : open_)
            field_.ranges.push(tasks[i].pixel, tasks[i].stretch.middle());
        field_.ranges.evaluate();
        for (std::size_t k = 0; k < open_.size(); ++k) {
            const Stretch& t = signs_.of(open_[k]);
            TaskOutcome& outcome = outcomes[open_[k]];
            const Interval<double> slope = field_.forms.slope(k);
            if (!excludes_zero(slope)) {
                outcome.bisect(t, field_.ranges.sign(k));
            } else if (are_equal(t.from_sign, t.to_sign)) {
                outcome.reject();
            } else {
                take_newton_step(t, field_.ranges.of(k), slope, outcome);
            }
        }
    }

private:
    RayField<Real>& field_;
    EndSigns<Real> signs_;
    std::vector<std::size_t> open_;
};

}  // namespace

void trace_tile_mrfro_newton(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters) {
    trace_along_rays<MrfRoNewton>(frame, tile, hits, counters);
}

}  // namespace zeroset
