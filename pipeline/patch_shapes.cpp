#include "pipeline/patch_shapes.hpp"

#include "engine/expr/constants.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/differences/derivatives.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset {
namespace {

using Vector = std::array<NodeId, 3>;

/// Vectors as nodes of one graph.
class VectorBuilder {
public:
    ExprBuilder& builder() { return builder_; }
    NodeId number(double value) { return builder_.constant(value); }
    NodeId copy(const Expr& expr) { return copy_nodes(builder_, expr).back(); }
    Vector copy(const std::array<Expr, 3>& graphs) {
        return {copy(graphs[0]), copy(graphs[1]), copy(graphs[2])};
    }
    Vector constant(const glm::dvec3& v) { return {number(v.x), number(v.y), number(v.z)}; }
    NodeId times(NodeId a, NodeId b) { return make_multiply(builder_, a, b); }
    Vector times(NodeId a, const Vector& v) {
        return {times(a, v[0]), times(a, v[1]), times(a, v[2])};
    }
    Vector plus(const Vector& a, const Vector& b) {
        Vector sum{};
        for (std::size_t i = 0; i < 3; ++i)
            sum.at(i) = make_add(builder_, a.at(i), b.at(i));
        return sum;
    }
    Vector cross(const Vector& a, const Vector& b) {
        Vector product{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            product.at(i) =
                make_subtract(builder_, times(a.at(j), b.at(k)), times(a.at(k), b.at(j)));
        }
        return product;
    }
    NodeId dot(const Vector& a, const Vector& b) {
        NodeId sum = number(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const NodeId term =
                a.at(i) == b.at(i) ? make_int_power(builder_, a.at(i), 2) : times(a.at(i), b.at(i));
            sum = make_add(builder_, sum, term);
        }
        return sum;
    }
    /// The vector at length 1.
    Vector unit(const Vector& v) {
        const NodeId length = make_call(builder_, Op::Sqrt, dot(v, v));
        return {make_divide(builder_, v[0], length), make_divide(builder_, v[1], length),
                make_divide(builder_, v[2], length)};
    }
    /// cos or sin of an angle in turns.
    NodeId of_turns(Op function, NodeId turns) {
        const NodeId full = builder_.constant(tau.value.lo, tau.value.hi);
        return make_call(builder_, function, times(full, turns));
    }
    std::array<Expr, 3> finish(const Vector& v, std::span<const std::string> names) {
        const std::vector<std::string> parameters(names.begin(), names.end());
        return {builder_.finish(v[0], parameters), builder_.finish(v[1], parameters),
                builder_.finish(v[2], parameters)};
    }

private:
    ExprBuilder builder_;
};

/// Directions over half of the sphere, none of them a likely one of a curve.
std::vector<glm::dvec3> likely_asides() {
    constexpr int count = 64;
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5) / count;
        const double turn = 2.0 * std::acos(-1.0) * (i / golden - std::floor(i / golden));
        const double across = std::sqrt(1.0 - z * z);
        directions.emplace_back(across * std::cos(turn), across * std::sin(turn), z);
    }
    return directions;
}

/// A direction that the curve never has, as far as samples of its tangents tell.
glm::dvec3 aside_of(const std::array<Expr, 3>& tangent) {
    constexpr int samples = 96;
    std::vector<glm::dvec3> tangents;
    for (int i = 0; i <= samples; ++i) {
        glm::dvec3 way(0.0);
        for (int k = 0; k < 3; ++k) {
            const double x = static_cast<double>(i) / samples;
            way[k] = value_at(tangent.at(static_cast<std::size_t>(k)), {x, 0.0, 0.0, 0.0}).value;
        }
        const double length = glm::length(way);
        if (length > 0.0 && std::isfinite(length)) tangents.push_back(way / length);
    }
    glm::dvec3 best(0.36, 0.48, 0.8);
    double least_of_best = 2.0;
    for (const glm::dvec3& direction : likely_asides()) {
        double most = 0.0;
        for (const glm::dvec3& way : tangents)
            most = std::max(most, std::abs(glm::dot(way, direction)));
        if (most >= least_of_best) continue;
        least_of_best = most;
        best = direction;
    }
    return best;
}

