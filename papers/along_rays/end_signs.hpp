#pragma once

#include "papers/along_rays/ray_field.hpp"
#include "papers/along_rays/stretch.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// Signs of F at single points of tasks' rays, as the methods of [SanjuanEstrada03] ask for them:
/// those at a task's ends that are not known from the stretch that it is a part of.
template <class Real>
class EndSigns {
public:
    explicit EndSigns(RayField<Real>& field) : field_(field) {}

    enum class Where : std::uint8_t { From, Middle, To };

    /// Forgets what is asked for.
    void clear() {
        field_.ranges.clear();
        asked_.clear();
    }
    void ask(std::span<const RayTask> tasks, std::size_t task, Where where) {
        const Stretch& t = tasks[task].stretch;
        if (where == Where::From && t.from_sign != EndSign::NotAsked) return;
        if (where == Where::To && t.to_sign != EndSign::NotAsked) return;
        const double at = where == Where::From ? t.from : where == Where::To ? t.to : t.middle();
        field_.ranges.push(tasks[task].pixel, at);
        asked_.push_back({.task = task, .where = where});
    }
    /// The stretches of the tasks, with the signs that are known at their ends; and those in their
    /// middles, where they were asked for.
    void evaluate(std::span<const RayTask> tasks) {
        field_.ranges.evaluate();
        stretches_.clear();
        for (const RayTask& task : tasks)
            stretches_.push_back(task.stretch);
        middles_.assign(tasks.size(), EndSign::NotAsked);
        for (std::size_t i = 0; i < asked_.size(); ++i) {
            const EndSign sign = field_.ranges.sign(i);
            Stretch& stretch = stretches_[asked_[i].task];
            switch (asked_[i].where) {
                case Where::From: stretch.from_sign = sign; break;
                case Where::Middle: middles_[asked_[i].task] = sign; break;
                case Where::To: stretch.to_sign = sign; break;
            }
        }
    }
    /// Finds the signs at both ends of all tasks, and evaluates F where they are not opposite
    /// [SanjuanEstrada03, MRFro], or where its width is to end the search: rejects as
    /// RayField::reject_by_ranges.
    void reject_by_ends(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes,
                        std::vector<std::size_t>& open) {
        clear();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            ask(tasks, i, Where::From);
            ask(tasks, i, Where::To);
        }
        evaluate(tasks);
        open.clear();
        agreeing_.clear();
        field_.ranges.clear();
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            const Stretch& t = stretches_[i];
            if (are_opposite(t.from_sign, t.to_sign) && !field_.stops_by_width()) {
                open.push_back(i);
                continue;
            }
            agreeing_.push_back(i);
            field_.ranges.push(tasks[i].pixel, t.from, t.to);
        }
        field_.ranges.evaluate();
        for (std::size_t k = 0; k < agreeing_.size(); ++k) {
            if (field_.take_range(k, outcomes[agreeing_[k]])) open.push_back(agreeing_[k]);
        }
    }
    [[nodiscard]] const Stretch& of(std::size_t task) const { return stretches_[task]; }
    [[nodiscard]] EndSign middle(std::size_t task) const { return middles_[task]; }

private:
    struct Asked {
        std::size_t task;
        Where where;
    };
    RayField<Real>& field_;
    std::vector<Asked> asked_;
    std::vector<Stretch> stretches_;
    std::vector<EndSign> middles_;
    std::vector<std::size_t> agreeing_;
};

}  // namespace zeroset
