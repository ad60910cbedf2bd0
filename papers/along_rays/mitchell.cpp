// Mitchell's method along rays [Mitchell90; Florez08, fig. 4.6]: roots are isolated by intervals,
// then refined by numbers.
//   T       a stretch [t1, t2] of the ray      F, F'   enclosures of f and df/dt over T
// Where F contains 0, T is divided while F' contains 0; else f has at most one root in T, and has
// one if its signs at t1 and t2 differ.
//
// Differs from the source:
// - Intervals are rounded outward, and the signs at t1 and t2 are those of enclosures; where they
//   are not proved, T is divided.
// - The refined root is proved by the signs of f half a threshold, or one and a half, around it.
// - F' holds only where f is proved continuous; elsewhere T is divided.
// - A stretch as wide as the threshold is not refined, as it may hold no root: see RootDecision.

#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/root_refinement.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

namespace zeroset {
namespace {

template <class Real>
class Mitchell {
public:
    explicit Mitchell(RayField<Real>& field) : field_(field), roots_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        field_.reject_by_ranges(tasks, outcomes, open_);
        field_.find_slopes(tasks, open_);
        isolating_.clear();
        for (std::size_t k = 0; k < open_.size(); ++k) {
            if (excludes_zero(field_.forms.slope(k))) {
                isolating_.push_back(open_[k]);
            } else {
                outcomes[open_[k]].bisect(tasks[open_[k]].stretch);
            }
        }
        roots_.decide(tasks, isolating_, outcomes);
    }

private:
    RayField<Real>& field_;
    IsolatedRoots<Real> roots_;
    std::vector<std::size_t> open_, isolating_;
};

}  // namespace

void trace_tile_mitchell(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                         Counters& counters) {
    trace_along_rays<Mitchell>(frame, tile, hits, counters);
}

}  // namespace zeroset
