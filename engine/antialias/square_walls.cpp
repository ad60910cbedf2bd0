#include "engine/antialias/square_walls.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/square_depths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace zeroset {
namespace {

/// Where the sheet is at the latest that all rays of a square meet, as f at the ends of their
/// stretches tells: a depth at its middle, and how it changes over the square.
std::optional<LinearOnSquare> sheet_of(SquareStretches stretches) {
    std::array<double, square_ray_count> depth{};
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const RayStretch& ray = stretches[i];
        const double part = ray.near / (ray.near - ray.far);
        if (ray.is_empty() || !(part >= 0.0 && part <= 1.0)) return std::nullopt;
        depth[i] = ray.from + part * (ray.to - ray.from);
    }
    // Corners are twice as far from the middle as the other rays: a sheet bends four times as much.
    const double mean = 0.25 * (depth[1] + depth[2] + depth[3] + depth[4]);
    const double twist = 0.25 * (depth[1] + depth[4] - depth[2] - depth[3]);
    const double bend = std::abs(mean - depth[0]) + std::abs(twist);
    return LinearOnSquare{.value = depth[0] + 4.0 * bend,
                          .by_x = 0.5 * (depth[2] + depth[4] - depth[1] - depth[3]),
                          .by_y = 0.5 * (depth[3] + depth[4] - depth[1] - depth[2])};
}

/// Whether a line takes corners for parts with a root whose stretches are empty.
bool is_cut(const LinearOnSquare& line, CornerStretches corners) {
    for (std::size_t i = 0; i < square_corners.size(); ++i) {
        if (corners[i].is_empty() && line.at(square_corners[i]) <= 0.0) return true;
    }
    return false;
}

}  // namespace

void SquareWalls::Task::take(SquareStretches stretches) {
    std::size_t hit = 0;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        misses[i] = !stretches[i].has_root();
        if (!misses[i]) hit = i;
    }
    shown = square_rays[hit];
    from = stretches[hit].from;
    to = stretches[hit].at;
}

auto SquareWalls::take_line(std::size_t square, SquareStretches stretches, CornerStretches corners,
                            const LineRules& rules, bool is_long) -> Choice {
    const Front& front = field_.fronts(square)[surface_];
    const bool all_enter = front.inside_from <= front.inside_to;
    if (front.kinked || !all_enter || !are_ends_even(stretches, corners)) return Choice::None;
    for (const WallEnd& wall : {entry_wall, exit_wall}) {
        const auto samples = wall_samples(stretches, wall);
        if (!samples) continue;
        const auto line = fit_edge(*samples, rules.error, rules.flat_too);
        if (line && !is_cut(*line, corners))
            return take_part(square, stretches, *samples, *line, is_long);
    }
    return Choice::None;
}

auto SquareWalls::take_part(std::size_t square, SquareStretches stretches,
                            const EdgeSamples& samples, const LinearOnSquare& line, bool is_long)
    -> Choice {
    const SquarePart part = part_below_zero(line);
    // Rays tell too little of a large rest, and not which of several surfaces is first.
    const bool is_pixel = field_.square(square).level == 0;
    const bool is_sliver = is_pixel && part.share > 0.0 && part.share < 0.02;
    const bool is_small = part.share < (is_pixel ? 0.5 : 0.01);
    if (is_sliver || (is_long && (is_small || !field_.is_of_one_surface()))) {
        field_.divide(square);
        return Choice::Taken;
    }
    if (!(part.share > 0.0)) return Choice::Outside;
    const CoverSquare& at = field_.square(square);
    const SquareRay middle{.x = part.x, .y = part.y};
    // Draw the part by the ray in its middle, or by the nearest ray with a root.
    if (samples.roots() == 0) {
        const RayStretch stretch = stretch_at(stretches, middle);
        drafts_.add(at, middle, part.share, stretch.from, stretch.to, Certificate::Certified);
    } else {
        const std::size_t nearest = samples.nearest_hit(middle);
        const RayRoot root = samples.bracket(stretches, nearest);
        drafts_.add(at, square_rays[nearest], part.share, root.from, root.to,
                    Certificate::Certified);
    }
    const SquareRest rest = rest_beside(part, samples.misses());
    if (is_long) {
        field_.divide_whole_rest(square, rest);
    } else {
        field_.keep_rest(square, surface_, rest);
    }
    return Choice::Taken;
}

