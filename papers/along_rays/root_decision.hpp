#pragma once

#include "engine/scene/tolerance.hpp"
#include "engine/trace/tile_hits.hpp"
#include "papers/along_rays/ray_field.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace zeroset {

/// The verdict on a stretch that is not to be divided any further.
enum class StretchAnswer : std::uint8_t {
    Free,       ///< no root
    Unsettled,  ///< f is not proved continuous: the ray goes on
    Hit,
    Certified,  ///< a hit, proved
};

/// Decides about stretches that are not to be divided any further, as K-bisection does: a stretch
/// is a hit where F contains 0 and f is continuous, and the hit is certified where f is proved to
/// have opposite signs around it, at most `extra_slices` finest stretches away.
template <class Real>
class RootDecision {
public:
    explicit RootDecision(RayField<Real>& field) : field_(field) {}

    /// The answers, one for each of at most most_tasks tasks.
    std::span<const StretchAnswer> decide(std::span<const RayTask> tasks) {
        field_.ranges.clear();
        for (const RayTask& task : tasks)
            field_.ranges.push(task.pixel, task.stretch.from, task.stretch.to);
        field_.ranges.evaluate();
        answers_.assign(tasks.size(), StretchAnswer::Hit);
        open_.clear();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            if (field_.ranges.excludes_zero(i)) {
                answers_[i] = StretchAnswer::Free;
            } else if (!field_.ranges.continuous(i)) {
                answers_[i] = StretchAnswer::Unsettled;
            } else if (field_.lines.certifies(field_.lines.of(tasks[i].pixel))) {
                open_.push_back({.task = i});
            }
        }
        for (int slices = 0; slices <= extra_slices && !open_.empty(); ++slices)
            look_around(tasks, slices);
        for (const double more : {0.5, 2.0, 8.0})
            look_wider(tasks, more);
        return answers_;
    }

private:
    struct Candidate {
        std::size_t task;
        EndSign before = EndSign::Unknown;  ///< of f at the stretch's beginning
        double from = 0.0, to = 0.0;        ///< where signs are asked for
    };

    /// Looks for opposite signs so many finest stretches away. Between the sign before and the
    /// stretch there is no root, as all that is before it is known.
    void look_around(std::span<const RayTask> tasks, int slices) {
        std::erase_if(open_, [&](Candidate& candidate) {
            const RayTask& task = tasks[candidate.task];
            const DepthRange& inside = field_.lines.of(task.pixel).inside;
            const double away = slices * task.finest;
            candidate.from = std::max(task.stretch.from - away, inside.enter_hi);
            candidate.to = std::min(task.stretch.to + away, inside.exit_lo);
            return !(candidate.from <= candidate.to);
        });
        field_.ranges.clear();
        for (const Candidate& candidate : open_) {
            const std::uint32_t pixel = tasks[candidate.task].pixel;
            field_.ranges.push(pixel, candidate.from, candidate.to);
            field_.ranges.push(pixel, candidate.from);
            field_.ranges.push(pixel, candidate.to);
        }
        field_.ranges.evaluate();
        std::size_t box = 0;
        std::erase_if(open_, [&](Candidate& candidate) {
            const std::size_t at = box;
            box += 3;
            if (!field_.ranges.continuous(at)) return true;
            if (candidate.before == EndSign::Unknown) candidate.before = field_.ranges.sign(at + 1);
            const bool crosses = are_opposite(candidate.before, field_.ranges.sign(at + 2));
            if (crosses) answers_[candidate.task] = StretchAnswer::Certified;
            return crosses;
        });
    }

    /// Looks again at unsettled stretches with so many finest ones more on both sides: a pole is
    /// seen to have no root beside it where rounding does not reach from one end of a box to it.
    void look_wider(std::span<const RayTask> tasks, double more) {
        field_.ranges.clear();
        wide_.clear();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            if (answers_[i] != StretchAnswer::Unsettled) continue;
            const RayTask& task = tasks[i];
            const double away = more * task.finest;
            field_.ranges.push(task.pixel, task.stretch.from - away, task.stretch.to + away);
            wide_.push_back(i);
        }
        field_.ranges.evaluate();
        for (std::size_t k = 0; k < wide_.size(); ++k) {
            if (field_.ranges.excludes_zero(k)) answers_[wide_[k]] = StretchAnswer::Free;
        }
    }

    RayField<Real>& field_;
    std::vector<std::size_t> wide_;
    std::vector<StretchAnswer> answers_;
    std::vector<Candidate> open_;
};

}  // namespace zeroset
