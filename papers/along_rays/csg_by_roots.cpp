// CSG by roots of the parts along rays [Florez08, sec. 6.3; Ricci73].
//   f1, f2    the parts: f is a tree of min (union) and max (intersection; f1 - f2 is max(f1, -f2))
//   t1, t2    roots of the parts on a ray, by MRFro (papers/along_rays/mrfro.cpp)
// All parts are searched front to back, always the one that has got least far. Each root of a part
// is a root of f or is not, as the enclosure of f around it tells. The other way of the thesis, by
// point sets, is that of all other tracers: they subdivide T by F, in which min and max are those
// of the enclosures of the parts.
//
// Differs from the thesis:
// - It takes one root of each part, and of these max(t1, t2) for a union and min(t1, t2) for an
//   intersection or a difference. Both are wrong: of balls between t of 1 and 3 and of 2 and 4 the
//   union begins at 1, the intersection at 2. Exchanged, they are still wrong where first roots do
//   not tell: balls between 1 and 2 and between 3 and 4 have nothing in common, though max(1, 3)
//   is 3; and a ball between 1 and 4 without one between 0 and 2 begins at 2, the second root of
//   the second ball. So all roots are taken, in their order.
// - Inside and outside are told by f, not counted by roots: parts that only touch 0 need no care.
// - A root of f is certified as by all methods along rays (RootDecision).
// A formula that is no such tree is its only part: what is left is MRFro.

#include "engine/trace/in_precision.hpp"
#include "papers/along_rays/csg_parts.hpp"
#include "papers/along_rays/hit_writer.hpp"
#include "papers/along_rays/mrfro.hpp"
#include "papers/along_rays/root_decision.hpp"
#include "papers/along_rays/stretch_stacks.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace zeroset {
namespace {

struct PreparedParts : PreparedSurface {
    std::shared_ptr<CsgParts> parts;
    std::span<const Kernel> kernels;  ///< of `parts`; none: the surface is its only part
};

/// A part of f: the stretches of each ray in which its roots are not known yet, and what is asked
/// of it.
struct PartSearch {
    StretchStacks stacks;
    std::vector<RayTask> tasks;
};

template <class Real>
struct CsgMemory {
    RayField<Real> field;
    std::vector<PartSearch> parts;
    std::vector<std::uint32_t> active;
    std::vector<RayTask> last;  ///< roots of parts, that may be roots of f
    std::vector<TaskOutcome> outcomes;
};

template <class Real>
class CsgSearch {
public:
    CsgSearch(const TraceFrame& frame, std::span<const TraceFrame> parts, const TileRays& rays,
              TileHits& hits, CsgMemory<Real>& memory)
        : frame_(frame),
          part_frames_(parts),
          memory_(memory),
          field_(memory.field),
          method_(memory.field),
          decision_(memory.field),
          writer_(rays, memory.field.lines, hits) {}

    void run() {
        begin();
        std::vector<std::uint32_t>& active = memory_.active;
        while (!active.empty()) {
            for (std::size_t first = 0; first < active.size(); first += most_together) {
                if (frame_.stopped()) return leave();
                const std::size_t count = std::min(most_together, active.size() - first);
                step(std::span(active).subspan(first, count));
            }
            std::erase_if(active, [&](std::uint32_t pixel) { return nearest(pixel) == nullptr; });
        }
    }

private:
    /// Rays that are looked at together: whole batches of several parts.
    static constexpr std::size_t most_together = 4 * most_tasks;

