#include "engine/expr/constants.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/vocabulary/functions.hpp"

#include <array>
#include <cassert>
#include <numeric>
#include <vector>

// The functions as graphs.

namespace zeroset {
namespace {

/// Applies a binary operator from left to right to two or more arguments, or returns the only one.
NodeId fold(ExprBuilder& builder, Op op, std::span<const NodeId> arguments) {
    return std::accumulate(arguments.begin() + 1, arguments.end(), arguments.front(),
                           [&](NodeId a, NodeId b) { return make_call(builder, op, a, b); });
}

NodeId length_of(ExprBuilder& builder, std::span<const NodeId> arguments) {
    if (arguments.size() == 1) return make_call(builder, Op::Abs, arguments.front());
    const auto square = [&](NodeId a) { return make_multiply(builder, a, a); };
    const NodeId sum =
        std::accumulate(arguments.begin() + 1, arguments.end(), square(arguments.front()),
                        [&](NodeId a, NodeId b) { return make_add(builder, a, square(b)); });
    return make_call(builder, Op::Sqrt, sum);
}

/// The quadratic blend min(a, b) - h^2 / (4 k) with h = max(k - |a - b|, 0); it differs from min
/// only where |a - b| < k.
NodeId smooth_min(ExprBuilder& builder, NodeId a, NodeId b, NodeId k) {
    const NodeId distance = make_call(builder, Op::Abs, make_subtract(builder, a, b));
    const NodeId h =
        make_call(builder, Op::Max, make_subtract(builder, k, distance), builder.constant(0.0));
    const NodeId blend = make_divide(builder, make_multiply(builder, h, h),
                                     make_multiply(builder, builder.constant(4.0), k));
    return make_subtract(builder, make_call(builder, Op::Min, a, b), blend);
}

NodeId smooth_max(ExprBuilder& builder, NodeId a, NodeId b, NodeId k) {
    return make_negate(builder,
                       smooth_min(builder, make_negate(builder, a), make_negate(builder, b), k));
}

NodeId make_logarithm(ExprBuilder& builder, std::span<const NodeId> a) {
    if (a.size() == 1) return make_call(builder, Op::Log, a[0]);
    const std::optional<double> base = exact_value(builder, a[1]);
    if (base == 2.0) return make_call(builder, Op::Log2, a[0]);
    if (base == 10.0) return make_call(builder, Op::Log10, a[0]);
    return make_divide(builder, make_call(builder, Op::Log, a[0]),
                       make_call(builder, Op::Log, a[1]));
}

/// trunc(a): floor(a) for a >= 0, ceil(a) below.
NodeId make_trunc(ExprBuilder& builder, NodeId a) {
    const NodeId below = make_call(builder, Op::Less, a, builder.constant(0.0));
    return make_call(builder, Op::If, below, make_call(builder, Op::Ceil, a),
                     make_call(builder, Op::Floor, a));
}

NodeId make_clamp(ExprBuilder& builder, NodeId a, NodeId low, NodeId high) {
    return make_call(builder, Op::Min, make_call(builder, Op::Max, a, low), high);
}

/// t^2 (3 - 2t) with t = (a - low)/(high - low) clamped to [0, 1].
NodeId make_smooth_step(ExprBuilder& builder, NodeId low, NodeId high, NodeId a) {
    const NodeId whole = make_subtract(builder, high, low);
    const NodeId part = make_divide(builder, make_subtract(builder, a, low), whole);
    const NodeId t = make_clamp(builder, part, builder.constant(0.0), builder.constant(1.0));
    const NodeId twice = make_multiply(builder, builder.constant(2.0), t);
    return make_multiply(builder, make_multiply(builder, t, t),
                         make_subtract(builder, builder.constant(3.0), twice));
}

NodeId make_fmod(ExprBuilder& builder, NodeId a, NodeId b) {
    const NodeId whole = make_trunc(builder, make_divide(builder, a, b));
    return make_subtract(builder, a, make_multiply(builder, b, whole));
}

/// a + t*(b - a)
NodeId make_mix(ExprBuilder& builder, NodeId a, NodeId b, NodeId t) {
    return make_add(builder, a, make_multiply(builder, t, make_subtract(builder, b, a)));
}

NodeId make_step(ExprBuilder& builder, NodeId edge, NodeId a) {
    return make_call(builder, Op::If, make_call(builder, Op::Less, a, edge), builder.constant(0.0),
                     builder.constant(1.0));
}

/// POV-Ray's select(a, below, above) and select(a, below, at 0, above).
NodeId make_select(ExprBuilder& builder, std::span<const NodeId> a) {
    const NodeId zero = builder.constant(0.0);
    NodeId otherwise = a[2];
    if (a.size() == 4) {
        const NodeId above = make_call(builder, Op::Less, zero, a[0]);
        otherwise = make_call(builder, Op::If, above, a[3], a[2]);
    }
    return make_call(builder, Op::If, make_call(builder, Op::Less, a[0], zero), a[1], otherwise);
}

/// The angle a in other units: a*p/q.
NodeId make_angle(ExprBuilder& builder, NodeId a, NodeId p, NodeId q) {
    return make_multiply(builder, make_divide(builder, p, q), a);
}

using Blend = NodeId (*)(ExprBuilder&, NodeId, NodeId, NodeId);

NodeId smooth_without(ExprBuilder& builder, NodeId a, NodeId b, NodeId k) {
    return smooth_max(builder, a, make_negate(builder, b), k);
}

/// Blends all but the last argument, which is the width k, from left to right.
NodeId blended(ExprBuilder& builder, std::span<const NodeId> a, Blend blend) {
    const auto solids = a.first(a.size() - 1);
    return std::accumulate(solids.begin() + 1, solids.end(), solids.front(),
                           [&](NodeId of, NodeId b) { return blend(builder, of, b, a.back()); });
}

NodeId make_without(ExprBuilder& builder, std::span<const NodeId> a) {
    return std::accumulate(a.begin() + 1, a.end(), a.front(), [&](NodeId solid, NodeId hole) {
        return make_call(builder, Op::Max, solid, make_negate(builder, hole));
    });
}

/// f_torus(x, y, z, R, r): a torus around the y-axis.
NodeId make_torus(ExprBuilder& builder, std::span<const NodeId> a) {
    const NodeId across = length_of(builder, std::array{a[0], a[2]});
    const NodeId tube = length_of(builder, std::array{make_subtract(builder, across, a[3]), a[1]});
    return make_subtract(builder, tube, a[4]);
}

/// f_superellipsoid(x, y, z, e, n)
NodeId make_superellipsoid(ExprBuilder& builder, std::span<const NodeId> a) {
    const NodeId two = builder.constant(2.0);
    const auto powered = [&](NodeId of, NodeId over) {
        const NodeId size = make_call(builder, Op::Abs, of);
        return make_power(builder, size, make_divide(builder, two, over));
    };
    const NodeId across =
        make_power(builder, make_add(builder, powered(a[0], a[3]), powered(a[1], a[3])),
                   make_divide(builder, a[3], a[4]));
    const NodeId size = make_power(builder, make_add(builder, across, powered(a[2], a[4])),
                                   make_divide(builder, a[4], two));
    return make_subtract(builder, builder.constant(1.0), size);
}

/// f_rounded_box(x, y, z, r, a, b, c): the distance from the box shrunk by r, minus r.
NodeId make_rounded_box(ExprBuilder& builder, std::span<const NodeId> a) {
    std::array<NodeId, 3> outside{};
    for (std::size_t i = 0; i < outside.size(); ++i) {
        const NodeId size = make_call(builder, Op::Abs, a[i]);
        const NodeId over = make_subtract(builder, size, make_subtract(builder, a[4 + i], a[3]));
        outside.at(i) = make_call(builder, Op::Max, over, builder.constant(0.0));
    }
    return make_subtract(builder, length_of(builder, outside), a[3]);
}

/// f_ellipsoid(x, y, z, a, b, c)
NodeId make_ellipsoid(ExprBuilder& builder, std::span<const NodeId> a) {
    std::array<NodeId, 3> scaled{};
    for (std::size_t i = 0; i < scaled.size(); ++i)
        scaled.at(i) = make_multiply(builder, a[3 + i], a[i]);
    return length_of(builder, scaled);
}

// NOLINTNEXTLINE(readability-function-size): a table
NodeId make_composed(ExprBuilder& builder, Composed function, std::span<const NodeId> a) {
    const NodeId one = builder.constant(1.0);
    const auto reciprocal = [&](NodeId of) { return make_divide(builder, one, of); };
    switch (function) {
        case Composed::Cbrt: return make_root(builder, a[0], 3);
        case Composed::Root: return make_power(builder, a[0], reciprocal(a[1]));
        case Composed::Pow: return make_power(builder, a[0], a[1]);
        case Composed::LogBase: return make_logarithm(builder, a);
        case Composed::Sec: return reciprocal(make_call(builder, Op::Cos, a[0]));
        case Composed::Csc: return reciprocal(make_call(builder, Op::Sin, a[0]));
        case Composed::Sech: return reciprocal(make_call(builder, Op::Cosh, a[0]));
        case Composed::Csch: return reciprocal(make_call(builder, Op::Sinh, a[0]));
        case Composed::Coth: return reciprocal(make_call(builder, Op::Tanh, a[0]));
        case Composed::Exp2: return make_power(builder, builder.constant(2.0), a[0]);
        case Composed::Trunc: return make_trunc(builder, a[0]);
        case Composed::Fract:
            return make_subtract(builder, a[0], make_call(builder, Op::Floor, a[0]));
        case Composed::Fmod: return make_fmod(builder, a[0], a[1]);
        case Composed::Step: return make_step(builder, a[0], a[1]);
        case Composed::SmoothStep: return make_smooth_step(builder, a[0], a[1], a[2]);
        case Composed::Mix: return make_mix(builder, a[0], a[1], a[2]);
        case Composed::Select: return make_select(builder, a);
        case Composed::Degrees:
            return make_angle(builder, a[0], builder.constant(180.0), make_constant(builder, pi));
        case Composed::Radians:
            return make_angle(builder, a[0], make_constant(builder, pi), builder.constant(180.0));
        case Composed::InverseSqrt: return reciprocal(make_call(builder, Op::Sqrt, a[0]));
        case Composed::Hypot:
        case Composed::Length: return length_of(builder, a);
        case Composed::Clamp: return make_clamp(builder, a[0], a[1], a[2]);
        case Composed::SmoothMin: return smooth_min(builder, a[0], a[1], a[2]);
        case Composed::SmoothMax: return smooth_max(builder, a[0], a[1], a[2]);
        case Composed::SmoothUnion: return blended(builder, a, smooth_min);
        case Composed::SmoothIntersect: return blended(builder, a, smooth_max);
        case Composed::SmoothSubtract: return blended(builder, a, smooth_without);
        case Composed::Sphere: return make_subtract(builder, length_of(builder, a.first(3)), a[3]);
        case Composed::Torus: return make_torus(builder, a);
        case Composed::Ellipsoid: return make_ellipsoid(builder, a);
        case Composed::Superellipsoid: return make_superellipsoid(builder, a);
        case Composed::RoundedBox: return make_rounded_box(builder, a);
        case Composed::Union: return fold(builder, Op::Min, a);
        case Composed::Intersect: return fold(builder, Op::Max, a);
        case Composed::Without: return make_without(builder, a);
        case Composed::Vector2:
        case Composed::Vector3:
        case Composed::Vector4:
        case Composed::Iterate:
        case Composed::DistanceEstimate:
        case Composed::Keep:
        case Composed::Kept:
        case Composed::Least:
        case Composed::Greatest:
        case Composed::Sum:
        case Composed::Product:
#define ZEROSET_WRITTEN(section, id, name, least, most, arguments, meaning) case Composed::id:
#include "engine/language/vocabulary/noises.def"
#include "engine/language/vocabulary/specials.def"
#include "engine/language/vocabulary/written_out.def"
#undef ZEROSET_WRITTEN
            break;
    }
    assert(false);  // the elaborator writes these functions out
    return a[0];
}

}  // namespace

NodeId make_function(ExprBuilder& builder, const Function& function,
                     std::span<const NodeId> arguments) {
    assert(function.takes(arguments.size()));
    if (function.composed) return make_composed(builder, *function.composed, arguments);
    const Op op = *function.op;
    if (op == Op::Min || op == Op::Max) return fold(builder, op, arguments);
    const NodeId b = arguments.size() > 1 ? arguments[1] : 0;
    const NodeId c = arguments.size() > 2 ? arguments[2] : 0;
    return make_call(builder, op, arguments[0], b, c);
}

}  // namespace zeroset
