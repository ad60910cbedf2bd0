#pragma once

#include "engine/trace/in_precision.hpp"
#include "engine/trace/tile_hits.hpp"
#include "papers/along_rays/hit_writer.hpp"
#include "papers/along_rays/ray_field.hpp"
#include "papers/along_rays/root_decision.hpp"
#include "papers/along_rays/stretch_stacks.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace zeroset {

/// The memory that a search keeps from one tile to the next.
template <class Real>
struct RayMemory {
    RayField<Real> field;
    StretchStacks stacks;
    std::vector<std::uint32_t> active;
    std::vector<RayTask> tasks, last;
    std::vector<TaskOutcome> outcomes;
};

/// The search of a tile's rays, each on its own, for their first roots: the nearest stretch of each
/// ray is looked at by a method, at most most_tasks rays at a time, so that the kernels have whole
/// batches. A method has
///   void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes);
/// Stretches that are not to be divided are decided by RootDecision, whatever the method.
template <class Real, class Method>
class RaySearch {
public:
    RaySearch(const TileRays& rays, TileHits& hits, RayMemory<Real>& memory, Method& method)
        : field_(memory.field),
          stacks_(memory.stacks),
          memory_(memory),
          method_(method),
          decision_(memory.field),
          writer_(rays, memory.field.lines, hits) {}

    /// Searches each ray from where roots are looked for on it to the end of that.
    void run() {
        run_from([](std::uint32_t, const RayLine& line, const auto& push) {
            push(Stretch{.from = line.from, .to = line.to});
        });
    }
    /// `starts(pixel, line, push)` pushes the stretches in which a ray may have roots, the nearest
    /// last.
    template <class Starts>
    void run_from(const Starts& starts) {
        begin(starts);
        std::vector<std::uint32_t>& active = memory_.active;
        while (!active.empty()) {
            for (std::size_t first = 0; first < active.size(); first += most_tasks) {
                if (field_.frame->stopped()) return leave();
                const std::size_t count = std::min(most_tasks, active.size() - first);
                step(std::span(active).subspan(first, count));
            }
            std::erase_if(active, [&](std::uint32_t pixel) { return stacks_.empty(pixel); });
        }
    }

private:
    template <class Starts>
    void begin(const Starts& starts) {
        stacks_.begin();
        memory_.active = field_.lines.pixels();
        for (const std::uint32_t pixel : memory_.active)
            starts(pixel, field_.lines.of(pixel),
                   [&](const Stretch& stretch) { stacks_.push(pixel, stretch); });
        std::erase_if(memory_.active, [&](std::uint32_t pixel) { return stacks_.empty(pixel); });
    }
    /// Leaves the rays undecided that are not searched to their ends.
    void leave() {
        for (const std::uint32_t pixel : memory_.active) {
            if (!stacks_.empty(pixel)) writer_.leave_unsettled(pixel, stacks_.top(pixel).from);
        }
    }
    void step(std::span<const std::uint32_t> pixels) {
        memory_.tasks.clear();
        memory_.last.clear();
        for (const std::uint32_t pixel : pixels) {
            if (stacks_.empty(pixel)) continue;
            const Stretch stretch = stacks_.pop(pixel);
            const double finest = field_.lines.finest(field_.lines.of(pixel), stretch.from);
            const double middle = stretch.middle();
            const bool is_last =
                stretch.width() <= finest || !(stretch.from < middle && middle < stretch.to);
            (is_last ? memory_.last : memory_.tasks).push_back({pixel, stretch, finest});
        }
        if (!memory_.tasks.empty()) {
            memory_.outcomes.assign(memory_.tasks.size(), TaskOutcome());
            method_.examine(memory_.tasks, memory_.outcomes);
            for (std::size_t i = 0; i < memory_.tasks.size(); ++i)
                take(memory_.tasks[i], memory_.outcomes[i]);
        }
        if (memory_.last.empty()) return;
        const auto answers = decision_.decide(memory_.last);
        for (std::size_t i = 0; i < memory_.last.size(); ++i) {
            if (writer_.take(memory_.last[i], answers[i])) stacks_.drop(memory_.last[i].pixel);
        }
    }
    void take(const RayTask& task, const TaskOutcome& outcome) {
        switch (outcome.kind) {
            case TaskOutcome::Kind::Parts:
                for (std::size_t i = outcome.count; i > 0; --i)
                    stacks_.push(task.pixel, outcome.parts[i - 1]);
                return;
            case TaskOutcome::Kind::Stop: memory_.last.push_back(task); return;
            case TaskOutcome::Kind::Root: break;
        }
        const Stretch& around = outcome.parts[0];
        const DepthRange& inside = field_.lines.of(task.pixel).inside;
        if (around.from < inside.enter_hi || around.to > inside.exit_lo) {
            // It may lie outside.
            memory_.last.push_back({.pixel = task.pixel, .stretch = around, .finest = task.finest});
            return;
        }
        writer_.push(task.pixel, outcome.root, true);
        stacks_.drop(task.pixel);
    }
    RayField<Real>& field_;
    StretchStacks& stacks_;
    RayMemory<Real>& memory_;
    Method& method_;
    RootDecision<Real> decision_;
    HitWriter writer_;
};

/// Traces a tile by a method for each type of numbers, made of the field in which it looks.
template <template <class> class Method>
void trace_along_rays(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters) {
    in_precision(frame, [&](auto real) {
        using Real = decltype(real);
        thread_local const auto kept = std::make_unique<RayMemory<Real>>();
        RayMemory<Real>& memory = *kept;
        const TileRays rays(frame, tile);
        memory.field.begin(frame, tile, rays, counters);
        Method<Real> method(memory.field);
        RaySearch<Real, Method<Real>>(rays, hits, memory, method).run();
    });
}

}  // namespace zeroset
