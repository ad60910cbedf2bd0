#include "engine/antialias/square_edges.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/square_depths.hpp"
#include "engine/rays/root_search.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace zeroset {
namespace {

constexpr SquarePart unknown_part{.share = 0.0, .x = 0.0, .y = 0.0};

constexpr LinearOnSquare all_of_square{.value = -1.0, .by_x = 0.0, .by_y = 0.0};

/// The level of which edges are not divided.
int last_level_of(bool is_inside) { return is_inside ? last_edge_level : last_wall_level; }

LineRules rules_of(const CoverSquare& square, bool is_inside) {
    return {.error = square.level < last_level_of(is_inside)
                         ? std::min(most_error_of_line / square.side, most_error_of_edge)
                         : 2.0 * most_error_of_edge,
            .flat_too = square.level >= first_flat_level,
            .may_hide = square.level < first_one_slope_level};
}

std::optional<LinearOnSquare> line_of(const EdgeSamples& samples, const CoverSquare& square,
                                      bool is_inside) {
    const LineRules rules = rules_of(square, is_inside);
    return fit_edge(samples, rules.error, rules.flat_too);
}

/// The edge of a root that rays may miss at their far ends, or have cut away where they enter.
std::optional<LinearOnSquare> line_at_walls(const EdgeSamples& samples, SquareStretches stretches,
                                            const CoverSquare& square) {
    const EdgeSamples entry = entry_samples(stretches);
    const bool is_entry_below = is_all_below(entry);
    const bool is_least_below = is_all_below(samples);
    if (is_entry_below && is_least_below) return all_of_square;
    if (is_entry_below) return line_of(samples, square, false);
    return is_least_below ? line_of(entry, square, false) : std::nullopt;
}

/// Whether f, which is above 0 where samples are, may come to 0 and go away again between the ends
/// of long stretches: it is least at an end of each.
bool may_hide_roots(const EdgeSamples& samples, SquareStretches stretches,
                    const CoverSquare& square) {
    const bool any_inner =
        std::ranges::any_of(stretches, [](const RayStretch& ray) { return ray.inner; });
    return rules_of(square, true).may_hide && !any_inner && samples.roots() == 0;
}

EdgeSamples samples_at_walls(SquareStretches stretches, const CoverSquare& square,
                             const Front& front) {
    if (!front.kinked && square.level >= first_one_end_level) {
        if (const auto at_one_end = one_end_samples(stretches)) return *at_one_end;
    }
    return edge_samples(stretches);
}

/// Whether a square's stretches are long beside its width: f may come to 0 in them several times.
bool is_long(const SquareField& field, const CoverSquare& square, const Front& front) {
    const double most = square.level < first_one_slope_level ? 4.0 : 12.0;  // fair lengths
    return front.to - front.at > most * field.fair_length(square, front.at);
}

/// Calls do_some for `squares`, at most so many at once.
template <class DoSome>
void for_each_part(std::span<const std::size_t> squares, std::size_t most, const DoSome& do_some) {
    for (; !squares.empty(); squares = squares.subspan(std::min(most, squares.size())))
        do_some(squares.first(std::min(most, squares.size())));
}

}  // namespace

bool SquareEdges::are_inside(std::span<const std::size_t> squares) const {
    return std::ranges::all_of(squares, [&](std::size_t square) {
        const Front& front = field_.fronts(square)[surface_];
        return front.is_inside(front.at, front.to);
    });
}

bool SquareEdges::take_broken_ray(std::size_t square, const RayStretch& stretch) {
    if (stretch.is_empty()) return pass(square);
    const TileRays& rays = field_.rays();
    const glm::dvec3 begin = rays.point(stretch.col, stretch.row, stretch.from);
    const glm::dvec3 end = rays.point(stretch.col, stretch.row, stretch.to);
    const double length = glm::distance(begin, end);
    if (!(length > 0.0)) return pass(square);
    const SceneRay ray{.origin = begin, .direction = UnitVector(end - begin), .to = length};
    const RootFinding finding =
        search_ray(frame_, ray, RayStart::Anywhere, RootWish::First, counters_);
    if (!finding.bracket) return pass(square);
    const auto depth_of = [&](double t) {
        return stretch.from + (stretch.to - stretch.from) * (t / length);
    };
    drafts_.add(field_.square(square), square_middle, 1.0, depth_of(finding.bracket->from),
                depth_of(finding.bracket->to),
                finding.bracket->is_proved ? Certificate::Certified : Certificate::Undecided);
    return false;
}

