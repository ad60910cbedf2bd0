#include "engine/scene/region.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

double size_of(const Section& section) { return std::abs(section.offset); }

double size_of(const Ball& ball) { return glm::length(ball.centre) + ball.radius; }

bool Region::contains(const glm::dvec3& point, double slack) const {
    if (ball && glm::distance(point, ball->centre) > ball->radius + slack) return false;
    return std::ranges::all_of(sections, [&](const Section& section) {
        return glm::dot(section.normal, point) <= section.offset + slack;
    });
}

Section make_section(const glm::dvec3& normal, double offset, bool cap) {
    const double length = glm::length(normal);
    return {.normal = normal / length, .offset = offset / length, .cap = cap};
}

Region stretched(const Region& region, const glm::dvec3& stretch) {
    if (stretch == glm::dvec3(1.0)) return region;
    Region drawn = region;
    for (Section& section : drawn.sections) {
        const Section across = make_section(section.normal / stretch, section.offset);
        section.normal = across.normal;
        section.offset = across.offset;
    }
    return drawn;
}

bool cuts(const Section& section, const Box& box) {
    constexpr double error = 0x1p-48;  // above the rounding of the few operations here
    const glm::dvec3 farthest =
        glm::mix(box.lo, box.hi, glm::greaterThan(section.normal, glm::dvec3(0.0)));
    const glm::dvec3 size = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double spare = error * glm::dot(glm::abs(section.normal), size);
    return glm::dot(section.normal, farthest) > section.offset + spare;
}

}  // namespace zeroset
