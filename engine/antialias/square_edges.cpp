#include "engine/antialias/square_edges.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/square_depths.hpp"
#include "engine/rays/root_search.hpp"

#include <algorithm>
#include <array>
#include <variant>

namespace zeroset {
namespace {

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

bool SquareEdges::decide_broken_ray(std::size_t square, const RayStretch& stretch) {
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

bool SquareEdges::decide_ray(std::size_t square, const RayStretch& stretch) {
    if (!field_.fronts(square)[surface_].continuous) return decide_broken_ray(square, stretch);
    if (!stretch.has_root()) return pass(square);
    drafts_.add(field_.square(square), square_middle, 1.0, stretch.from, stretch.at,
                Certificate::Certified);
    return false;
}

bool SquareEdges::show(std::size_t square, const EdgeCover& cover) {
    if (cover.share > 0.0)
        drafts_.add(field_.square(square), cover.place, cover.share, cover.from, cover.to,
                    cover.certificate);
    field_.keep_rest(square, surface_, cover.rest);
    return false;
}

bool SquareEdges::act(std::size_t square, const EdgeSquare& edge, const EdgeVerdict& verdict) {
    if (const auto* const cover = std::get_if<EdgeCover>(&verdict)) return show(square, *cover);
    switch (std::get<EdgeStep>(verdict)) {
        case EdgeStep::Pass: return pass(square);
        case EdgeStep::LeavePlain: field_.leave_plain(square); break;
        case EdgeStep::Divide: field_.divide(square); break;
        case EdgeStep::DivideIntoRays: field_.divide_into_rays(square); break;
        case EdgeStep::SeekCreases: creases_.add(square, edge.stretches, edge.samples); break;
        case EdgeStep::Rough: {
            const bool is_sheet = may_be_touched(edge) && is_touched_nearby(edge.stretches);
            return act(square, edge, rough_verdict(edge, is_sheet));
        }
    }
    return false;
}

bool SquareEdges::decide_at_walls(std::size_t square, SquareStretches stretches,
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
    switch (walls_.take_line(square, stretches, corners, line_rules(at, false), may_fold)) {
        case SquareWalls::Choice::None: break;
        case SquareWalls::Choice::Taken: return false;
        case SquareWalls::Choice::Outside: return pass(square);
    }
    // Pass where f keeps its sign on all rays, or divide where it may fold between their ends.
    if (!front.kinked && signs_of(stretches) == Signs::Kept) {
        if (!may_fold) return pass(square);
        field_.divide(square);
        return false;
    }
    // Fit a line to the samples; then seek a wall that cuts the square.
    const EdgeSquare edge{.square = at,
                          .front = front,
                          .stretches = stretches,
                          .samples = samples_at_walls(at, front, stretches)};
    const auto line = line_at_walls(edge);
    switch (walls_.add(square, stretches, corners, line)) {
        case SquareWalls::Choice::None: break;
        case SquareWalls::Choice::Taken: return false;
        case SquareWalls::Choice::Outside: return pass(square);
    }
    return act(square, edge, line ? line_verdict(edge, *line) : EdgeStep::Rough);
}

bool SquareEdges::decide_one(std::size_t square, SquareStretches stretches,
                             CornerStretches corners) {
    const Front& front = field_.fronts(square)[surface_];
    const bool is_inside = front.is_inside(front.at, front.to);
    if (front.continuous && !is_inside) return decide_at_walls(square, stretches, corners);
    const EdgeSquare edge{.square = field_.square(square),
                          .front = front,
                          .stretches = stretches,
                          .samples = edge_samples(stretches)};
    if (!front.continuous) return act(square, edge, EdgeStep::Rough);
    return act(square, edge,
               inside_verdict(edge, field_.is_hit_between(square, front.at, front.to)));
}

bool SquareEdges::decide_line(std::size_t square, std::size_t i) {
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
    SquareRayFlags misses{};
    for (std::size_t k = 0; k < square_ray_count; ++k)
        misses[k] = (hits >> k & 1U) == 0;
    return show(square, {.place = {.x = part.x, .y = part.y},
                         .share = part.share,
                         .from = front.at,
                         .to = lines_.end[i],
                         .certificate = Certificate::Certified,
                         .rest = rest_beside(part, misses)});
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
        if (decide_one(squares[k], of_square, corners.first<square_corners.size()>()))
            open.push_back(squares[k]);
    }
}

void SquareEdges::decide_lines(std::span<const std::size_t> squares, bool all_rays,
                               std::vector<std::size_t>& open) {
    lines_.all_rays = all_rays;
    lines_.side = field_.square(squares.front()).side;
    lines_.rules = line_rules(field_.square(squares.front()), true);
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
        } else if (is_line ? decide_line(squares[i], i)
                           : decide_one(squares[i], lines_.stretches[i],
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
        if (decide_ray(squares[k], stretches[k])) open.push_back(squares[k]);
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
