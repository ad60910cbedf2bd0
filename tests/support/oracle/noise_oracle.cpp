#include "tests/support/oracle/noise_oracle.hpp"

#include "tests/support/noise_reference.hpp"
#include "tests/support/oracle/field_level.hpp"
#include "tests/support/oracle/piece_roots.hpp"
#include "tests/support/sample_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace zeroset::test {
namespace {

double along(const RayQuestion& ray, std::size_t axis, double t) {
    return ray.eye[axis] + t * ray.direction[axis];
}

/// Perlin's twelve directions and four of them once more, as functions of (x, y, z).
NodeId directed(ExprBuilder& builder, std::uint32_t h, const std::array<NodeId, 3>& from) {
    const NodeId u = h < 8 ? from[0] : from[1];
    const NodeId v = h < 4 ? from[1] : h == 12 || h == 14 ? from[0] : from[2];
    const auto with_sign = [&](NodeId a, bool minus) {
        return minus ? builder.apply(Op::Negate, a) : a;
    };
    return builder.apply(Op::Add, with_sign(u, (h & 1U) != 0), with_sign(v, (h & 2U) != 0));
}

}  // namespace

std::optional<NoiseOracle> NoiseOracle::of(const Expr& expr) {
    auto found = field_level(expr);
    if (!found) return std::nullopt;
    const bool is_noise =
        std::dynamic_pointer_cast<const LatticeNoiseField>(found->field) != nullptr ||
        std::dynamic_pointer_cast<const CellularField>(found->field) != nullptr;
    if (!is_noise) return std::nullopt;
    return NoiseOracle(std::move(found->field), found->level);
}

/// Where the ray meets the planes of the lattice, and its ends, in order.
std::vector<double> NoiseOracle::planes(const RayQuestion& ray) const {
    std::vector<double> all{ray.outer_from, ray.outer_to};
    for (std::size_t i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0) continue;
        const double a = along(ray, i, ray.outer_from);
        const double b = along(ray, i, ray.outer_to);
        for (double plane = std::floor(std::min(a, b)); plane <= std::max(a, b); ++plane) {
            const double t = (plane - ray.eye[i]) / ray.direction[i];
            if (t > ray.outer_from && t < ray.outer_to) all.push_back(t);
        }
    }
    std::ranges::sort(all);
    return all;
}

std::optional<Expr> NoiseOracle::polynomial(const RayQuestion& ray, const LatticeNoise& of,
                                            double middle) const {
    ExprBuilder builder;
    const auto product = [&](NodeId a, NodeId b) { return builder.apply(Op::Multiply, a, b); };
    const auto difference = [&](NodeId a, NodeId b) { return builder.apply(Op::Subtract, a, b); };
    const auto number = [&](double value) { return builder.constant(value); };
    std::array<std::int64_t, 3> cell{};
    std::array<std::array<NodeId, 2>, 3> from{};
    std::array<std::array<NodeId, 2>, 3> weight{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double below = std::floor(along(ray, i, middle));
        cell[i] = static_cast<std::int64_t>(below);
        const NodeId t = difference(builder.variable(static_cast<int>(i)), number(below));
        from[i] = {t, difference(t, number(1))};
        const NodeId inner = builder.apply(
            Op::Add, product(t, difference(product(number(6), t), number(15))), number(10));
        const NodeId s = product(product(product(t, t), t), inner);
        weight[i] = {difference(number(1), s), s};
    }
    NodeId f = builder.apply(Op::Negate, builder.constant(level_.lo, level_.hi));
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::array at{corner % 2, corner / 2 % 2, corner / 4};
        const auto place = [&](std::size_t i) {
            return cell[i] + static_cast<std::int64_t>(at[i]);
        };
        const std::uint32_t hash = reference_hash(of.seed(), place(0), place(1), place(2));
        const NodeId own =
            of.kind() == NoiseKind::Value
                ? number(static_cast<double>(hash / 256) / 8388608.0 - 1)
                : directed(builder, hash >> 28U, {from[0][at[0]], from[1][at[1]], from[2][at[2]]});
        f = builder.apply(
            Op::Add, f,
            product(own, product(weight[0][at[0]], product(weight[1][at[1]], weight[2][at[2]]))));
    }
    return builder.finish(f);
}

/// Where the ray meets spheres about the cells' points near it, and its ends, in order.
std::vector<double> NoiseOracle::spheres(const RayQuestion& ray, const Cellular& of) const {
    std::vector<double> all{ray.outer_from, ray.outer_to};
    std::array<std::int64_t, 3> first{};
    std::array<std::int64_t, 3> last{};
    const auto level = static_cast<std::int64_t>(std::ceil(level_.hi));
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = along(ray, i, ray.outer_from);
        const double b = along(ray, i, ray.outer_to);
        first[i] = static_cast<std::int64_t>(std::floor(std::min(a, b))) - level - 1;
        last[i] = static_cast<std::int64_t>(std::floor(std::max(a, b))) + level + 1;
    }
    double dd = 0;
    for (const double d : ray.direction)
        dd += d * d;
    for (std::int64_t k = first[2]; k <= last[2]; ++k) {
        for (std::int64_t j = first[1]; j <= last[1]; ++j) {
            for (std::int64_t i = first[0]; i <= last[0]; ++i) {
                const std::array cell{i, j, k};
                std::array<std::uint32_t, 3> wrapped{};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    wrapped[axis] = static_cast<std::uint32_t>(cell[axis]);
                const auto inside = of.point_in(wrapped);
                double b = 0;
                double c = -level_.lo * level_.lo;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double from =
                        ray.eye[axis] - static_cast<double>(cell[axis]) - inside[axis];
                    b += from * ray.direction[axis];
                    c += from * from;
                }
                const double root = b * b - dd * c;
                if (root < 0) continue;
                for (const double sign : {-1.0, 1.0}) {
                    const double t = (-b + sign * std::sqrt(root)) / dd;
                    if (t > ray.outer_from && t < ray.outer_to) all.push_back(t);
                }
            }
        }
    }
    std::ranges::sort(all);
    return all;
}

/// The sign of f at a point of the ray.
int NoiseOracle::sign_at(const RayQuestion& ray, double t) const {
    return sign_on_ray(*field_, level_, ray, t);
}

RayAnswer NoiseOracle::first_change(const RayQuestion& ray, const Cellular& of) const {
    const std::vector<double> ends = spheres(ray, of);
    const double near = 1e-10 * (std::abs(ray.outer_from) + std::abs(ray.outer_to));
    int before = 0;
    for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
        if (ends[n + 1] - ends[n] < 4 * near) continue;
        const int here = sign_at(ray, 0.5 * (ends[n] + ends[n + 1]));
        // A sphere may be touched unseen in a short piece before: then nothing is said.
        const bool is_long = n == 0 || ends[n] - ends[n - 1] >= 4 * near;
        if (before * here < 0)
            return is_long ? hit_between(ray, ends[n] - near, ends[n] + near, true) : RayAnswer{};
        if (!is_long) return {};
        before = here;
    }
    return {RayTruth::Empty, 0.0, 0.0, false};
}

RayAnswer NoiseOracle::answer(const RayQuestion& ray) const {
    if (const auto* const cells = dynamic_cast<const CellularField*>(field_.get()))
        return first_change(ray, cells->function());
    const LatticeNoise& of = dynamic_cast<const LatticeNoiseField&>(*field_).function();
    return first_root(ray,
                      {.ends = planes(ray),
                       .polynomial = [&](double middle) { return polynomial(ray, of, middle); },
                       .sign_at = [&](double t) { return sign_at(ray, t); }});
}

}  // namespace zeroset::test
