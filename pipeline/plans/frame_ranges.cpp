#include "pipeline/plans/frame_ranges.hpp"

#include "engine/base/clock.hpp"
#include "engine/measure/open_space.hpp"
#include "engine/render/tracers.hpp"
#include "pipeline/plans/film_plan.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>
#include <cstddef>

namespace zeroset {
namespace {

/// Frames after which the length is chosen again.
constexpr int frames_a_choice = 96;
/// A length is used if it saves more than this part of the evaluations.
constexpr double least_gain = 0.05;
/// The time of an evaluation over a box, and of a cell that a frame looks up, in evaluations of a
/// frame.
constexpr double cost_of_range = 0.5;
constexpr double cost_of_cell = 1.0;

/// Cells of the grid are smaller than tiles of pixels.
int levels_for(int height) {
    const int levels = static_cast<int>(std::bit_width(static_cast<unsigned>(height))) - 5;
    return std::clamp(levels, 4, most_open_levels - 1);
}

}  // namespace

FrameRanges::FrameRanges(const FilmPlan& plan, FrameRangeChoice choice,
                         const TraceSettings& settings, int height, ValuesAt values_at)
    : plan_(plan),
      choice_(choice),
      values_at_(std::move(values_at)),
      levels_(levels_for(height)),
      threads_(settings.threads) {
    if (!find_tracer(settings.tracer)->takes_open_space) choice_ = 0;
    if (choice_) {
        lengths_ = {*choice_};
    } else if (plan.sweeps.empty()) {
        lengths_ = {0, plan.frames};
    } else {
        lengths_ = {0, 32, 8, 3};
    }
}

Uniforms FrameRanges::hull(int first, int last) const {
    std::vector<double> lo, hi;
    for (int frame = first; frame <= last; ++frame) {
        for (const double moment : moments_of(plan_, frame)) {
            const std::vector<double> values = values_at_(moment);
            if (lo.empty()) lo = hi = values;
            for (std::size_t i = 0; i < values.size(); ++i) {
                lo[i] = std::min(lo[i], values[i]);
                hi[i] = std::max(hi[i], values[i]);
            }
        }
    }
    Uniforms uniforms;
    for (std::size_t i = 0; i < lo.size(); ++i)
        uniforms.set(i, lo[i], hi[i]);
    return uniforms;
}

void FrameRanges::search(const Scene& scene, int frame) {
    const auto start = std::chrono::steady_clock::now();
    // Where nothing but the camera moves, all frames are alike.
    first_ = plan_.sweeps.empty() ? 0 : frame - frame % length_;
    last_ = std::min(plan_.sweeps.empty() ? plan_.frames : first_ + length_, plan_.frames) - 1;
    const Uniforms uniforms = hull(first_, last_);
    spaces_.clear();
    std::uint64_t ranges = 0;
    std::size_t cells = 0;
    for (const Surface& surface : scene.surfaces) {
        OpenSpaceSearch found =
            find_open_space(surface.kernel, scene.clip, uniforms, levels_, scene.jumps, threads_);
        ranges += found.ranges;
        cells += found.space.cells.size();
        spaces_.push_back(std::make_shared<const OpenSpace>(std::move(found.space)));
    }
    cost_ = cost_of_range * static_cast<double>(ranges) / (last_ - first_ + 1) +
            cost_of_cell * static_cast<double>(cells);
    ++work_.searches;
    work_.ranges += ranges;
    work_.search_ms += ms_since(start);
}

void FrameRanges::choose(int frame) {
    if (frame_ == frame) return;
    frame_ = frame;
    if (drawn_ == frames_a_choice) {
        drawn_ = 0;
        costs_.clear();
    }
    const std::size_t tried = costs_.size();
    const int before = length_;
    if (tried < lengths_.size()) {
        length_ = lengths_[tried];
    } else {
        const auto least = std::ranges::min_element(costs_);
        const bool pays = *least < (1.0 - least_gain) * costs_.front();
        length_ = pays || choice_ ? lengths_[static_cast<std::size_t>(least - costs_.begin())] : 0;
    }
    if (length_ != before) last_ = -1;
}

void FrameRanges::add_to(Scene& scene, int frame) {
    choose(frame);
    if (length_ == 0) return;
    if (frame < first_ || frame > last_) search(scene, frame);
    assert(spaces_.size() == scene.surfaces.size());
    for (std::size_t i = 0; i < spaces_.size(); ++i)
        scene.surfaces[i].open_space = spaces_[i];
}

void FrameRanges::learn(std::uint64_t evaluations) {
    ++drawn_;
    if (length_ > 0) ++work_.frames;
    work_.length = length_;
    if (costs_.size() < lengths_.size())
        costs_.push_back(static_cast<double>(evaluations) + (length_ > 0 ? cost_ : 0.0));
}

}  // namespace zeroset