bool SquareEdges::take_ray(std::size_t square, const RayStretch& stretch) {
    if (!field_.fronts(square)[surface_].continuous) return take_broken_ray(square, stretch);
    if (!stretch.has_root()) return pass(square);
    drafts_.add(field_.square(square), square_middle, 1.0, stretch.from, stretch.at,
                Certificate::Certified);
    return false;
}

bool SquareEdges::take_at_walls(std::size_t square, SquareStretches stretches,
                                CornerStretches corners) {
    const CoverSquare& at = field_.square(square);
    const Front& front = field_.fronts(square)[surface_];
    // Leave a pixel whose surface lies in a wall to its own hit.
    if (at.whole != nullptr && is_flush(stretches, corners)) {
        field_.leave_plain(square);
        return false;
    }
    const bool may_fold = at.level < first_flat_level && is_long(field_, at, front);
    // Try a line in one wall that all rays cross.
    switch (walls_.take_line(square, stretches, corners, rules_of(at, false), may_fold)) {
        case SquareWalls::Choice::None: break;
        case SquareWalls::Choice::Taken: return false;
        case SquareWalls::Choice::Outside: return pass(square);
    }
    // Pass where f keeps its sign on all rays, or divide where it may fold between their ends.
    const Signs signs = front.kinked ? Signs::Unknown : signs_of(stretches);
    if (signs == Signs::Kept) {
        if (!may_fold) return pass(square);
        field_.divide(square);
        return false;
    }
    // Fit a line to the samples; then seek a wall that cuts the square.
    const EdgeSamples samples = samples_at_walls(stretches, at, front);
    auto fit = samples.before_end.front() ? line_of(samples, at, false)
                                          : line_at_walls(samples, stretches, at);
    if (!fit && samples.roots() == square_ray_count) {
        const bool is_covered = signs == Signs::Changed ||
                                (is_all_below(samples) && is_all_below(entry_samples(stretches)));
        if (is_covered) fit = all_of_square;
    }
    switch (walls_.add(square, stretches, corners, fit)) {
        case SquareWalls::Choice::None: break;
        case SquareWalls::Choice::Taken: return false;
        case SquareWalls::Choice::Outside: return pass(square);
    }
    return fit ? take_line(square, stretches, samples, *fit)
               : take_rough(square, stretches, samples);
}

bool SquareEdges::take_inside(std::size_t square, SquareStretches stretches) {
    const CoverSquare& at = field_.square(square);
    const Front& front = field_.fronts(square)[surface_];
    const EdgeSamples samples = edge_samples(stretches);
    const bool all = samples.roots() == square_ray_count;
    if (all && front.calm && field_.is_hit_between(square, front.at, front.to)) {
        field_.leave_plain(square);
        return false;
    }
    // Try a line, then a thread.
    const auto fit = line_of(samples, at, true);
    if (!fit) {
        const auto thread = fit_thread(stretches, 0.5 * at.side, 2.0 * thinnest_thread / at.side);
        if (thread) return take_thread(square, stretches, samples, *thread);
    }
    if (may_hide_roots(samples, stretches, at)) {
        field_.divide(square);
        return false;
    }
    const bool one_colored = fit && !(front.kinked && is_all_below(samples));
    if (all && !one_colored && at.level < last_color_level) {
        creases_.add(square, stretches, samples);
        return false;
    }
    return fit ? take_line(square, stretches, samples, *fit)
               : take_rough(square, stretches, samples);
}

bool SquareEdges::take(std::size_t square, SquareStretches stretches, CornerStretches corners) {
    const Front& front = field_.fronts(square)[surface_];
    if (!front.continuous) return take_rough(square, stretches, edge_samples(stretches));
    return front.is_inside(front.at, front.to) ? take_inside(square, stretches)
                                               : take_at_walls(square, stretches, corners);
}

bool SquareEdges::take_found_line(std::size_t square, std::size_t i) {
    constexpr unsigned all = (1U << square_ray_count) - 1;
    const CoverSquare& at = field_.square(square);
    const Front& front = field_.fronts(square)[surface_];
    const auto hits = static_cast<unsigned>(lines_.hits[i]);
    if (hits == all && front.calm && field_.is_hit_between(square, front.at, front.to)) {
        field_.leave_plain(square);
        return false;
    }
    const SquarePart part{.share = lines_.share[i], .x = lines_.x[i], .y = lines_.y[i]};
    if (!(part.share > 0.0)) return pass(square);
    if (!(part.share < 1.0) && lines_.folds[i] != 0.0 && at.level < last_color_level) {
        add_uneven(square);
        return false;
    }
    drafts_.add(at, {.x = part.x, .y = part.y}, part.share, front.at, lines_.end[i],
                Certificate::Certified);
    SquareRayFlags misses{};
    for (std::size_t k = 0; k < square_ray_count; ++k)
        misses[k] = (hits >> k & 1U) == 0;
    field_.keep_rest(square, surface_, rest_beside(part, misses));
    return false;
}

