#include "engine/antialias/square_creases.hpp"

#include "engine/antialias/edge_fit.hpp"

#include <algorithm>
#include <span>

namespace zeroset {

void SquareCreases::add(std::size_t square, const Front& front) {
    tasks_.push_back({.square = square, .is_covered = true});
    const CoverSquare& at = field_.square(square);
    for (const SquareRay& ray : square_rays) {
        RayRoot& root = roots_.emplace_back();
        root.col = SquareField::col_of(at, ray);
        root.row = SquareField::row_of(at, ray);
        root.from = front.at;
        root.to = front.to;
        root.several = !front.monotone;
    }
}

void SquareCreases::add(std::size_t square, SquareStretches stretches, const EdgeSamples& samples) {
    tasks_.push_back({.square = square, .is_covered = is_all_below(samples)});
    for (std::size_t i = 0; i < square_ray_count; ++i)
        roots_.push_back(samples.bracket(stretches, i));
}

bool SquareCreases::show(const Task& task, SquareRoots roots) {
    const CoverSquare& square = field_.square(task.square);
    const auto creased = fit_crease(roots, 0.5 * square.side);
    if (!creased || (!task.is_covered && creased->grazed)) return false;
    if (creased->bent) {
        for (const RayRoot& root : std::span(roots).subspan(1))
            drafts_.add(square, 0.25, root);
        return true;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        if (creased->parts[i].share > 0.0)
            drafts_.add(square, creased->parts[i].share, roots[creased->rays[i]]);
    }
    return true;
}

void SquareCreases::decide() {
    if (tasks_.empty()) return;
    find_roots(frame_, field_.rays(), roots_, counters_);
    const std::span<const RayRoot> roots(roots_);
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
        const SquareRoots of_square(roots.subspan(k * square_ray_count).first<square_ray_count>());
        if (!show(tasks_[k], of_square)) field_.divide(tasks_[k].square);
    }
    tasks_.clear();
    roots_.clear();
}

}  // namespace zeroset
