#pragma once

#include "engine/trace/tile_hits.hpp"

#include <glm/glm.hpp>

#include <functional>
#include <span>
#include <vector>

namespace zeroset {

/// Where f changes its sign in a jump on a ray.
struct JumpPlace {
    glm::dvec3 position, direction;  ///< of the ray, a unit vector
    double pixel_size;               ///< world units
    Trend trend;
};

/// f at points.
using PointAsker = std::function<std::vector<double>(const std::vector<glm::dvec3>&)>;

/// Normals of the surfaces on which f jumps, to where f is above 0, by where the sign changes on
/// parallel rays half a pixel away; along the ray where it does not. f's own gradient does not
/// tell.
std::vector<glm::dvec3> jump_normals(std::span<const JumpPlace> places, const PointAsker& f);

/// Whether |f| falls towards 0 on the way to a jump: it is `far` at one place and `near` at another
/// that is half as far from the jump or nearer. Where it does so on both sides, from either sign,
/// the jump is closed: f is 0 there as far as numbers tell.
template <class Real>
bool falls_to_zero(Real near, Real far) {
    constexpr Real most = static_cast<Real>(0.75);  // half, if it falls evenly
    return near <= most * far;
}

}  // namespace zeroset
