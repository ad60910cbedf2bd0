#include "tests/support/oracle/volume_oracle.hpp"

#include "tests/support/oracle/cell_signs.hpp"
#include "tests/support/oracle/field_level.hpp"
#include "tests/support/oracle/piece_roots.hpp"
#include "tests/support/sample_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace zeroset::test {
namespace {

using Wide = long double;

/// Index i along a ray: at its eye, and by t.
std::array<Wide, 2> index_line(const IndexMap& map, std::size_t i, const RayQuestion& ray) {
    Wide at = map.shift[i];
    Wide by = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        at += Wide{map.index_from_world[i][c]} * ray.eye[c];
        by += Wide{map.index_from_world[i][c]} * ray.direction[c];
    }
    return {at, by};
}

/// The cell of the point at `middle`, which is not on its border; nullopt where the volume is not
/// defined there.
std::optional<CellLevel> cell_at(const Volume& volume, const Node& level, const RayQuestion& ray,
                                 double middle) {
    CellLevel result{.volume = volume, .cell = {}, .fixed = {}, .lo = level.lo, .hi = level.hi};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [at, by] = index_line(volume.data().map(), i, ray);
        const Wide index = at + by * middle;
        const auto last = static_cast<std::int64_t>(volume.data().samples().size[i]) - 2;
        const bool beyond = index < 0 || index > static_cast<Wide>(last + 1);
        if (beyond && volume.options().outside == Outside::Undefined) return std::nullopt;
        const auto own =
            std::clamp(static_cast<std::int64_t>(std::floor(index)), std::int64_t{0}, last);
        result.cell[i] = static_cast<std::uint64_t>(own);
        if (beyond) result.fixed[i] = index < 0 ? 0 : 1;
    }
    return result;
}

}  // namespace

std::optional<VolumeOracle> VolumeOracle::of(const Expr& expr) {
    const auto found = field_level(expr);
    if (!found) return std::nullopt;
    auto volume = std::dynamic_pointer_cast<const Volume>(found->field);
    const bool usable =
        volume && volume->options().outside != Outside::Constant && !volume->data().range().holes;
    if (!usable) return std::nullopt;
    return VolumeOracle(std::move(volume), found->level);
}

/// Where the ray meets the planes of the grid, and its ends, in order.
std::vector<double> VolumeOracle::crossings(const RayQuestion& ray) const {
    std::vector<double> all{ray.outer_from, ray.outer_to};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [at, by] = index_line(volume_->data().map(), i, ray);
        if (by == 0) continue;
        for (std::uint64_t plane = 0; plane < volume_->data().samples().size[i]; ++plane) {
            const auto t = static_cast<double>((static_cast<Wide>(plane) - at) / by);
            if (t > ray.outer_from && t < ray.outer_to) all.push_back(t);
        }
    }
    std::ranges::sort(all);
    return all;
}

/// f in the cell of the point at `middle`, as a polynomial; nullopt where it is not defined there.
std::optional<Expr> VolumeOracle::polynomial(const RayQuestion& ray, double middle) const {
    ExprBuilder builder;
    const IndexMap& map = volume_->data().map();
    const auto sum = [&](NodeId a, NodeId b) { return builder.apply(Op::Add, a, b); };
    const auto product = [&](NodeId a, NodeId b) { return builder.apply(Op::Multiply, a, b); };
    const auto number = [&](double value) { return builder.constant(value); };
    const auto place = cell_at(*volume_, level_, ray, middle);
    if (!place) return std::nullopt;
    const auto& cell = place->cell;
    std::array<std::vector<NodeId>, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) {
        NodeId above = number(place->fixed[i].value_or(0));
        if (!place->fixed[i]) {
            above = sum(number(map.shift[i]), number(-static_cast<double>(cell[i])));
            for (std::size_t c = 0; c < 3; ++c) {
                above = sum(above, product(number(map.index_from_world[i][c]),
                                           builder.variable(static_cast<int>(c))));
            }
        }
        weights[i] = cell_weights(builder, above);
    }
    const SplineData* const spline = volume_->spline();
    NodeId f = builder.apply(Op::Negate, builder.constant(level_.lo, level_.hi));
    if (spline != nullptr) f = product(f, number(216));  // its weights are six times themselves
    const std::size_t count = weights[0].size();
    for (std::size_t n = 0; n < count * count * count; ++n) {
        const std::array of{n % count, n / count % count, n / (count * count)};
        const std::array at{cell[0] + of[0], cell[1] + of[1], cell[2] + of[2]};
        const double factor = spline != nullptr ? coefficient_at(*spline, at[0], at[1], at[2])
                                                : sample_at(volume_->data(), at[0], at[1], at[2]);
        f = sum(f, product(product(number(factor), weights[0][of[0]]),
                           product(weights[1][of[1]], weights[2][of[2]])));
    }
    return builder.finish(f);
}

/// The weights of the numbers about a cell along an axis, where `above` is the place in it; of a
/// spline six times as much.
std::vector<NodeId> VolumeOracle::cell_weights(ExprBuilder& builder, NodeId above) const {
    const auto number = [&](double value) { return builder.constant(value); };
    const auto product = [&](NodeId a, NodeId b) { return builder.apply(Op::Multiply, a, b); };
    const NodeId below = builder.apply(Op::Subtract, number(1), above);
    if (volume_->spline() == nullptr) return {below, above};
    const auto cube = [&](NodeId t) { return product(t, product(t, t)); };
    const auto middle = [&](NodeId t) {  // 3 t^3 - 6 t^2 + 4
        const NodeId high = product(number(3), cube(t));
        const NodeId low = product(number(6), product(t, t));
        return builder.apply(Op::Add, builder.apply(Op::Subtract, high, low), number(4));
    };
    return {cube(below), middle(above), middle(below), cube(above)};
}

/// The sign of f at a point of the ray; 0 where it is 0 or not defined.
int VolumeOracle::sign_at(const RayQuestion& ray, double t) const {
    return sign_on_ray(*volume_, level_, ray, t);
}

RayAnswer VolumeOracle::answer(const RayQuestion& ray) const {
    const auto surely_empty = [&](double from, double to) {
        const auto cell = cell_at(*volume_, level_, ray, from + 0.5 * (to - from));
        return !cell || sign_in_cell(*cell, ray, from, to) != StretchSign::Unknown;
    };
    return first_root(ray, {.ends = crossings(ray),
                            .polynomial = [&](double middle) { return polynomial(ray, middle); },
                            .sign_at = [&](double t) { return sign_at(ray, t); },
                            .surely_empty = surely_empty});
}

}  // namespace zeroset::test
