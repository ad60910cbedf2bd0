#include "engine/antialias/wall_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// The least distance of two points that tell a line, in halves of the square's side.
constexpr double least_length = 0.4;

double square_of_length(const SquareRay& a, const SquareRay& b) {
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

}  // namespace

bool WallRay::heights(const WallRay& miss, double& here, double& there) const {
    const bool outside = miss.length_ < 0.0;
    if (outside) {
        here = -length_;
        there = -miss.length_;
        return here < 0.0;
    }
    if (!has_f_ || !miss.has_f_) return false;
    const auto differ = [](double a, double b) { return (a >= 0.0) != (b >= 0.0); };
    const bool at_entry = differ(near_, miss.near_);
    if (at_entry == differ(far_, miss.far_)) return false;
    const double at_hit = at_entry ? near_ : far_;
    const double at_miss = at_entry ? miss.near_ : miss.far_;
    here = -std::abs(at_hit);
    there = std::abs(at_miss);
    return std::isfinite(here) && std::isfinite(there) && there - here > 0.0;
}

double WallWay::choose() const {
    const double length = miss_at_ - hit_at_;
    const double middle = hit_at_ + 0.5 * length;
    // Halves, too, so that the way is soon short whatever heights tell.
    if (steps_ % 4 == 3) return middle;
    double here = 0.0;
    double there = 0.0;
    if (!hit_.heights(miss_, here, there)) return middle;
    // The end that stood still counts less, as in the Illinois method.
    if (same_side_ > 1) (last_hit_ ? there : here) *= 0.5;
    const double wall = hit_at_ + length * (here / (here - there));
    const double aside = last_hit_ || steps_ == 0 ? 0.45 * error : -0.45 * error;
    const double least = std::min(0.5 * error, 0.5 * length);
    return std::clamp(wall + aside, hit_at_ + least, miss_at_ - least);
}

void WallWay::take(const RayStretch& ray) {
    ++steps_;
    same_side_ = ray.has_root() == last_hit_ ? same_side_ + 1 : 1;
    last_hit_ = ray.has_root();
    (last_hit_ ? hit_at_ : miss_at_) = next_;
    (last_hit_ ? hit_ : miss_) = WallRay(ray, true);
}

std::optional<WallWays> wall_between(std::span<const WallPlace> places) {
    struct Way {
        const WallPlace *hit, *miss;
        SquareRay middle;
    };
    std::array<Way, most_wall_places * most_wall_places / 4> ways;
    std::size_t count = 0;
    for (const WallPlace& from : places) {
        for (const WallPlace& to : places) {
            if (!from.hit || to.hit) continue;
            ways[count++] = {
                .hit = &from,
                .miss = &to,
                .middle = {.x = 0.5 * (from.at.x + to.at.x), .y = 0.5 * (from.at.y + to.at.y)}};
        }
    }
    // Choose the two ways that are farthest apart.
    std::array<std::size_t, 2> best{};
    double farthest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const double apart = square_of_length(ways[i].middle, ways[k].middle);
            if (apart <= farthest) continue;
            farthest = apart;
            best = {i, k};
        }
    }
    if (!(farthest > 0.0)) return std::nullopt;
    return WallWays{.hit = {*ways[best[0]].hit, *ways[best[1]].hit},
                    .miss = {*ways[best[0]].miss, *ways[best[1]].miss}};
}

std::optional<LinearOnSquare> line_of_wall(std::span<const WallPlace> places, const SquareRay& a,
                                           const SquareRay& b) {
    if (!(square_of_length(a, b) > least_length * least_length)) return std::nullopt;
    LinearOnSquare line{.value = 0.0, .by_x = a.y - b.y, .by_y = b.x - a.x};
    line.value = -line.at(a);
    const auto hit = std::ranges::find(places, true, &WallPlace::hit);
    if (line.at(hit->at) > 0.0) line = -line;
    const bool divides = std::ranges::all_of(
        places, [&](const WallPlace& place) { return place.hit == (line.at(place.at) <= 0.0); });
    return divides ? std::optional(line) : std::nullopt;
}

}  // namespace zeroset
