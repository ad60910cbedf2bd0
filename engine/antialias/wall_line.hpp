#pragma once

#include "engine/antialias/half_square.hpp"
#include "engine/antialias/square_rays.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace zeroset {

/// A place of a square, and whether its ray has a root.
struct WallPlace {
    SquareRay at;
    bool hit;
};

/// Two ways across a square, each from a place whose ray has a root to one whose ray has none.
struct WallWays {
    std::array<SquareRay, 2> hit, miss;

    /// The middle of a way.
    [[nodiscard]] SquareRay middle(std::size_t way) const {
        return {.x = 0.5 * (hit[way].x + miss[way].x), .y = 0.5 * (hit[way].y + miss[way].y)};
    }
};

/// The rays of a square, and its corners.
inline constexpr std::size_t most_wall_places = square_ray_count + square_corners.size();

/// Such ways between places, so many at most, far apart; none if all have roots, or none has.
std::optional<WallWays> wall_between(std::span<const WallPlace> places);

/// The line through the middles of both ways, below 0 where rays have roots; nothing unless it
/// divides the places as they are.
std::optional<LinearOnSquare> line_of_wall(std::span<const WallPlace> places, const WallWays& ways);

}  // namespace zeroset
