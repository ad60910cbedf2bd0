#include "engine/trace/jumps.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

constexpr std::size_t sides = 4;
/// How far before and behind the change is looked for; steeper surfaces are taken to face the eye.
constexpr double reach_pixels = 8;
constexpr int halvings = 24;

/// A parallel ray on which the change is looked for.
struct Side {
    glm::dvec3 start, direction;
    double lo, hi;
    bool found = false;

    [[nodiscard]] glm::dvec3 at(double offset) const { return start + offset * direction; }
};

std::array<glm::dvec3, 2> across(const glm::dvec3& direction) {
    const glm::dvec3 sizes = glm::abs(direction);
    glm::dvec3 axis(0.0);
    axis[sizes.x <= sizes.y && sizes.x <= sizes.z ? 0 : sizes.y <= sizes.z ? 1 : 2] = 1.0;
    const glm::dvec3 first = glm::normalize(glm::cross(direction, axis));
    return {first, glm::cross(direction, first)};
}

std::vector<Side> sides_of(std::span<const JumpPlace> places) {
    std::vector<Side> result;
    for (const JumpPlace& place : places) {
        for (const glm::dvec3& axis : across(place.direction)) {
            for (const double way : {-0.5, 0.5}) {
                const double reach = reach_pixels * place.pixel_size;
                result.push_back({.start = place.position + way * place.pixel_size * axis,
                                  .direction = place.direction,
                                  .lo = -reach,
                                  .hi = reach});
            }
        }
    }
    return result;
}

/// The values at one offset of each side.
std::vector<double> ask(const std::vector<Side>& all, const PointAsker& f, auto offset) {
    std::vector<glm::dvec3> points;
    points.reserve(all.size());
    for (const Side& side : all)
        points.push_back(side.at(offset(side)));
    return f(points);
}

void find_changes(std::vector<Side>& all, const PointAsker& f) {
    const std::vector<double> before = ask(all, f, [](const Side& side) { return side.lo; });
    const std::vector<double> behind = ask(all, f, [](const Side& side) { return side.hi; });
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].found = (before[i] < 0 && behind[i] > 0) || (before[i] > 0 && behind[i] < 0);
    const auto middle = [](const Side& side) { return 0.5 * side.lo + 0.5 * side.hi; };
    for (int step = 0; step < halvings; ++step) {
        const std::vector<double> values = ask(all, f, middle);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool is_before = (values[i] > 0) == (before[i] > 0);
            (is_before ? all[i].lo : all[i].hi) = middle(all[i]);
        }
    }
}

}  // namespace

std::vector<glm::dvec3> jump_normals(std::span<const JumpPlace> places, const PointAsker& f) {
    std::vector<Side> all = sides_of(places);
    find_changes(all, f);
    std::vector<glm::dvec3> result;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::span<const Side> own = std::span(all).subspan(sides * i, sides);
        const glm::dvec3 ahead =
            places[i].trend == Trend::Falling ? -places[i].direction : places[i].direction;
        // Where the surface ends there is one side only.
        const auto point = [&](std::size_t side) {
            return own[side].found ? own[side].at(own[side].lo) : places[i].position;
        };
        const glm::dvec3 normal = glm::cross(point(1) - point(0), point(3) - point(2));
        const double size = glm::length(normal);
        const bool known = (own[0].found || own[1].found) && (own[2].found || own[3].found) &&
                           size > 0.0 && std::isfinite(size);
        const double way = glm::dot(normal, ahead) < 0.0 ? -1.0 : 1.0;
        result.push_back(known ? way / size * normal : ahead);
    }
    return result;
}

}  // namespace zeroset
