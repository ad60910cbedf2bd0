// The method MRF along rays [SanjuanEstrada03; Florez08, sec. 4.3.3]: interval bisection that looks
// at signs.
//   T       a stretch [t1, t2] of the ray      F   the enclosure of f over T
//   tm      its middle
// Where F contains 0, T is divided; [tm, t2] is rejected where F([t1, t1]) F([tm, tm]) <= 0.
//
// Differs from the source:
// - Signs are those of enclosures, and f must be proved continuous on T: over a pole they differ,
//   too. Where one is 0 for all that is proved, nothing follows.
// - T is searched front to back, where the source does not say in which order.

#include "papers/along_rays/end_signs.hpp"
#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

namespace zeroset {
namespace {

template <class Real>
class Mrf {
public:
    explicit Mrf(RayField<Real>& field) : field_(field), signs_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        using Where = EndSigns<Real>::Where;
        field_.reject_by_ranges(tasks, outcomes, open_);
        continuous_.clear();
        for (const std::size_t i : open_)
            continuous_.push_back(field_.ranges.continuous(i));
        signs_.clear();
        for (const std::size_t i : open_) {
            signs_.ask(tasks, i, Where::From);
            signs_.ask(tasks, i, Where::Middle);
        }
        signs_.evaluate(tasks);
        for (std::size_t k = 0; k < open_.size(); ++k) {
            const std::size_t i = open_[k];
            outcomes[i].bisect(signs_.of(i), signs_.middle(i));
            const bool in_front = are_opposite(signs_.of(i).from_sign, signs_.middle(i));
            if (in_front && continuous_[k]) outcomes[i].count = 1;
        }
    }

private:
    RayField<Real>& field_;
    EndSigns<Real> signs_;
    std::vector<std::size_t> open_;
    std::vector<bool> continuous_;
};

}  // namespace

void trace_tile_mrf(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters) {
    trace_along_rays<Mrf>(frame, tile, hits, counters);
}

}  // namespace zeroset
