#pragma once

#include "engine/scene/region.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace zeroset::test {

/// A ray eye + t * direction, its doubles taken as exact, and the part of it in a clip box and a
/// region.
struct RayQuestion {
    std::array<double, 3> eye;
    std::array<double, 3> direction;
    /// Surely inside and, in perspective, in front of the eye; empty if inner_from > inner_to.
    double inner_from, inner_to;
    /// The same with what a tracer may add at either end by rounding outward.
    double outer_from, outer_to;
};

/// The ray through a pixel's centre, as ViewFrame gives it; nothing when it surely passes by.
std::optional<RayQuestion> ray_question(const ViewFrame& view, const Box& clip,
                                        const Region& region, int col, int row, int width,
                                        int height);

enum class RayTruth : std::uint8_t {
    Hit,      ///< the first root is known, and f is continuous there
    Empty,    ///< no root
    Unknown,  ///< not decided
};

/// What an oracle says of a ray.
struct RayAnswer {
    RayTruth truth = RayTruth::Unknown;
    double from = 0.0, to = 0.0;  ///< of a hit: t of its first root, which may be a touch
    bool crosses = false;         ///< of a hit: f is proved to change its sign there
};

/// A first root that lies where only rounding reaches is not decided.
RayAnswer hit_between(const RayQuestion& ray, double from, double to, bool crosses);

}  // namespace zeroset::test
