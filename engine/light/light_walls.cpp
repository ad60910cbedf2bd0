#include "engine/light/light_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {

LightWalls::LightWalls(const TileRays& rays) : rays_(rays) {
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        add(axis, rays.clip().hi[i], rays.depth_error());
        add(-axis, -rays.clip().lo[i], rays.depth_error());
    }
    for (const Section& section : rays.region().sections)
        add(section.normal, section.offset, rays.error_of(section));
}

void LightWalls::add(const glm::dvec3& normal, double offset, double error) {
    const ViewFrame& axes = rays_.axes();
    const double rate = glm::dot(normal, axes.forward);
    if (!(rate < 0)) return;  // rays leave through it
    walls_.push_back({.at = (offset - glm::dot(normal, rays_.base())) / rate,
                      .by_u = -glm::dot(normal, axes.right) / rate,
                      .by_v = -glm::dot(normal, axes.up) / rate,
                      .error = error / -rate});
}

LightWalls::Entry LightWalls::entry(double u, double v, double u_radius, double v_radius,
                                    const Plane& plane) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    Entry entry{.first = -none, .last = -none};
    for (const Wall& wall : walls_) {
        const double middle = wall.at + wall.by_u * u + wall.by_v * v - plane.middle;
        const double aside = std::abs(wall.by_u - plane.by_u) * u_radius +
                             std::abs(wall.by_v - plane.by_v) * v_radius + wall.error;
        entry.first = std::max(entry.first, middle - aside);
        entry.last = std::max(entry.last, middle + aside);
    }
    if (rays_.region().ball) {
        const double scale = 1.0 / rays_.distance();
        const DepthRange range =
            rays_.depths(u * scale, v * scale, u_radius * scale, v_radius * scale);
        const double aside = std::abs(plane.by_u) * u_radius + std::abs(plane.by_v) * v_radius;
        entry.first = std::max(entry.first, range.enter_lo - plane.middle - aside);
        entry.last = std::max(entry.last, range.enter_hi - plane.middle + aside);
    }
    return entry;
}

}  // namespace zeroset
