// The interval Newton method along rays [Florez08, fig. 4.7; Caprani00].
//   T       a stretch [t1, t2] of the ray      F, F'   enclosures of f and df/dt over T
//   tm      its middle                         N(T)    tm - F(tm) / F'(T)
// Where F contains 0, T is divided while F' contains 0, else it becomes N(T) and T.
//
// Differs from the source:
// - f(tm) is an enclosure, too: with it rounded to a number roots may be lost.
// - Where N(T) is not half as wide as T, what it leaves is divided besides: near what numbers tell
//   apart it comes to a standstill.
// - F' holds only where f is proved continuous; elsewhere T is divided.
// - A stretch as wide as the threshold is no root yet: see RootDecision.

#include "papers/along_rays/newton_step.hpp"
#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

namespace zeroset {
namespace {

template <class Real>
class Newton {
public:
    explicit Newton(RayField<Real>& field) : field_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        field_.reject_by_ranges(tasks, outcomes, open_);
        field_.find_slopes(tasks, open_);
        monotone_.clear();
        field_.ranges.clear();
        for (std::size_t k = 0; k < open_.size(); ++k) {
            const RayTask& task = tasks[open_[k]];
            if (excludes_zero(field_.forms.slope(k))) {
                monotone_.push_back(k);
                field_.ranges.push(task.pixel, task.stretch.middle());
            } else {
                outcomes[open_[k]].bisect(task.stretch);
            }
        }
        field_.ranges.evaluate();
        for (std::size_t k = 0; k < monotone_.size(); ++k) {
            const std::size_t i = open_[monotone_[k]];
            take_newton_step(tasks[i].stretch, field_.ranges.of(k),
                             field_.forms.slope(monotone_[k]), outcomes[i]);
        }
    }

private:
    RayField<Real>& field_;
    std::vector<std::size_t> open_, monotone_;
};

}  // namespace

void trace_tile_newton(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters) {
    trace_along_rays<Newton>(frame, tile, hits, counters);
}

}  // namespace zeroset