bool SquareEdges::take_line(std::size_t square, SquareStretches stretches,
                            const EdgeSamples& samples, const LinearOnSquare& fit) {
    const SquarePart part = part_below_zero(fit);
    if (!(part.share > 0.0)) return pass(square);
    const CoverSquare& at = field_.square(square);
    const bool kinked = field_.fronts(square)[surface_].kinked &&
                        (at.level < first_one_slope_level || !is_one_slope(stretches));
    if (kinked && at.level < last_kinked_edge_level) {
        field_.divide(square);
        return false;
    }
    // The ray in the middle of the part is like most of them; a wall may cut it.
    const SquareRay middle{.x = part.x, .y = part.y};
    const std::size_t nearest = samples.nearest_hit(middle);
    const Front& front = field_.fronts(square)[surface_];
    const bool is_sure = front.is_inside(front.at, front.to) || samples.height[nearest] > 0.0;
    const RayRoot root = samples.bracket(stretches, nearest);
    drafts_.add(at, is_sure ? middle : square_rays[nearest], part.share, root.from, root.to,
                Certificate::Certified);
    field_.keep_rest(square, surface_, rest_beside(part, samples.misses()));
    return false;
}

bool SquareEdges::take_thread(std::size_t square, SquareStretches stretches,
                              const EdgeSamples& samples, const Thread& thread) {
    if (thread.empty) return pass(square);
    const CoverSquare& at = field_.square(square);
    const bool is_proved = thread.half_width > 0.0;
    const double share = thread.share(is_proved ? thread.half_width : thread_width / at.side);
    const RayStretch& ray = stretches[samples.deepest()];
    if (share > 0.0)
        drafts_.add(at, thread.middle(), share, ray.from, ray.at,
                    is_proved ? Certificate::Certified : Certificate::Undecided);
    // Behind the thread, and beside it, is what all rays meet.
    SquareRayFlags beside{};
    beside.fill(true);
    field_.keep_rest(square, surface_,
                     {.share = 1.0 - share, .part = unknown_part, .misses = beside});
    return false;
}

bool SquareEdges::is_touched_nearby(SquareStretches stretches) {
    // Exponentials are small everywhere beside what they are farther away.
    constexpr double reach = 0.25;  // in pixels
    std::array<RayStretch, square_ray_count> near{};
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const RayStretch& ray = stretches[i];
        const double length = field_.width_of(reach, ray.at);
        near[i] = {.col = ray.col,
                   .row = ray.row,
                   .from = std::max(ray.from, ray.at - length),
                   .to = std::min(ray.to, ray.at + length)};
    }
    find_least(frame_, field_.rays(), near, counters_);
    return is_touched_everywhere(edge_samples(near), near);
}

bool SquareEdges::take_rough(std::size_t square, SquareStretches stretches,
                             const EdgeSamples& samples) {
    const CoverSquare& at = field_.square(square);
    const Front& front = field_.fronts(square)[surface_];
    const std::size_t roots = samples.roots();
    const bool is_inside = front.is_inside(front.at, front.to);
    const bool sheet = front.continuous && is_inside && is_touched_everywhere(samples, stretches) &&
                       is_touched_nearby(stretches);
    // Divide down to the last level.
    const int last = front.continuous ? last_level_of(is_inside) : last_broken_level;
    const bool all = sheet || (roots == square_ray_count && at.level >= std::min(last, last_level));
    if (!all && at.level < last) {
        field_.divide(square);
        return false;
    }
    if (!front.continuous) {
        field_.divide_into_rays(square);
        return false;
    }
    // The square is as small as squares get: where f comes near to 0 it is drawn
    // [Florez08, sec. 5.5.2].
    const bool thread = !sheet && roots == 0;
    if (thread && !(is_inside && is_touched(samples, stretches))) return pass(square);
    const std::size_t deepest = samples.deepest();
    const RayRoot root = samples.bracket(stretches, deepest);
    const double rooted = sheet ? 1.0 : static_cast<double>(roots) / square_ray_count;
    drafts_.add(at, square_rays[deepest], thread ? thread_width / at.side : rooted, root.from,
                root.to, roots == 0 ? Certificate::Undecided : Certificate::Certified);
    field_.keep_rest(square, surface_,
                     {.share = 1.0 - rooted, .part = unknown_part, .misses = samples.misses()});
    return false;
}

