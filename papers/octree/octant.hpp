#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// An octant as a ray sees it: in the ray's axes, along all of which it rises, and where the ray is
/// in it, in the ray's parameter.
struct Octant {
    glm::dvec3 corner;  ///< (x_c, y_c, z_c), the one with the least coordinates
    double length;      ///< l
    double in, out;
};

/// The sub-octants of an octant that a ray passes, in the order in which it does. An index is that
/// of Octree in the ray's axes: bit 0 is set behind x_m, bit 1 behind y_m, bit 2 behind z_m.
struct SubOctants {
    std::size_t count = 0;
    std::array<std::uint8_t, 8> index;
    std::array<double, 8> in, out;

    void add(unsigned octant, double ray_in, double ray_out) {
        index[count] = static_cast<std::uint8_t>(octant);
        in[count] = ray_in;
        out[count] = ray_out;
        ++count;
    }
    /// Puts the octant at `from` where that at `to`, no later, was.
    void move(std::size_t from, std::size_t to) {
        index[to] = index[from];
        in[to] = in[from];
        out[to] = out[from];
    }
};

/// A sub-octant; its corner is exact down to OctreeSpace::finest.
inline Octant sub_octant(const glm::dvec3& corner, double length, unsigned index, double in,
                         double out) {
    const double half = 0.5 * length;
    const glm::dvec3 upper((index & 1U) != 0, (index & 2U) != 0, (index & 4U) != 0);
    return {.corner = corner + half * upper, .length = half, .in = in, .out = out};
}

}  // namespace zeroset
