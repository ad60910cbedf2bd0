#include "engine/antialias/wall_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace zeroset {
namespace {

/// Between two points of a line, in halves of the square's side.
constexpr double least_length = 0.4;

double length_between(const WallWays& ways) {
    const SquareRay a = ways.middle(0);
    const SquareRay b = ways.middle(1);
    return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

}  // namespace

std::optional<WallWays> wall_between(std::span<const WallPlace> places) {
    struct Way {
        SquareRay hit, miss;
    };
    std::vector<Way> ways;
    for (const WallPlace& from : places) {
        for (const WallPlace& to : places) {
            if (from.hit && !to.hit) ways.push_back({.hit = from.at, .miss = to.at});
        }
    }
    // The two that are farthest apart.
    std::optional<WallWays> best;
    double farthest = 0.0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const WallWays both{.hit = {ways[i].hit, ways[k].hit},
                                .miss = {ways[i].miss, ways[k].miss}};
            const double apart = length_between(both);
            if (apart <= farthest) continue;
            farthest = apart;
            best = both;
        }
    }
    return best;
}

std::optional<LinearOnSquare> line_of_wall(std::span<const WallPlace> places,
                                           const WallWays& ways) {
    const SquareRay a = ways.middle(0);
    const SquareRay b = ways.middle(1);
    if (!(length_between(ways) > least_length)) return std::nullopt;
    LinearOnSquare line{.value = 0.0, .by_x = a.y - b.y, .by_y = b.x - a.x};
    line.value = -line.at(a);
    const auto hit = std::ranges::find(places, true, &WallPlace::hit);
    if (line.at(hit->at) > 0.0) line = -line;
    const bool divides = std::ranges::all_of(
        places, [&](const WallPlace& place) { return place.hit == (line.at(place.at) <= 0.0); });
    return divides ? std::optional(line) : std::nullopt;
}

}  // namespace zeroset