std::array<Expr, 3> tube(const std::array<Expr, 3>& curve, double radius) {
    std::array<Expr, 3> tangent;
    std::ranges::transform(curve, tangent.begin(),
                           [](const Expr& graph) { return gradient_of(graph)[0]; });
    VectorBuilder build;
    const Vector way = build.copy(tangent);
    const Vector first = build.unit(build.cross(way, build.constant(aside_of(tangent))));
    const Vector second = build.unit(build.cross(way, first));
    const NodeId turn = build.builder().variable(1);
    const NodeId size = build.number(radius);
    const Vector aside = build.plus(
        build.times(build.times(size, build.of_turns(Op::Cos, turn)), first),
        build.times(build.times(build.number(-radius), build.of_turns(Op::Sin, turn)), second));
    return build.finish(build.plus(build.copy(curve), aside), curve[0].parameters());
}

std::array<Expr, 3> ball(const std::array<Expr, 3>& point, double radius) {
    VectorBuilder build;
    const NodeId half_turn = build.times(build.number(0.5), build.builder().variable(0));
    const NodeId turn = build.builder().variable(1);
    const NodeId size = build.number(radius);
    const NodeId across = build.times(size, build.of_turns(Op::Sin, half_turn));
    const Vector aside{build.times(across, build.of_turns(Op::Cos, turn)),
                       build.times(across, build.of_turns(Op::Sin, turn)),
                       build.times(size, build.of_turns(Op::Cos, half_turn))};
    return build.finish(build.plus(build.copy(point), aside), point[0].parameters());
}

}  // namespace

std::array<Expr, 3> shown_patch(const PatchGraphs& graphs, double radius) {
    switch (graphs.kind) {
        case PatchKind::Surface: return graphs.point;
        case PatchKind::Curve: return tube(graphs.point, radius);
        case PatchKind::Point: return ball(graphs.point, 2.0 * radius);
        case PatchKind::Meeting: break;  // a surface f = 0
    }
    return graphs.point;
}

/// The point d away at which both f + grad f . d and g + grad g . d are 0 is nearest where
///   d^2 = (f^2 G - 2 f g H + g^2 F) / (F G - H^2),   F = |grad f|^2, G = |grad g|^2,
/// and H is the product of both gradients.
Expr meeting_tube(const PatchGraphs& graphs, double radius) {
    VectorBuilder build;
    ExprBuilder& builder = build.builder();
    const NodeId f = build.copy(graphs.point[0]);
    const NodeId g = build.copy(graphs.point[1]);
    const Vector by_f = build.copy(gradient_of(graphs.point[0]));
    const Vector by_g = build.copy(gradient_of(graphs.point[1]));
    const NodeId ff = build.dot(by_f, by_f);
    const NodeId gg = build.dot(by_g, by_g);
    const NodeId fg = build.dot(by_f, by_g);
    const auto square = [&](NodeId a) { return make_int_power(builder, a, 2); };
    const NodeId mixed = build.times(build.number(2.0), build.times(build.times(f, g), fg));
    const NodeId distance = make_subtract(
        builder, make_add(builder, build.times(square(f), gg), build.times(square(g), ff)), mixed);
    const NodeId area = make_subtract(builder, build.times(ff, gg), square(fg));
    NodeId root =
        make_subtract(builder, distance, build.times(build.number(radius * radius), area));
    const Expr& condition = graphs.point[2];
    const bool is_limited = condition.node(condition.root()).op != Op::Constant;
    if (is_limited) root = make_call(builder, Op::Where, root, build.copy(condition));
    const auto names = graphs.point[0].parameters();
    return builder.finish(root, {names.begin(), names.end()});
}

}  // namespace zeroset
