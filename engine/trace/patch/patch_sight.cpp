#include "engine/trace/patch/patch_sight.hpp"

#include "engine/real/unbounded.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr double rounding = sight_rounding;

double most(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

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
    const double g1 = sight.c.x - ray.u * axes.distance - ray.u * sight.c.z;
    const double g2 = sight.c.y - ray.v * axes.distance - ray.v * sight.c.z;
    const double pp = sight.kp.x - ray.u * sight.kp.z;
    const double pq = sight.kq.x - ray.u * sight.kq.z;
    const double qp = sight.kp.y - ray.v * sight.kp.z;
    const double qq = sight.kq.y - ray.v * sight.kq.z;
    const double e1 = sight.e.x + std::abs(ray.u) * sight.e.z;
    const double e2 = sight.e.y + std::abs(ray.v) * sight.e.z;
    LinearZeros zeros{.any = true,
                      .known = false,
                      .p = 0.0,
                      .q = 0.0,
                      .p_radius = unbounded,
                      .q_radius = unbounded};
    // Reject rays on which the linear form of g is not 0 anywhere.
    if (std::abs(g1) > (std::abs(pp) + std::abs(pq)) * (1.0 + rounding) + e1 ||
        std::abs(g2) > (std::abs(qp) + std::abs(qq)) * (1.0 + rounding) + e2) {
        zeros.any = false;
        return zeros;
    }
    // Solve the linear system, if it is well conditioned.
    const double determinant = pp * qq - pq * qp;
    const double size = std::abs(pp * qq) + std::abs(pq * qp);
    if (!(std::abs(determinant) > 0x1p-30 * size) || !(e1 + e2 < unbounded)) return zeros;
    const double inverse = 1.0 / determinant;
    // How much of the quotients rounding may have made, relative to the sizes of their terms.
    const double lost = rounding * size * std::abs(inverse);
    zeros.known = true;
    zeros.p = (pq * g2 - qq * g1) * inverse;
    zeros.q = (qp * g1 - pp * g2) * inverse;
    const double grow = std::abs(inverse) * (1.0 + 0x1p-10);
    zeros.p_radius = (std::abs(qq) * e1 + std::abs(pq) * e2) * grow +
                     lost * (std::abs(pq * g2) + std::abs(qq * g1)) * grow;
    zeros.q_radius = (std::abs(qp) * e1 + std::abs(pp) * e2) * grow +
                     lost * (std::abs(qp * g1) + std::abs(pp * g2)) * grow;
    return zeros;
}

Contraction contraction_of(const PatchSight& sight, const SightRays& rays) {
    const double u = rays.middle.u;
    const double v = rays.middle.v;
    // Compute g' in the middle of the box.
    const Matrix2 middle{.pp = sight.dp.x - u * sight.dp.z,
                         .pq = sight.dq.x - u * sight.dq.z,
                         .qp = sight.dp.y - v * sight.dp.z,
                         .qq = sight.dq.y - v * sight.dq.z};
    // Bound how far g' varies: over the box, by rounding, and from ray to ray.
    const auto radius = [](const glm::dvec3& r, double across, double along) {
        return across + std::abs(along) * r.z;
    };
    const auto beside = [](const glm::dvec3& d, const glm::dvec3& r, double width) {
        return width * (std::abs(d.z) + r.z);
    };
    const auto lost = [&](const glm::dvec3& d, double across, double along) {
        return rounding * (std::abs(across) + std::abs(along * d.z));
    };
    const Matrix2 spread{
        .pp = radius(sight.dp_radius, sight.dp_radius.x, u) + lost(sight.dp, sight.dp.x, u) +
              beside(sight.dp, sight.dp_radius, rays.u_radius),
        .pq = radius(sight.dq_radius, sight.dq_radius.x, u) + lost(sight.dq, sight.dq.x, u) +
              beside(sight.dq, sight.dq_radius, rays.u_radius),
        .qp = radius(sight.dp_radius, sight.dp_radius.y, v) + lost(sight.dp, sight.dp.y, v) +
              beside(sight.dp, sight.dp_radius, rays.v_radius),
        .qq = radius(sight.dq_radius, sight.dq_radius.y, v) + lost(sight.dq, sight.dq.y, v) +
              beside(sight.dq, sight.dq_radius, rays.v_radius)};
    // Invert it.
    const double determinant = middle.pp * middle.qq - middle.pq * middle.qp;
    const double inverse = 1.0 / determinant;
    const Matrix2 y{.pp = middle.qq * inverse,
                    .pq = -middle.pq * inverse,
                    .qp = -middle.qp * inverse,
                    .qq = middle.pp * inverse};
    const Matrix2 size{
        .pp = std::abs(y.pp), .pq = std::abs(y.pq), .qp = std::abs(y.qp), .qq = std::abs(y.qq)};
    // |I - Y middle|, which is not 0 by rounding alone, and |Y| spread.
    const auto row = [&](double yp, double yq, double size_p, double size_q, bool first) {
        const double to_p = yp * middle.pp + yq * middle.qp - (first ? 1.0 : 0.0);
        const double to_q = yp * middle.pq + yq * middle.qq - (first ? 0.0 : 1.0);
        const double rounded = rounding * (size_p * (std::abs(middle.pp) + std::abs(middle.pq)) +
                                           size_q * (std::abs(middle.qp) + std::abs(middle.qq)));
        return std::abs(to_p) + std::abs(to_q) + rounded + size_p * (spread.pp + spread.pq) +
               size_q * (spread.qp + spread.qq);
    };
    const double norm =
        std::max(row(y.pp, y.pq, size.pp, size.pq, true), row(y.qp, y.qq, size.qp, size.qq, false));
    return {.inverse = y, .size = size, .norm = norm < unbounded ? norm : unbounded};
}

