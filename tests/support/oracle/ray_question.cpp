#include "tests/support/oracle/ray_question.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset::test {
namespace {

/// Above the relative error of a difference and a quotient in double.
constexpr double slack = 0x1p-50;

/// Of the coordinates of a clip box: what a tracer in float may add around it.
constexpr double outward = 0x1p-20;

double largest(const glm::dvec3& a) { return std::max({a.x, a.y, a.z}); }

}  // namespace

std::optional<RayQuestion> ray_question(const ViewFrame& view, const Box& clip, int col, int row,
                                        int width, int height) {
    const glm::dvec3 direction = view.direction(col + 0.5, row + 0.5, width, height);
    const double margin = outward * largest(glm::max(glm::abs(clip.lo), glm::abs(clip.hi))) /
                          largest(glm::abs(direction));
    double in = 0.0;
    double out = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double to_lo = clip.lo[i] - view.eye[i];
        const double to_hi = clip.hi[i] - view.eye[i];
        if (direction[i] == 0) {
            if (to_lo > 0 || to_hi < 0) return std::nullopt;
            continue;
        }
        const auto [first, last] = std::minmax({to_lo / direction[i], to_hi / direction[i]});
        in = std::max(in, first);
        out = std::min(out, last);
    }
    RayQuestion ray{{view.eye.x, view.eye.y, view.eye.z},
                    {direction.x, direction.y, direction.z},
                    in * (1 + slack),
                    out * (1 - slack),
                    in - margin,
                    out + margin};
    if (ray.outer_from > ray.outer_to) return std::nullopt;
    return ray;
}

RayAnswer hit_between(const RayQuestion& ray, double from, double to, bool crosses) {
    if (from < ray.inner_from || to > ray.inner_to) return {};
    return {RayTruth::Hit, from, to, crosses};
}

}  // namespace zeroset::test
