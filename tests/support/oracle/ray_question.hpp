#pragma once

#include "engine/scene/region.hpp"
#include "engine/view/camera.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace zeroset::test {

/// A ray eye + t * direction, its doubles taken as exact, and its part in a clip box and a region.
struct RayQuestion {
    std::array<double, 3> eye;
    std::array<double, 3> direction;
    /// The range of t surely inside and, in perspective, in front of the eye; empty if inner_from >
    /// inner_to.
    double inner_from, inner_to;
    /// The range of t with all that a tracer may add at either end by rounding outward.
    double outer_from, outer_to;
};

/// The ray through a pixel's centre, as ViewFrame gives it; nullopt where it surely passes by.
std::optional<RayQuestion> ray_question(const ViewFrame& view, const Box& clip,
                                        const Region& region, int col, int row, int width,
                                        int height);

enum class RayTruth : std::uint8_t {
    Hit,      ///< the first root is known, and f is continuous there
    Empty,    ///< no root
    Unknown,  ///< not decided
};

/// An oracle's answer about a ray.
struct RayAnswer {
    RayTruth truth = RayTruth::Unknown;
    double from = 0.0, to = 0.0;  ///< of a hit: t of the first root, which may be a touch
    bool crosses = false;         ///< of a hit: f is proved to change its sign there
};

/// A hit between `from` and `to`; not decided where the root may lie outside the inner range.
RayAnswer hit_between(const RayQuestion& ray, double from, double to, bool crosses);

}  // namespace zeroset::test