void SquareEdges::set_stretches(std::span<const std::size_t> squares,
                                std::span<const SquareRay> places, bool inside,
                                std::span<RayStretch> stretches) const {
    std::size_t count = 0;
    for (const std::size_t square : squares) {
        const Front& front = field_.fronts(square)[surface_];
        for (const SquareRay& place : places)
            SquareField::set_stretch(field_.square(square), front, place, stretches[count++]);
    }
    if (!inside) clip_stretches(field_.rays(), stretches.first(count));
}

void SquareEdges::decide_squares(std::span<const std::size_t> squares,
                                 std::vector<std::size_t>& open) {
    const auto stretches = std::span(stretches_).first(square_ray_count * squares.size());
    const bool inside = are_inside(squares);
    set_stretches(squares, square_rays, inside, stretches);
    if (!inside) set_stretches(squares, square_corners, inside, corners_);
    find_least(frame_, field_.rays(), stretches, counters_);
    for (std::size_t k = 0; k < squares.size(); ++k) {
        const auto of_square = stretches.subspan(square_ray_count * k).first<square_ray_count>();
        const auto corners = std::span(corners_).subspan(square_corners.size() * k);
        if (take(squares[k], of_square, corners.first<square_corners.size()>()))
            open.push_back(squares[k]);
    }
}

void SquareEdges::decide_lines(std::span<const std::size_t> squares, bool all_rays,
                               std::vector<std::size_t>& open) {
    lines_.all_rays = all_rays;
    lines_.side = field_.square(squares.front()).side;
    lines_.rules = rules_of(field_.square(squares.front()), true);
    lines_.count = squares.size();
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const CoverSquare& square = field_.square(squares[i]);
        const Front& front = field_.fronts(squares[i])[surface_];
        lines_.col[i] = SquareField::col_of(square, square_middle);
        lines_.row[i] = SquareField::row_of(square, square_middle);
        lines_.from[i] = front.at;
        lines_.to[i] = front.to;
    }
    find_lines(frame_, field_.rays(), lines_, counters_);
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const bool is_line = lines_.is_line[i] != 0.0;
        if (!is_line && !all_rays) {
            unclear_.push_back(squares[i]);
        } else if (is_line ? take_found_line(squares[i], i)
                           : take(squares[i], lines_.stretches[i],
                                  std::span(corners_).first<square_corners.size()>())) {
            open.push_back(squares[i]);
        }
    }
}

void SquareEdges::decide_rays(std::span<const std::size_t> squares,
                              std::vector<std::size_t>& open) {
    const auto stretches = std::span(stretches_).first(squares.size());
    set_stretches(squares, {&square_middle, 1}, are_inside(squares), stretches);
    find_least(frame_, field_.rays(), stretches, counters_);
    for (std::size_t k = 0; k < squares.size(); ++k) {
        if (take_ray(squares[k], stretches[k])) open.push_back(squares[k]);
    }
}

void SquareEdges::sort(std::span<const std::size_t> squares) {
    even_.clear();
    others_.clear();
    for (const std::size_t square : squares) {
        const Front& front = field_.fronts(square)[surface_];
        const bool is_even =
            front.continuous && !front.kinked && front.is_inside(front.at, front.to);
        (is_even ? even_ : others_).push_back(square);
    }
}

void SquareEdges::decide(std::span<const std::size_t> squares, std::vector<std::size_t>& open) {
    const bool are_rays = !squares.empty() && field_.square(squares.front()).is_ray();
    if (are_rays) {
        for_each_part(squares, most_rays, [&](auto some) { decide_rays(some, open); });
    } else {
        sort(squares);
        unclear_.clear();
        for_each_part(even_, EdgeLines::capacity,
                      [&](auto some) { decide_lines(some, false, open); });
        for_each_part(unclear_, EdgeLines::capacity_of_all_rays,
                      [&](auto some) { decide_lines(some, true, open); });
        for_each_part(others_, most_squares, [&](auto some) { decide_squares(some, open); });
    }
    walls_.decide();
    creases_.decide();
    field_.reopen(open);
}

}  // namespace zeroset
