#pragma once

#include "engine/trace/scene_ray.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstdint>
#include <optional>

namespace zeroset {

/// A stretch of a ray that holds the first root of a surface on it.
struct RootBracket {
    double from, to;
    double guess;     ///< between them
    int sign_before;  ///< of f at `from`: -1 or 1; 0: not known
    bool is_proved;   ///< a root is there, one only, and nothing before it
};

/// The outcome of the search of a ray.
struct RootFinding {
    std::optional<RootBracket> bracket;
    bool unsettled = false;  ///< a part of the ray before could not be decided
};

enum class RootWish : std::uint8_t {
    First,  ///< the first root, alone in its bracket
    Any,    ///< whether there is any
};

/// The place where a ray begins, as far as it is known.
enum class RayStart : std::uint8_t {
    Anywhere,
    OnSurface,  ///< within the ray's own_error of a root that is none of the ray's
    /// Within the ray's own_error of a place where f is 0 or above: the ray leaves the surface of a
    /// part of a union outwards.
    NotBelow,
};

/// Searches a ray for roots of one surface: 16 cells of it at a time are enclosed by forms
/// without width, and the first that may hold a root is divided in 16 again. `ray`: within the clip
/// box. In upward rounding.
RootFinding search_ray(const TraceFrame& surface, const SceneRay& ray, RayStart start,
                       RootWish wish, Counters& counters);

}  // namespace zeroset
