// Bisection along rays with reduced affine arithmetic [Knoll09, sec. 4; Gamito07; Florez08, sec.
// 4.3.5].
//   T       a stretch [t1, t2] of the ray, t = tm + r e, |e| <= 1
//   f^      the affine form of f over T: f is in c + k e + [-d, d]
// T is rejected where f^ excludes 0, |c| > |k| + d; else it is divided.
//
// Differs from the source:
// - The forms are those of beams, over cells without width: they come with F', which is not used.
// - A stretch as wide as the threshold is looked at by F, the interval extension, too: see
//   RootDecision.

#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

namespace zeroset {
namespace {

template <class Real>
class Affine {
public:
    explicit Affine(RayField<Real>& field) : field_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        FormsOnRays<Real>& forms = field_.forms;
        forms.clear();
        for (const RayTask& task : tasks)
            forms.push(task.pixel, task.stretch);
        forms.evaluate();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            if (forms.excludes_zero(i)) {
                outcomes[i].reject();
            } else if (field_.is_narrow_form(i)) {
                outcomes[i].stop();
            } else {
                outcomes[i].bisect(tasks[i].stretch);
            }
        }
    }

private:
    RayField<Real>& field_;
};

}  // namespace

void trace_tile_affine(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters) {
    trace_along_rays<Affine>(frame, tile, hits, counters);
}

}  // namespace zeroset
