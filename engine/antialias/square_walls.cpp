#include "engine/antialias/square_walls.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/square_depths.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace zeroset {
namespace {

/// Where the sheet is that all rays of a square meet, as f at the ends of their stretches tells: a
/// depth at its middle, and how it changes over the square.
std::optional<LinearOnSquare> sheet_of(SquareStretches stretches) {
    std::array<double, square_ray_count> depth{};
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const RayStretch& ray = stretches[i];
        const double part = ray.near / (ray.near - ray.far);
        if (ray.is_empty() || !(part >= 0.0 && part <= 1.0)) return std::nullopt;
        depth[i] = ray.from + part * (ray.to - ray.from);
    }
    return LinearOnSquare{.value = depth[0],
                          .by_x = 0.5 * (depth[2] + depth[4] - depth[1] - depth[3]),
                          .by_y = 0.5 * (depth[3] + depth[4] - depth[1] - depth[2])};
}

}  // namespace

auto SquareWalls::add(std::size_t square, SquareStretches stretches,
                      const std::optional<LinearOnSquare>& fit) -> Choice {
    const Front& front = field_.fronts(square)[surface_];
    std::array<bool, square_corners.size()> outside_at{};
    std::size_t outside_count = 0;
    for (const RayStretch& stretch : stretches)
        outside_count += stretch.is_empty() ? 1U : 0U;
    const CoverSquare& at = field_.square(square);
    std::array<RayStretch, square_corners.size()> corners{};
    for (std::size_t i = 0; i < square_corners.size(); ++i)
        corners[i] = SquareField::stretch_of(at, front, square_corners[i]);
    field_.clip(front, corners);
    const auto sheet = fit && front.at < front.inside_from ? sheet_of(stretches) : std::nullopt;
    for (std::size_t i = 0; i < square_corners.size(); ++i) {
        outside_at[i] = corners[i].is_empty();
        // Rays may enter behind the sheet.
        if (sheet && corners[i].from > front.at && corners[i].from > sheet->at(square_corners[i]))
            outside_at[i] = true;
        outside_count += outside_at[i] ? 1U : 0U;
    }
    if (outside_count == 0) return Choice::None;
    const bool outside = outside_count == square_ray_count + square_corners.size();
    if (outside && at.level >= first_flat_level) return Choice::Outside;
    WallPlaces places;
    for (std::size_t i = 0; i < square_ray_count; ++i)
        places.push({.at = square_rays[i], .hit = stretches[i].has_root()});
    for (std::size_t i = 0; i < square_corners.size(); ++i) {
        const SquareRay& corner = square_corners[i];
        if (outside_at[i] || fit)
            places.push({.at = corner, .hit = !outside_at[i] && fit->at(corner) <= 0.0});
    }
    const auto ways = wall_between(places.all());
    if (!ways) return Choice::None;
    tasks_.push_back({.square = square, .stretches = {}, .places = places, .ways = *ways});
    std::ranges::copy(stretches, tasks_.back().stretches.begin());
    return Choice::Sought;
}

void SquareWalls::narrow() {
    constexpr int halvings = 9;
    std::vector<RayStretch> stretches;
    for (int i = 0; i < halvings; ++i) {
        stretches.clear();
        for (const Task& task : tasks_) {
            const Front& front = field_.fronts(task.square)[surface_];
            for (std::size_t way = 0; way < 2; ++way)
                stretches.push_back(SquareField::stretch_of(field_.square(task.square), front,
                                                            task.ways.middle(way)));
        }
        clip_stretches(field_.rays(), stretches);
        find_least(frame_, field_.rays(), stretches, counters_);
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            WallWays& ways = tasks_[k / 2].ways;
            const SquareRay middle = ways.middle(k % 2);
            (stretches[k].has_root() ? ways.hit : ways.miss)[k % 2] = middle;
        }
    }
}

void SquareWalls::show(const Task& task, const LinearOnSquare& line) {
    SquareRayFlags misses{};
    std::size_t hit = 0;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        misses[i] = !task.stretches[i].has_root();
        if (!misses[i]) hit = i;
    }
    const SquarePart part = part_below_zero(line);
    const RayStretch& ray = task.stretches[hit];
    drafts_.add(field_.square(task.square), square_rays[hit], part.share, ray.from, ray.at,
                Certificate::Certified);
    field_.keep_rest(task.square, surface_,
                     {.share = 1.0 - part.share, .part = part.rest(), .misses = misses});
}

void SquareWalls::decide() {
    if (tasks_.empty()) return;
    narrow();
    for (const Task& task : tasks_) {
        const auto line = line_of_wall(task.places.all(), task.ways);
        if (line) {
            show(task, *line);
        } else if (field_.square(task.square).level < last_wall_level) {
            field_.divide(task.square);
        }
    }
    tasks_.clear();
}

}  // namespace zeroset
