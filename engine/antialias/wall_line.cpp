#include "engine/antialias/wall_line.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace zeroset {
namespace {

/// Between two points of a line, in halves of the square's side.
constexpr double least_length = 0.4;

double square_of_length(const SquareRay& a, const SquareRay& b) {
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

}  // namespace

std::optional<WallWays> wall_between(std::span<const WallPlace> places) {
    struct Way {
        SquareRay hit, miss, middle;
    };
    std::array<Way, most_wall_places * most_wall_places / 4> ways;
    std::size_t count = 0;
    for (const WallPlace& from : places) {
        for (const WallPlace& to : places) {
            if (!from.hit || to.hit) continue;
            ways[count++] = {
                .hit = from.at,
                .miss = to.at,
                .middle = {.x = 0.5 * (from.at.x + to.at.x), .y = 0.5 * (from.at.y + to.at.y)}};
        }
    }
    // The two that are farthest apart.
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
    return WallWays{.hit = {ways[best[0]].hit, ways[best[1]].hit},
                    .miss = {ways[best[0]].miss, ways[best[1]].miss}};
}

std::optional<LinearOnSquare> line_of_wall(std::span<const WallPlace> places,
                                           const WallWays& ways) {
    const SquareRay a = ways.middle(0);
    const SquareRay b = ways.middle(1);
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
