#pragma once

#include "engine/blobs/blob_kind.hpp"
#include "engine/trace/blobs/near_balls.hpp"
#include "engine/trace/followed_rays.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// The state of a ray of a block.
enum class BallRayState : std::uint8_t {
    Outside,  ///< it is none of the block's, or ended before
    Open,     ///< it is looked at from `at` on
    Passed,   ///< it came to `stop` without a root
    Root,     ///< its first root is between `depth` and `to`, where f - level has opposite signs
    Unsure,   ///< there may be a root behind `depth`, and none is before
};

/// Rays about a middle one, in its coordinates: at depth s behind `s = 0` a ray is
///   start + s tilt
/// to the side of the middle ray, which itself goes by `u`, `v` aside for each 1 along the view.
struct BallBlock {
    using Numbers = std::array<double, ray_block_rays>;

    alignas(64) Numbers u, v;
    Numbers start_x, start_y, tilt_x, tilt_y;
    Numbers at, stop;
    std::array<std::int8_t, ray_block_rays> side;  ///< of f - level at `at`; 0: not known
    std::array<BallRayState, ray_block_rays> state;
    Numbers depth, to;             ///< of roots
    std::array<Numbers, 3> slope;  ///< there, along the axes of the view
};

/// The surface that march() looks for on rays, and bounds for it.
struct BallQuestion {
    BlobKind kind;
    double level;
    /// The balls near the block, those whose from() is least first: x and y from where the middle
    /// ray is at their depth, z from s = 0.
    std::span<const ViewBall> balls;
    /// Bounds of the depths from s = 0 at which rays end, of how far they are there from the middle
    /// one, and of the squares of their directions.
    double extent, width, square;
    double place_error;  ///< bounds that of places in double
    double tail;         ///< bounds what balls add beyond their reach, and the level's error
    double bracket;      ///< the widest in which a root is certified
};

/// Evaluations of f on rays.
using BallEvaluations = std::uint64_t;

/// Follows the open rays to their ends; those that take very many steps stay open. In upward
/// rounding.
BallEvaluations march(const BallQuestion& question, BallBlock& block);

/// The tile's balls as blocks ask for them.
struct BallColumns {
    std::vector<float> x, y, z, support;  ///< padded by balls that reach nothing

    void fill(std::span<const ViewBall> balls);
};
/// Rays of a block: those within the radii about (u, v), between two depths.
struct BlockBeam {
    double u, v, u_radius, v_radius;
    double distance;  ///< as TileRays has it
    double from, to;
    double spare;  ///< more than roundings of floats here
};
/// Numbers of the balls that may reach the beam, in order.
void list_near(const BallColumns& columns, std::size_t count, const BlockBeam& beam,
               std::vector<std::uint32_t>& near);

}  // namespace zeroset
