// Sphere tracing along rays [Hart96; Florez08, sec. 4.3.5], with bounds of the slope that hold.
//   T       a stretch [t1, t2] of the ray      g    f along the ray
//   L       a Lipschitz bound of g on T: the largest size in F', the enclosure of dg/dt over T
// From t1 the ray goes on by |g(t1)| / L: up to there g has no root. That is repeated until T is
// left behind, or is as narrow as the threshold.
//
// Differs from the source:
// - L holds for the stretch ahead alone, not for all of space, and needs no knowledge of the
//   formula; spheres are thus stretches. Where a step takes less than a quarter of T, what is left
//   of T is divided, so that nearer to the surface L is that of its surroundings.
// - g(t1) is an enclosure, of which the least size counts: what is passed is proved free.
// - The end is no distance, but a stretch that RootDecision decides; it may turn out to hold
//   nothing, and the ray goes on.

#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// T without what is free behind t1. In upward rounding.
void take_step(const Stretch& t, const Interval<double>& g_first, const Interval<double>& slope,
               TaskOutcome& outcome) {
    const double neg_size = std::min({g_first.neg_lo, g_first.hi, 0.0});
    const double neg_step = neg_size / std::abs(std::max(slope.neg_lo, slope.hi));
    const double at = -(neg_step - t.from);
    if (std::isnan(at) || !(at > t.from)) return outcome.bisect(t);
    if (at > t.to) return outcome.reject();
    const Stretch left{.from = at, .to = t.to};
    constexpr double much = 0.25;
    if (at - t.from >= much * t.width()) return outcome.narrow(left);
    outcome.bisect(left);
}

template <class Real>
class SphereTracing {
public:
    explicit SphereTracing(RayField<Real>& field) : field_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        FormsOnRays<Real>& forms = field_.forms;
        forms.clear();
        field_.ranges.clear();
        for (const RayTask& task : tasks) {
            forms.push(task.pixel, task.stretch);
            field_.ranges.push(task.pixel, task.stretch.from);
        }
        forms.evaluate();
        field_.ranges.evaluate();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            if (forms.is_nowhere(i)) {
                outcomes[i].reject();
            } else if (field_.is_narrow_form(i)) {
                outcomes[i].stop();
            } else {
                take_step(tasks[i].stretch, field_.ranges.of(i), forms.slope(i), outcomes[i]);
            }
        }
    }

private:
    RayField<Real>& field_;
};

}  // namespace

void trace_tile_sphere_tracing(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                               Counters& counters) {
    trace_along_rays<SphereTracing>(frame, tile, hits, counters);
}

}  // namespace zeroset
