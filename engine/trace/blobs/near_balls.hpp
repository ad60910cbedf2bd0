#pragma once

#include "engine/blobs/blob_set.hpp"
#include "engine/trace/tile_rays.hpp"

#include <glm/ext/vector_double3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// A ball as a view sees it: to the right, up and along the view from the point looked at.
struct ViewBall {
    double x, y, z;
    double support;  ///< how far it reaches
    double radius, per_square, strength;

    /// The depths between which it reaches rays, whatever their directions.
    [[nodiscard]] double from() const { return z - support; }
    [[nodiscard]] double to() const { return z + support; }
};

/// The balls that reach a tile's rays, front to back: slab by slab of depth, so that those far
/// behind are not looked at before rays get there.
class NearBalls {
public:
    /// Rays within the radii of (u, v), between two depths. All outlive it. Keeps its memory from
    /// tile to tile.
    struct Rays {
        double u, v, u_radius, v_radius;
        double from, to;
    };
    void begin(const BlobSet& set, double reach, const TileRays& rays, const Rays& of);

    /// Goes on to the next slab; false: there are no balls behind the last one.
    bool next();
    /// The balls that reach into the slab, those whose from() is least first; and others.
    [[nodiscard]] std::span<const ViewBall> balls() const { return balls_; }
    /// The slab's balls that no slab before had, in no order.
    [[nodiscard]] std::span<const ViewBall> fresh() const { return fresh_; }
    /// The slab's depths. Nothing reaches rays between two slabs.
    [[nodiscard]] double from() const { return from_; }
    [[nodiscard]] double to() const { return to_; }

private:
    struct Open {
        double from;
        std::uint32_t node;
    };
    /// A side of the rays: what has normal . p > offset is beyond it.
    struct Side {
        glm::dvec3 normal;
        double offset, length;
    };

    void open(std::uint32_t node);
    void take_first();
    void take(std::uint32_t ball);
    [[nodiscard]] double next_from() const;

    const BlobSet* set_ = nullptr;
    double reach_ = 0;
    Rays rays_{};
    glm::dvec3 base_{0.0}, right_{0.0}, up_{0.0}, forward_{0.0};
    double spare_ = 0;  ///< more than roundings of places
    std::array<Side, 4> sides_{};
    std::vector<Open> open_;  ///< a heap, the nearest first
    std::vector<ViewBall> balls_, fresh_;
    double from_ = 0, to_ = 0;
};

}  // namespace zeroset
