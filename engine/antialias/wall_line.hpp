#pragma once

#include "engine/antialias/half_square.hpp"
#include "engine/antialias/ray_stretches.hpp"
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
    std::size_t ray;  ///< index: of the square's rays, then of its corners
};

/// The rays of a square, and its corners.
inline constexpr std::size_t most_wall_places = square_ray_count + square_corners.size();

/// The stretch of a ray within the clip region, and f at its ends, by which walls that cut roots
/// away are sought.
class WallRay {
public:
    WallRay() = default;
    /// `has_f`: f is known of it; else only its stretch within the clip region.
    WallRay(const RayStretch& ray, bool has_f)
        : length_(ray.to - ray.from), near_(ray.near), far_(ray.far), has_f_(has_f) {}

    /// Numbers that are below 0 here and above 0 at `miss`, and 0 at the wall between them: of the
    /// length within the clip region, or of f where rays enter or leave it. False: nothing tells.
    bool heights(const WallRay& miss, double& here, double& there) const;

private:
    double length_ = 0.0;  ///< below 0 outside
    double near_ = 0.0, far_ = 0.0;
    bool has_f_ = false;
};

/// The search for a wall along the way from a place of a square whose ray has a root to one whose
/// ray has none, in halves of the square's side.
class WallWay {
public:
    WallWay() = default;
    WallWay(const SquareRay& hit, const WallRay& hit_ray, const SquareRay& miss,
            const WallRay& miss_ray)
        : from_(hit), to_(miss), hit_(hit_ray), miss_(miss_ray) {}

    [[nodiscard]] bool is_done() const {
        return !(miss_at_ - hit_at_ > error) || steps_ == most_steps;
    }
    /// The place whose ray to take next: where the wall seems to be, a little to one side, so that
    /// it is soon known between two places near to one another.
    [[nodiscard]] SquareRay next() { return place_at(next_ = choose()); }
    /// Takes what was found of the ray there.
    void take(const RayStretch& ray);
    /// Where the wall is.
    [[nodiscard]] SquareRay wall() const { return place_at(0.5 * (hit_at_ + miss_at_)); }

private:
    /// How well the wall is known, in parts of the way.
    static constexpr double error = 1.0 / 512;
    static constexpr int most_steps = 36;

    [[nodiscard]] SquareRay place_at(double part) const {
        return {.x = from_.x + part * (to_.x - from_.x), .y = from_.y + part * (to_.y - from_.y)};
    }
    [[nodiscard]] double choose() const;

    SquareRay from_{}, to_{};
    double hit_at_ = 0.0, miss_at_ = 1.0, next_ = 0.0;  ///< in parts of the way
    WallRay hit_, miss_;                                ///< the rays there
    bool last_hit_ = false;                             ///< the ray taken last
    int same_side_ = 0;                                 ///< how many rays in a row were like it
    int steps_ = 0;
};

/// Two ways across a square.
struct WallWays {
    std::array<WallPlace, 2> hit, miss;
};

/// The two ways from places with roots to places without that are farthest apart; none if all have
/// roots, or none has.
std::optional<WallWays> wall_between(std::span<const WallPlace> places);

/// The line through two places of a wall, below 0 where rays have roots; nothing unless it divides
/// the places as they are.
std::optional<LinearOnSquare> line_of_wall(std::span<const WallPlace> places, const SquareRay& a,
                                           const SquareRay& b);

}  // namespace zeroset
