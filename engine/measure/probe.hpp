#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace zeroset {

/// The point that a pixel shows, and how well it is known.
struct PointFacts {
    glm::dvec3 point{0.0};  ///< on the pixel's ray, world units
    double distance = 0.0;  ///< from the eye
    /// The distance of the surface from the point along the ray, at most: proved by opposite signs
    /// of f if `proved`, else an estimate.
    double within = 0.0;
    bool proved = false;
    double f = 0.0;          ///< at the point, in double; 0 on a parametric surface
    glm::dvec3 normal{0.0};  ///< f's gradient at length 1; 0 where there is none
    std::size_t surface = 0;
    Certificate certificate = Certificate::Miss;
};

/// A finished or growing picture and the formulas behind it.
struct ProbedPicture {
    const Framebuffer& frame;
    const Camera& camera;
    std::span<const Kernel> formulas;  ///< f of each surface of the picture, as typed
    const Uniforms& uniforms;
    /// The error of the picture's depths, world units: certified_width or a guess.
    double tolerance = 0.0;
};

/// Finds what the picture shows at a pixel, to the digits of double: from its depth by Newton's
/// method along the ray, without tracing. Nothing where nothing is drawn.
std::optional<PointFacts> probe(const ProbedPicture& picture, int col, int row);

}  // namespace zeroset
