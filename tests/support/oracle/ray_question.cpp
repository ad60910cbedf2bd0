#include "tests/support/oracle/ray_question.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset::test {
namespace {

/// More than the relative error of a difference and a quotient in double.
constexpr double slack = 0x1p-50;

/// Part of a clip box's coordinates that a tracer in float may add around the box.
constexpr double outward = 0x1p-20;

constexpr double unbounded = std::numeric_limits<double>::infinity();

double largest(const glm::dvec3& a) { return std::max({a.x, a.y, a.z}); }

/// The range of t in which a ray is inside something; its ends are known to within their errors.
struct Stretch {
    double in = -unbounded, out = unbounded;
    double in_error = 0.0, out_error = 0.0;

    void enter(double at, double error) {
        if (at > in) in_error = error;
        in = std::max(in, at);
    }
    void leave(double at, double error) {
        if (at < out) out_error = error;
        out = std::min(out, at);
    }
    void miss() { out = -unbounded; }
};

/// Cuts the range to the side n.p <= offset of a plane.
void keep_side(const glm::dvec3& normal, double offset, const glm::dvec3& eye,
               const glm::dvec3& direction, Stretch& stretch) {
    const double height = glm::dot(normal, eye) - offset;
    const double rate = glm::dot(normal, direction);
    const double error = slack * (std::abs(offset) + 3.0 * largest(glm::abs(eye)));
    if (rate == 0.0) return height > error ? stretch.miss() : void();
    const double at = -height / rate;
    const double at_error = slack * std::abs(at) + error / std::abs(rate);
    rate > 0 ? stretch.leave(at, at_error) : stretch.enter(at, at_error);
}

void keep_ball(const Ball& ball, const glm::dvec3& eye, const glm::dvec3& direction,
               Stretch& stretch) {
    const glm::dvec3 from = eye - ball.centre;
    const double square = glm::dot(direction, direction);
    const double nearest = -glm::dot(from, direction) / square;
    const double gap = glm::length(from + nearest * direction);
    const double size = largest(glm::abs(eye)) + glm::length(ball.centre) + ball.radius;
    const double error = 8.0 * slack * size;
    const auto half = [&](double radius) {
        return std::sqrt(std::max((radius - gap) * (radius + gap), 0.0) / square);
    };
    if (gap > ball.radius + error) return stretch.miss();
    const double outer = half(ball.radius + error) + error;
    const double inner = gap < ball.radius - error ? half(ball.radius - error) - error : 0.0;
    const double middle = 0.5 * (outer + inner);
    stretch.enter(nearest - middle, outer - middle);
    stretch.leave(nearest + middle, outer - middle);
}

}  // namespace

std::optional<RayQuestion> ray_question(const ViewFrame& view, const Box& clip,
                                        const Region& region, int col, int row, int width,
                                        int height) {
    const glm::dvec3 eye = view.origin(pixel_centre(col, row), {.width = width, .height = height});
    const glm::dvec3 direction =
        view.direction(pixel_centre(col, row), {.width = width, .height = height});
    const double margin = outward * largest(glm::max(glm::abs(clip.lo), glm::abs(clip.hi))) /
                          largest(glm::abs(direction));
    Stretch stretch;
    if (!view.parallel()) stretch.in = 0.0;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        keep_side(axis, clip.hi[i], eye, direction, stretch);
        keep_side(-axis, -clip.lo[i], eye, direction, stretch);
    }
    for (const Section& section : region.sections)
        keep_side(section.normal, section.offset, eye, direction, stretch);
    if (region.ball) keep_ball(*region.ball, eye, direction, stretch);
    RayQuestion ray{{eye.x, eye.y, eye.z},
                    {direction.x, direction.y, direction.z},
                    stretch.in + stretch.in_error,
                    stretch.out - stretch.out_error,
                    stretch.in - stretch.in_error - margin,
                    stretch.out + stretch.out_error + margin};
    if (ray.outer_from > ray.outer_to) return std::nullopt;
    return ray;
}

RayAnswer hit_between(const RayQuestion& ray, double from, double to, bool crosses) {
    if (from < ray.inner_from || to > ray.inner_to) return {};
    return {RayTruth::Hit, from, to, crosses};
}

}  // namespace zeroset::test
