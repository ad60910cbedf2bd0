#pragma once

#include "engine/draw/page.hpp"
#include "engine/scene/scene.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// Tells which points of surfaces are hidden from the eye by surfaces or by caps of the region's
/// sections: by roots on their rays, proved as in a picture. A surface within `nearest` of the
/// point, along the ray, does not hide it.
class HiddenPoints {
public:
    /// `scene` and `page` live longer.
    HiddenPoints(const Scene& scene, const Page& page, const TimeLimit& limit);

    /// 1 for each hidden point, else 0. Any thread.
    void find(std::span<const glm::dvec3> points, std::span<std::uint8_t> hidden) const;
    [[nodiscard]] bool is_hidden(const glm::dvec3& point) const;
    [[nodiscard]] double nearest() const { return nearest_; }

private:
    struct Sight;
    [[nodiscard]] Sight sight_of(const glm::dvec3& point) const;
    [[nodiscard]] bool is_capped(const Sight& sight) const;
    void find_some(std::span<const glm::dvec3> points, std::span<std::uint8_t> hidden) const;

    const Scene& scene_;
    const Page& page_;
    std::vector<TraceFrame> frames_;
    std::vector<int> solid_signs_;
    double nearest_;
};

}  // namespace zeroset
