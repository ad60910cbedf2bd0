#include "engine/antialias/square_creases.hpp"

#include "engine/antialias/crease_fit.hpp"

#include <algorithm>
#include <span>

namespace zeroset {

void SquareCreases::add(std::size_t square, const Front& front) {
    Task task{.square = square, .is_covered = true, .roots = {}};
    const CoverSquare& at = field_.square(square);
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        task.roots[i] = {.col = SquareField::col_of(at, square_rays[i]),
                         .row = SquareField::row_of(at, square_rays[i]),
                         .from = front.at,
                         .to = front.to,
                         .several = !front.monotone};
    }
    tasks_.push_back(task);
}

void SquareCreases::add(std::size_t square, const SquareStretches& stretches,
                        const EdgeSamples& samples) {
    Task task{.square = square, .is_covered = is_all_below(samples), .roots = {}};
    for (std::size_t i = 0; i < square_ray_count; ++i)
        task.roots[i] = samples.bracket(stretches, i);
    tasks_.push_back(task);
}

bool SquareCreases::show(const Task& task, const SquareRoots& roots) {
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
    std::vector<RayRoot> roots;
    roots.reserve(tasks_.size() * square_ray_count);
    for (const Task& task : tasks_)
        roots.insert(roots.end(), task.roots.begin(), task.roots.end());
    find_roots(frame_, field_.rays(), roots, counters_);
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
        SquareRoots of_square{};
        std::ranges::copy(std::span(roots).subspan(k * square_ray_count, square_ray_count),
                          of_square.begin());
        if (!show(tasks_[k], of_square)) field_.divide(tasks_[k].square);
    }
    tasks_.clear();
}

}  // namespace zeroset
