#include "tests/support/oracle/blob_oracle.hpp"

#include "tests/support/oracle/field_level.hpp"
#include "tests/support/oracle/piece_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset::test {

std::optional<BlobOracle> BlobOracle::of(const Expr& expr) {
    const auto found = field_level(expr);
    auto field = found ? std::dynamic_pointer_cast<const BlobsField>(found->field) : nullptr;
    if (!field || field->function().kind() != BlobKind::Wyvill) return std::nullopt;
    return BlobOracle(std::move(field), found->level);
}

/// Where the ray enters and leaves supports, and its ends, in order.
std::vector<double> BlobOracle::ends(const RayQuestion& ray) const {
    std::vector<double> all{ray.outer_from, ray.outer_to};
    const BlobSet& set = field_->function().set();
    for (std::size_t n = 0; n < set.size(); ++n) {
        double a = 0;
        double b = 0;
        double c = -4 * set.radius()[n] * set.radius()[n];
        for (std::size_t i = 0; i < 3; ++i) {
            const double from = ray.eye[i] - set.center(i)[n];
            a += ray.direction[i] * ray.direction[i];
            b += ray.direction[i] * from;
            c += from * from;
        }
        const double root = b * b - a * c;
        if (root < 0) continue;
        for (const double sign : {-1.0, 1.0}) {
            const double t = (-b + sign * std::sqrt(root)) / a;
            if (t > ray.outer_from && t < ray.outer_to) all.push_back(t);
        }
    }
    std::ranges::sort(all);
    return all;
}

std::optional<Expr> BlobOracle::polynomial(const RayQuestion& ray, double middle) const {
    ExprBuilder builder;
    const auto number = [&](double value) { return builder.constant(value); };
    const auto product = [&](NodeId a, NodeId b) { return builder.apply(Op::Multiply, a, b); };
    const auto sum = [&](NodeId a, NodeId b) { return builder.apply(Op::Add, a, b); };
    const auto share = [&](double a, double b) {
        return builder.apply(Op::Divide, number(a), number(b));
    };
    NodeId f = builder.apply(Op::Negate, builder.constant(level_.lo, level_.hi));
    const BlobSet& set = field_->function().set();
    for (std::size_t n = 0; n < set.size(); ++n) {
        double distance = 0;
        NodeId squares = number(0);
        for (std::size_t i = 0; i < 3; ++i) {
            const double from = ray.eye[i] + middle * ray.direction[i] - set.center(i)[n];
            distance += from * from;
            const NodeId x = builder.apply(Op::Subtract, builder.variable(static_cast<int>(i)),
                                           number(set.center(i)[n]));
            squares = sum(squares, product(x, x));
        }
        const double radius = set.radius()[n];
        if (distance >= 4 * radius * radius) continue;
        // (1 - c)^2 (9 - 4 c)/9 is 1 - 22/9 c + 17/9 c^2 - 4/9 c^3.
        const NodeId c = builder.apply(Op::Divide, squares,
                                       product(number(4), product(number(radius), number(radius))));
        const NodeId rest = builder.apply(Op::Subtract, number(1), c);
        const NodeId inner = builder.apply(Op::Subtract, number(1), product(share(4, 9), c));
        const NodeId height = product(number(2), product(product(rest, rest), inner));
        f = sum(f, product(number(set.strength()[n]), height));
    }
    return builder.finish(f);
}

RayAnswer BlobOracle::answer(const RayQuestion& ray) const {
    return first_root(ray,
                      {.ends = ends(ray),
                       .polynomial = [&](double middle) { return polynomial(ray, middle); },
                       .sign_at = [&](double t) { return sign_on_ray(*field_, level_, ray, t); }});
}

}  // namespace zeroset::test
