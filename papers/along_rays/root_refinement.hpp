#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/kernel/point_batch.hpp"
#include "papers/along_rays/ray_field.hpp"

#include <glm/glm.hpp>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// A stretch with opposite signs at its ends, on its way to a root.
struct Refinement {
    std::uint32_t pixel;
    double from, to;
    bool rises;         ///< f is below 0 at `from`
    double tolerance;   ///< of the root
    double root = 0.0;  ///< in [from, to]; the middle at first
    bool done = false;

    /// Takes f and df/ds at `root`.
    void take(double f, double slope) {
        if (std::isnan(f) || f == 0.0) {
            done = true;
            return;
        }
        ((f < 0.0) == rises ? from : to) = root;
        const double newton = root - f / slope;
        const bool fits = newton > from && newton < to;
        const double next = fits ? newton : 0.5 * from + 0.5 * to;
        done = (fits && std::abs(next - root) <= tolerance) || to - from <= tolerance;
        root = next;
    }
};

/// Root refinement with numbers [Mitchell90]: Newton's method, by bisection where that leaves the
/// bracket. Proves nothing.
class RootRefiner {
public:
    template <class Real>
    void run(RayField<Real>& field, std::span<Refinement> refinements) {
        constexpr int most_steps = 60;
        for (Refinement& refinement : refinements)
            refinement.root = 0.5 * refinement.from + 0.5 * refinement.to;
        for (int step = 0; step < most_steps && !field.frame->stopped(); ++step) {
            open_.clear();
            for (Refinement& refinement : refinements) {
                if (!refinement.done) open_.push_back(&refinement);
            }
            if (open_.empty()) return;
            advance(field);
        }
    }

private:
    template <class Real>
    void advance(RayField<Real>& field) {
        batch_.resize(open_.size());
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const auto [x, y, z] = field.lines.of(open_[i]->pixel).at(open_[i]->root);
            batch_.set(i, x, y, z);
        }
        batch_.pad();
        field.counters->value += open_.size();
        for (const Refinement* const one : open_)
            field.tell_cost(one->pixel);
        field.frame->kernel.in_double.value(
            batch_.batch(field.frame->scene.uniforms.template points<double>()));
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const RayLine& line = field.lines.of(open_[i]->pixel);
            double slope = 0.0;
            for (std::size_t k = 0; k < 3; ++k)
                slope += batch_.gradient(k, i) * line.direction[k];
            open_[i]->take(batch_.f(i), slope);
        }
    }

    std::vector<Refinement*> open_;
    PointBatch<double> batch_;
};

/// The roots of tasks in whose stretches f is proved continuous and monotone, and so has one root
/// at most.
template <class Real>
class IsolatedRoots {
public:
    explicit IsolatedRoots(RayField<Real>& field) : field_(field) {}

    /// Decides the tasks with these indices by the signs at the ends of their stretches: where they
    /// are opposite, the root is refined and its place proved by the signs around it. Where signs
    /// are not proved, the stretch is divided.
    void decide(std::span<const RayTask> tasks, std::span<const std::size_t> which,
                std::span<TaskOutcome> outcomes) {
        field_.ranges.clear();
        for (const std::size_t i : which) {
            field_.ranges.push(tasks[i].pixel, tasks[i].stretch.from);
            field_.ranges.push(tasks[i].pixel, tasks[i].stretch.to);
        }
        field_.ranges.evaluate();
        refinements_.clear();
        open_.clear();
        for (std::size_t k = 0; k < which.size(); ++k) {
            const std::size_t i = which[k];
            const Stretch& t = tasks[i].stretch;
            const EndSign before = field_.ranges.sign(2 * k);
            const EndSign behind = field_.ranges.sign(2 * k + 1);
            outcomes[i].bisect(t);
            if (are_equal(before, behind)) outcomes[i].reject();
            if (!are_opposite(before, behind)) continue;
            open_.push_back({.task = i, .refinement = refinements_.size()});
            refinements_.push_back({.pixel = tasks[i].pixel,
                                    .from = t.from,
                                    .to = t.to,
                                    .rises = before == EndSign::Below,
                                    .tolerance = 0.25 * tasks[i].finest});
        }
        refiner_.run(field_, refinements_);
        for (const double margin : {0.5, 1.5})
            prove(tasks, outcomes, margin);
    }

private:
    struct Root {
        std::size_t task, refinement;
        double from = 0.0, to = 0.0;  ///< where signs are asked for
    };

    /// Takes those roots for proved that lie between opposite signs, so many finest stretches away.
    void prove(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes, double margin) {
        field_.ranges.clear();
        for (Root& root : open_) {
            const RayTask& task = tasks[root.task];
            const double away = margin * task.finest;
            const double at = refinements_[root.refinement].root;
            root.from = std::max(task.stretch.from, at - away);
            root.to = std::min(task.stretch.to, at + away);
            field_.ranges.push(task.pixel, root.from);
            field_.ranges.push(task.pixel, root.to);
        }
        field_.ranges.evaluate();
        std::size_t box = 0;
        std::erase_if(open_, [&](const Root& root) {
            const EndSign before = field_.ranges.sign(box);
            const EndSign behind = field_.ranges.sign(box + 1);
            box += 2;
            const Refinement& found = refinements_[root.refinement];
            const EndSign first = found.rises ? EndSign::Below : EndSign::Above;
            const bool is_proved = before == first && are_opposite(first, behind);
            if (is_proved) outcomes[root.task].take_root(root.from, root.to, found.root);
            return is_proved;
        });
    }

    RayField<Real>& field_;
    RootRefiner refiner_;
    std::vector<Refinement> refinements_;
    std::vector<Root> open_;
};

}  // namespace zeroset
