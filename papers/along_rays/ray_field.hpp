#pragma once

#include "engine/trace/ray_lines.hpp"
#include "papers/along_rays/enclosures.hpp"
#include "papers/along_rays/stretch.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace zeroset {

/// f on the rays of a tile, as methods ask for it.
template <class Real>
struct RayField {
    const TraceFrame* frame = nullptr;
    Counters* counters = nullptr;
    RayLines lines;
    RangesOnRays<Real> ranges;
    FormsOnRays<Real> forms;

    void begin(const TraceFrame& of, const Tile& tile, const TileRays& rays, Counters& count) {
        frame = &of;
        counters = &count;
        lines.begin(of, tile, rays, std::numeric_limits<Real>::digits);
        ranges.begin(of, lines, count);
        forms.begin(of, rays, count);
    }

    /// Goes on with another function on the same rays.
    void look_at(const TraceFrame& of) {
        frame = &of;
        ranges.look_at(of);
        forms.look_at(of);
    }
    /// Tells who asks that f was evaluated so often for a pixel.
    void tell_cost(std::uint32_t pixel, double evaluations = 1.0) const {
        if (counters->costs != nullptr) counters->costs->add(pixel, evaluations);
    }
    [[nodiscard]] bool stops_by_width() const { return frame->stop.rule == StopRule::Delta; }
    /// Whether an enclosure of f as wide as this ends the search [Knoll07, sec. 5.5].
    [[nodiscard]] bool is_narrow(double width) const {
        return stops_by_width() && width < frame->stop.value;
    }
    /// The first test of all methods by intervals: rejects the tasks in which F excludes 0, and
    /// stops at those in which it is narrow; the others' indices become `open`.
    void reject_by_ranges(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes,
                          std::vector<std::size_t>& open) {
        ranges.clear();
        for (const RayTask& task : tasks)
            ranges.push(task.pixel, task.stretch.from, task.stretch.to);
        ranges.evaluate();
        open.clear();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            if (take_range(i, outcomes[i])) open.push_back(i);
        }
    }
    /// Takes F over the task's stretch, the evaluated one number i; whether the task stays open.
    bool take_range(std::size_t i, TaskOutcome& outcome) const {
        if (ranges.excludes_zero(i)) {
            outcome.reject();
            return false;
        }
        const Interval<double> f = ranges.of(i);
        if (ranges.continuous(i) && is_narrow(f.neg_lo + f.hi)) {
            outcome.stop();
            return false;
        }
        return true;
    }
    /// Whether the form of the evaluated stretch number i is so narrow that the search ends.
    [[nodiscard]] bool is_narrow_form(std::size_t i) const {
        return forms.continuous(i) && is_narrow(2.0 * static_cast<double>(forms.spread(i)));
    }
    /// Evaluates F' over the stretches of the tasks with these indices, in their order.
    void find_slopes(std::span<const RayTask> tasks, std::span<const std::size_t> which) {
        forms.clear();
        for (const std::size_t i : which)
            forms.push(tasks[i].pixel, tasks[i].stretch);
        forms.evaluate();
    }
};

}  // namespace zeroset
