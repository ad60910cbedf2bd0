#pragma once

#include "engine/scene/settings.hpp"

#include <glm/glm.hpp>

#include <span>

namespace zeroset {

struct TraceFrame;

/// A ray from anywhere: the points origin + t direction, t from `from` to `to`, all in the clip box
/// but for rounding errors.
struct SingleRay {
    glm::dvec3 origin, direction;
    double from, to;

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The first root on a ray.
struct SingleRoot {
    bool is_found = false;
    double from = 0.0, to = 0.0;  ///< t between which it is, or seems to be
    bool is_proved = false;       ///< a root is there, and none before it
    /// The ray passed a stretch that could be neither rejected nor drawn, or nothing is proved.
    bool unsettled = false;
};

/// A tracer's own way to find roots on rays that mirrors send on: what Tracer::prepare has made may
/// be one. Read-only; any thread.
struct SingleRootFinder {
    virtual ~SingleRootFinder() = default;
    /// The first roots of a surface, one for each ray; `roots` are new. In upward rounding.
    virtual void find(const TraceFrame& frame, std::span<const SingleRay> rays,
                      std::span<SingleRoot> roots, Counters& counters) const = 0;
};

}  // namespace zeroset