auto SquareWalls::add(std::size_t square, SquareStretches stretches, CornerStretches corners,
                      const std::optional<LinearOnSquare>& fit) -> Choice {
    const Front& front = field_.fronts(square)[surface_];
    std::array<bool, square_corners.size()> outside_at{};
    std::size_t outside_count = 0;
    for (const RayStretch& stretch : stretches)
        outside_count += stretch.is_empty() ? 1U : 0U;
    // Find corners outside of the clip region, or whose rays enter behind the sheet.
    const auto sheet = fit && front.at < front.inside_from ? sheet_of(stretches) : std::nullopt;
    for (std::size_t i = 0; i < square_corners.size(); ++i) {
        outside_at[i] = corners[i].is_empty();
        // Rays may enter behind the sheet.
        if (sheet && corners[i].from > front.at && corners[i].from > sheet->at(square_corners[i]))
            outside_at[i] = true;
        outside_count += outside_at[i] ? 1U : 0U;
    }
    if (outside_count == 0) return Choice::None;
    const bool outside = outside_count == most_wall_places;
    if (outside && field_.square(square).level >= first_flat_level) return Choice::Outside;
    // Collect the places whose rays are known to have roots, or none.
    WallPlaces places;
    for (std::size_t i = 0; i < square_ray_count; ++i)
        places.push({.at = square_rays[i], .hit = stretches[i].has_root(), .ray = i});
    for (std::size_t i = 0; i < square_corners.size(); ++i) {
        const SquareRay& corner = square_corners[i];
        if (outside_at[i] || fit)
            places.push({.at = corner,
                         .hit = !outside_at[i] && fit->at(corner) <= 0.0,
                         .ray = square_ray_count + i});
    }
    // Seek the wall along two ways between these places.
    const auto ways = wall_between(places.all());
    if (!ways) return Choice::None;
    Task& task = tasks_.emplace_back();
    task.square = square;
    task.places = places;
    task.take(stretches);
    const auto ray_of = [&](const WallPlace& place) {
        const bool is_corner = place.ray >= square_ray_count;
        return is_corner ? WallRay(corners[place.ray - square_ray_count], false)
                         : WallRay(stretches[place.ray], true);
    };
    for (std::size_t i = 0; i < task.ways.size(); ++i) {
        const WallPlace& from = ways->hit[i];
        const WallPlace& to = ways->miss[i];
        task.ways[i] = WallWay(from.at, ray_of(from), to.at, ray_of(to));
    }
    return Choice::Taken;
}

void SquareWalls::narrow() {
    open_.clear();
    for (Task& task : tasks_) {
        for (WallWay& way : task.ways)
            open_.push_back({.task = &task, .way = &way});
    }
    while (!open_.empty() && !frame_.stopped()) {
        stretches_.clear();
        for (const Open& at : open_) {
            const std::size_t square = at.task->square;
            stretches_.push_back(SquareField::stretch_of(
                field_.square(square), field_.fronts(square)[surface_], at.way->next()));
        }
        clip_stretches(field_.rays(), stretches_);
        find_least(frame_, field_.rays(), stretches_, counters_);
        for (std::size_t i = 0; i < open_.size(); ++i)
            open_[i].way->take(stretches_[i]);
        std::erase_if(open_, [](const Open& at) { return at.way->is_done(); });
    }
}

void SquareWalls::show(const Task& task, const LinearOnSquare& line) {
    const SquarePart part = part_below_zero(line);
    drafts_.add(field_.square(task.square), task.shown, part.share, task.from, task.to,
                Certificate::Certified);
    field_.keep_rest(task.square, surface_, rest_beside(part, task.misses));
}

void SquareWalls::decide() {
    if (tasks_.empty()) return;
    narrow();
    for (const Task& task : tasks_) {
        const auto line = line_of_wall(task.places.all(), task.ways[0].wall(), task.ways[1].wall());
        if (line) {
            show(task, *line);
        } else if (field_.square(task.square).level < last_wall_level) {
            field_.divide(task.square);
        }
    }
    tasks_.clear();
}

}  // namespace zeroset