    void begin() {
        memory_.parts.resize(part_frames_.size());
        memory_.active = field_.lines.pixels();
        for (PartSearch& part : memory_.parts) {
            part.stacks.begin();
            for (const std::uint32_t pixel : memory_.active) {
                const RayLine& line = field_.lines.of(pixel);
                part.stacks.push(pixel, {.from = line.from, .to = line.to});
            }
        }
    }
    /// The part that has got least far on a ray; nullptr where all are at its end.
    [[nodiscard]] PartSearch* nearest(std::uint32_t pixel) const {
        PartSearch* found = nullptr;
        double from = std::numeric_limits<double>::infinity();
        for (PartSearch& part : memory_.parts) {
            if (part.stacks.empty(pixel) || part.stacks.top(pixel).from >= from) continue;
            from = part.stacks.top(pixel).from;
            found = &part;
        }
        return found;
    }
    /// Leaves the rays undecided that are not searched to their ends.
    void leave() {
        for (const std::uint32_t pixel : memory_.active) {
            if (const PartSearch* const part = nearest(pixel))
                writer_.leave_unsettled(pixel, part->stacks.top(pixel).from);
        }
    }
    void step(std::span<const std::uint32_t> pixels) {
        memory_.last.clear();
        for (const std::uint32_t pixel : pixels)
            take_stretch(pixel);
        for (std::size_t i = 0; i < memory_.parts.size(); ++i) {
            field_.look_at(part_frames_[i]);
            std::vector<RayTask>& tasks = memory_.parts[i].tasks;
            for (std::size_t first = 0; first < tasks.size(); first += most_tasks) {
                const std::size_t count = std::min(most_tasks, tasks.size() - first);
                search(std::span(tasks).subspan(first, count), memory_.parts[i].stacks);
            }
            tasks.clear();
        }
        field_.look_at(frame_);
        for (std::size_t first = 0; first < memory_.last.size(); first += most_tasks) {
            const std::size_t count = std::min(most_tasks, memory_.last.size() - first);
            decide(std::span(memory_.last).subspan(first, count));
        }
    }
    void take_stretch(std::uint32_t pixel) {
        PartSearch* const part = nearest(pixel);
        if (part == nullptr) return;
        const Stretch stretch = part->stacks.pop(pixel);
        const double finest = field_.lines.finest(field_.lines.of(pixel), stretch.from);
        const double middle = stretch.middle();
        const bool is_last =
            stretch.width() <= finest || !(stretch.from < middle && middle < stretch.to);
        (is_last ? memory_.last : part->tasks)
            .push_back({.pixel = pixel, .stretch = stretch, .finest = finest});
    }
    /// Looks for roots of a part in these stretches.
    void search(std::span<const RayTask> tasks, StretchStacks& stacks) {
        memory_.outcomes.assign(tasks.size(), TaskOutcome());
        method_.examine(tasks, memory_.outcomes);
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            const TaskOutcome& outcome = memory_.outcomes[i];
            if (outcome.kind != TaskOutcome::Kind::Parts) {
                memory_.last.push_back(tasks[i]);
                continue;
            }
            for (std::size_t k = outcome.count; k > 0; --k)
                stacks.push(tasks[i].pixel, outcome.parts[k - 1]);
        }
    }
    /// Decides whether roots of parts are roots of f.
    void decide(std::span<const RayTask> roots) {
        const auto answers = decision_.decide(roots);
        for (std::size_t i = 0; i < roots.size(); ++i) {
            if (!writer_.take(roots[i], answers[i])) continue;
            for (PartSearch& part : memory_.parts)
                part.stacks.drop(roots[i].pixel);
        }
    }

    const TraceFrame& frame_;
    std::span<const TraceFrame> part_frames_;
    CsgMemory<Real>& memory_;
    RayField<Real>& field_;
    MrfRo<Real> method_;
    RootDecision<Real> decision_;
    HitWriter writer_;
};

/// A frame for each part.
std::vector<TraceFrame> frames_of_parts(const TraceFrame& frame) {
    std::vector<TraceFrame> frames;
    for (const Kernel& part : static_cast<const PreparedParts&>(*frame.prepared).kernels)
        frames.push_back(frame.with(part, frame.limit));
    if (frames.empty()) frames.push_back(frame);
    return frames;
}

}  // namespace

std::shared_ptr<const PreparedSurface> prepare_csg_parts(const TraceFrame& surface,
                                                         int /*threads*/) {
    if (surface.stopped()) return nullptr;
    auto prepared = std::make_shared<PreparedParts>();
    prepared->parts = surface.kernel.memory->of<CsgParts>();
    prepared->kernels = prepared->parts->kernels();
    return prepared;
}

void trace_tile_csg_by_roots(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters) {
    if (frame.prepared == nullptr) return hits.leave_undecided(tile);
    in_precision(frame, [&](auto real) {
        using Real = decltype(real);
        thread_local const auto kept = std::make_unique<CsgMemory<Real>>();
        CsgMemory<Real>& memory = *kept;
        const TileRays rays(frame, tile);
        const std::vector<TraceFrame> parts = frames_of_parts(frame);
        memory.field.begin(frame, tile, rays, counters);
        CsgSearch<Real>(frame, parts, rays, hits, memory).run();
    });
}

}  // namespace zeroset
