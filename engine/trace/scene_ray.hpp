#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/scene/scene.hpp"
#include "engine/view/unit_vector.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>

namespace zeroset {

/// A ray from anywhere in the scene: the points origin + t direction, t in world units.
struct SceneRay {
    glm::dvec3 origin;
    UnitVector direction;
    double from = 0.0;  ///< roots are wanted between these
    double to = std::numeric_limits<double>::infinity();
    /// The surface that the origin lies on, whose root there is none of the ray's; no_surface:
    /// none.
    std::uint8_t own = no_surface;
    /// How far that root may be from the origin, along the ray; above 0 if there is one.
    double own_error = 0.0;
    int own_sign = 0;  ///< of the own surface's f, where the ray leaves it: -1, 1; 0: not known

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The first root on a ray.
struct RayHit {
    double t = std::numeric_limits<double>::infinity();  ///< on the ray; +inf: there is none
    std::uint8_t surface = no_surface;
    /// Miss or Certified: proved, as in a picture. Undecided: the search passed, or ended at, a
    /// cell that it could not decide.
    Certificate certificate = Certificate::Miss;
    double error = 0.0;        ///< how far the root may be from `t`
    glm::dvec3 gradient{0.0};  ///< of f there; of whatever size, 0 or NaN where there is none

    [[nodiscard]] bool is_hit() const { return surface != no_surface; }
};

/// The ray as far as it is in the clip box and the region; empty (from > to) where it is not.
/// Up to rounding errors of double.
SceneRay clipped(const SceneRay& ray, const Scene& scene);

}  // namespace zeroset
