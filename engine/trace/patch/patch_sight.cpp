#include "engine/trace/patch/patch_sight.hpp"

#include "engine/real/unbounded.hpp"
#include "engine/trace/patch/sight_algebra-inl.hpp"

#include <algorithm>

namespace zeroset {
namespace {

// The instruction set that all of the program is compiled for.
using namespace HWY_NAMESPACE;  // NOLINT(google-build-using-namespace)

constexpr double rounding = sight_rounding;

double most(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

SightLine<double> line_of(const SightRay& ray) { return {.u = ray.u, .v = ray.v}; }
InAxes<double> numbers(const glm::dvec3& of) { return {.x = of.x, .y = of.y, .z = of.z}; }

}  // namespace

PatchSight place_of(const PatchForm& form, const SightAxes& axes) {
    const glm::dvec3 sizes = glm::abs(form.c - axes.base) + form.spread();
    const double lost = axes.error + rounding * most(sizes);
    PatchSight sight;
    sight.c = axes.place(form.c);
    sight.kp = axes.turned(form.ku);
    sight.kq = axes.turned(form.kv);
    sight.e = axes.turned_size(form.e) + lost;
    sight.value_error = lost;
    return sight;
}

void add_slopes(PatchSight& sight, const PatchForm& form, const SightAxes& axes) {
    const auto turned_radius = [&](const glm::dvec3& radius, const glm::dvec3& middle) {
        return axes.turned_size(radius + rounding * glm::abs(middle));
    };
    sight.dp = axes.turned(form.du);
    sight.dq = axes.turned(form.dv);
    sight.dp_radius = turned_radius(form.du_radius, form.du);
    sight.dq_radius = turned_radius(form.dv_radius, form.dv);
}

void add_value_error(PatchSight& sight, const PatchForm& form) {
    sight.value_error += 2.0 * most(form.value_error);
}

PatchSight sight_of(const PatchForm& form, const SightAxes& axes) {
    PatchSight sight = place_of(form, axes);
    add_slopes(sight, form, axes);
    add_value_error(sight, form);
    return sight;
}

LinearZeros linear_zeros(const PatchSight& sight, const SightAxes& axes, const SightRay& ray) {
    const LinearG<double> g = linear_g(line_of(ray), numbers(sight.c), numbers(sight.kp),
                                       numbers(sight.kq), numbers(sight.e), axes.distance);
    LinearZeros zeros{.any = !g.misses(1.0),
                      .known = false,
                      .p = 0.0,
                      .q = 0.0,
                      .p_radius = unbounded,
                      .q_radius = unbounded};
    if (!zeros.any) return zeros;
    const Zeros2<double> of = zeros_of(divisor_of(g.slopes), g.middle);
    if (!of.known) return zeros;
    const auto& [p, q] = of.x;
    return {.any = true,
            .known = true,
            .p = p.middle,
            .q = q.middle,
            .p_radius = p.radius,
            .q_radius = q.radius};
}

Contraction contraction_of(const PatchSight& sight, const SightRays& rays) {
    // Compute g' over the box, for all of the rays.
    const RealBall<double> u{.middle = rays.middle.u, .radius = rays.u_radius};
    const RealBall<double> v{.middle = rays.middle.v, .radius = rays.v_radius};
    const auto slope = [](const glm::dvec3& d, const glm::dvec3& radius, int k,
                          const RealBall<double>& along) {
        return less_product(along, RealBall<double>{.middle = d.z, .radius = radius.z},
                            {.middle = d[k], .radius = radius[k]});
    };
    const Matrix2<RealBall<double>> slopes{.pp = slope(sight.dp, sight.dp_radius, 0, u),
                                           .pq = slope(sight.dq, sight.dq_radius, 0, u),
                                           .qp = slope(sight.dp, sight.dp_radius, 1, v),
                                           .qq = slope(sight.dq, sight.dq_radius, 1, v)};
    // Invert its middle, and bound |I - Y g'|.
    const Matrix2<double> middle{.pp = slopes.pp.middle,
                                 .pq = slopes.pq.middle,
                                 .qp = slopes.qp.middle,
                                 .qq = slopes.qq.middle};
    const Matrix2<double> y = inverse_of(middle, divisor_of(middle).inverse);
    const auto [p, q] = rest_of_product(y, slopes);
    const bool is_known = p < unbounded && q < unbounded;
    return {.inverse = y, .norm = is_known ? std::max(p, q) : unbounded};
}

ZeroTest zero_test(const PatchSight& sight, const SightAxes& axes, const SightRay& ray,
                   const Contraction& contraction, const glm::dvec3& at, double p, double q,
                   double bound) {
    const auto g = line_of(ray).g(numbers(at), axes.distance, sight.value_error);
    const KrawczykStep<double> step =
        krawczyk_step(contraction, sight, g, Vector2<double>{.p = p, .q = q}, at.z);
    ZeroTest test{.found = ZeroTest::Found::Unknown,
                  .p = p + step.by.p,
                  .q = q + step.by.q,
                  .radius = step.radius,
                  .s = step.depth.middle,
                  .s_radius = step.depth.radius};
    if (!step.known) return test;
    if (std::abs(test.p) - test.radius > bound || std::abs(test.q) - test.radius > bound) {
        test.found = ZeroTest::Found::None;
    } else if (std::max(std::abs(p), std::abs(q)) + step.reach <= 1.0) {
        test.found = ZeroTest::Found::One;
    }
    return test;
}

BoxPlace newton_place(const ZeroTest& test, const SightAxes& axes, const SightRay& ray,
                      const glm::dvec3& at, const glm::dvec3& by_p, const glm::dvec3& by_q,
                      const BoxPlace& from) {
    const SightLine<double> line = line_of(ray);
    const Vector2<double> to_p = line.across(numbers(by_p));
    const Vector2<double> to_q = line.across(numbers(by_q));
    const Divisor2<double> by =
        divisor_of(Matrix2<double>{.pp = to_p.p, .pq = to_q.p, .qp = to_p.q, .qq = to_q.q});
    const Vector2<double> step = zero_by_determinant(by.m, line.g(numbers(at), axes.distance));
    const double p = from.p + step.p * by.inverse;
    const double q = from.q + step.q * by.inverse;
    const bool is_known = std::abs(p) < unbounded && std::abs(q) < unbounded;
    return {.p = std::clamp(is_known ? p : test.p, -1.0, 1.0),
            .q = std::clamp(is_known ? q : test.q, -1.0, 1.0)};
}

}  // namespace zeroset
