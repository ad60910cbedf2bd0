#pragma once

#include "engine/trace/tile_rays.hpp"

#include <vector>

namespace zeroset {

/// A number over a rectangle of rays, u and v from its middle: middle + by_u u + by_v v.
struct Plane {
    double middle, by_u, by_v;
};

/// Where parallel rays enter what is visible: the clip box and the region, whose walls they pass.
/// In world units, as LightPlaces has them.
class LightWalls {
public:
    explicit LightWalls(const TileRays& rays);

    /// Depths at which the first and the last of some rays enter.
    struct Entry {
        double first, last;
    };
    /// The entry of the rays within the radii of (u, v); its depths are counted from `plane`.
    [[nodiscard]] Entry entry(double u, double v, double u_radius, double v_radius,
                              const Plane& plane) const;

private:
    /// Rays at (u, v) pass the wall at depth at + by_u u + by_v v, up to `error`.
    struct Wall {
        double at, by_u, by_v, error;
    };

    void add(const glm::dvec3& normal, double offset, double error);

    const TileRays& rays_;
    std::vector<Wall> walls_;
};

}  // namespace zeroset