ZeroTest zero_test(const PatchSight& sight, const SightAxes& axes, const SightRay& ray,
                   const Contraction& contraction, const glm::dvec3& at, double p, double q,
                   double bound) {
    // Compute g at the place, and bounds of its error.
    const double g1 = at.x - ray.u * axes.distance - ray.u * at.z;
    const double g2 = at.y - ray.v * axes.distance - ray.v * at.z;
    const double e1 =
        (1.0 + std::abs(ray.u)) * sight.value_error +
        rounding * (std::abs(at.x) + std::abs(ray.u) * (axes.distance + std::abs(at.z)));
    const double e2 =
        (1.0 + std::abs(ray.v)) * sight.value_error +
        rounding * (std::abs(at.y) + std::abs(ray.v) * (axes.distance + std::abs(at.z)));
    // Take the step -Y g, with a bound of its error.
    const Matrix2& y = contraction.inverse;
    const double step_p = -(y.pp * g1 + y.pq * g2);
    const double step_q = -(y.qp * g1 + y.qq * g2);
    const double lost = std::max(contraction.size.pp * (e1 + rounding * std::abs(g1)) +
                                     contraction.size.pq * (e2 + rounding * std::abs(g2)),
                                 contraction.size.qp * (e1 + rounding * std::abs(g1)) +
                                     contraction.size.qq * (e2 + rounding * std::abs(g2)));
    const double step = std::max(std::abs(step_p), std::abs(step_q));
    const double rest = 1.0 - contraction.norm;
    // Any zero of the box is within this of (p, q).
    const double reach = (step + lost) / rest * (1.0 + rounding);
    const double far = std::min(reach, 1.0 + std::max(std::abs(p), std::abs(q)));
    ZeroTest test{.found = ZeroTest::Found::Unknown,
                  .p = p + step_p,
                  .q = q + step_q,
                  .radius = contraction.norm * far + lost + 0x1p-50,
                  .s = 0.0,
                  .s_radius = 0.0};
    test.s = at.z + sight.dp.z * step_p + sight.dq.z * step_q;
    test.s_radius =
        sight.dp_radius.z * std::abs(step_p) + sight.dq_radius.z * std::abs(step_q) +
        (std::abs(sight.dp.z) + sight.dp_radius.z + std::abs(sight.dq.z) + sight.dq_radius.z) *
            test.radius +
        sight.value_error + rounding * std::abs(at.z);
    const bool beyond =
        std::abs(test.p) - test.radius > bound || std::abs(test.q) - test.radius > bound;
    if (beyond) {
        test.found = ZeroTest::Found::None;
    } else if (std::max(std::abs(p), std::abs(q)) + reach <= 1.0) {
        test.found = ZeroTest::Found::One;
    }
    return test;
}

BoxPlace newton_place(const ZeroTest& test, const SightAxes& axes, const SightRay& ray,
                      const glm::dvec3& at, const glm::dvec3& by_p, const glm::dvec3& by_q,
                      const BoxPlace& from) {
    const double g1 = at.x - ray.u * axes.distance - ray.u * at.z;
    const double g2 = at.y - ray.v * axes.distance - ray.v * at.z;
    const double pp = by_p.x - ray.u * by_p.z;
    const double pq = by_q.x - ray.u * by_q.z;
    const double qp = by_p.y - ray.v * by_p.z;
    const double qq = by_q.y - ray.v * by_q.z;
    const double inverse = 1.0 / (pp * qq - pq * qp);
    const double p = from.p + (pq * g2 - qq * g1) * inverse;
    const double q = from.q + (qp * g1 - pp * g2) * inverse;
    const bool is_known = std::abs(p) < unbounded && std::abs(q) < unbounded;
    return {.p = std::clamp(is_known ? p : test.p, -1.0, 1.0),
            .q = std::clamp(is_known ? q : test.q, -1.0, 1.0)};
}

}  // namespace zeroset
