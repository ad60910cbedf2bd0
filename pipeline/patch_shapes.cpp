#include "engine/expr/constants.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/vector_nodes.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "pipeline/patch_surface.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset {
namespace {

/// The numbers of one shape as nodes of one graph.
class ShapeBuilder {
public:
    ExprBuilder& builder() { return builder_; }
    NodeId number(double value) { return builder_.constant(value); }
    NodeId copy(const Expr& expr) { return copy_nodes(builder_, expr).back(); }
    VectorNodes copy(const std::array<Expr, 3>& graphs) {
        return {copy(graphs[0]), copy(graphs[1]), copy(graphs[2])};
    }
    VectorNodes constant(const glm::dvec3& v) { return {number(v.x), number(v.y), number(v.z)}; }
    NodeId times(NodeId a, NodeId b) { return make_multiply(builder_, a, b); }
    /// cos or sin of an angle in turns.
    NodeId of_turns(Op function, NodeId turns) {
        const NodeId full = make_constant(builder_, tau);
        return make_call(builder_, function, times(full, turns));
    }
    NodeId minus(NodeId a, NodeId b) { return make_subtract(builder_, a, b); }
    NodeId least(NodeId a, NodeId b) { return make_call(builder_, Op::Min, a, b); }
    /// 0 up to x = from, 1 from x = to on, even between them.
    NodeId ramp(double from, double to) {
        const NodeId x = builder_.variable(0);
        const NodeId part = times(number(1.0 / (to - from)), minus(x, number(from)));
        return least(make_call(builder_, Op::Max, part, number(0.0)), number(1.0));
    }
    /// The graphs with `at` in place of x.
    VectorNodes moved(const std::array<Expr, 3>& graphs, NodeId at) {
        VectorNodes result{};
        for (std::size_t i = 0; i < 3; ++i) {
            std::vector<NodeId> copies;
            for (const Node& node : graphs.at(i).nodes()) {
                const bool is_x = node.op == Op::Variable && node.number == 0;
                copies.push_back(is_x ? at : copy_node(builder_, node, copies));
            }
            result.at(i) = copies.back();
        }
        return result;
    }
    /// The radius of a curve or point at a place.
    NodeId radius(const VectorNodes& place, std::size_t thickness) {
        const auto uniform = [&](std::size_t i) {
            return builder_.variable(variable_w + 1 + static_cast<int>(thickness + i));
        };
        NodeId sum = uniform(0);
        for (std::size_t i = 0; i < 3; ++i)
            sum = make_add(builder_, sum, times(uniform(i + 1), place.at(i)));
        return sum;
    }
    std::array<Expr, 3> finish(const VectorNodes& v, std::span<const std::string> names) {
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

/// The names of a formula's parameters and of uniforms behind them up to those of a thickness.
std::vector<std::string> names_of(const Expr& graph, std::size_t thickness) {
    std::vector<std::string> names = graph.parameter_names();
    names.resize(std::max(names.size(), thickness + thickness_uniforms), "thickness");
    return names;
}

/// A point `radius` aside of `axis`, at an angle of y turns about the direction of `first` and
/// `second`, which are at right angles to it.
VectorNodes about(ShapeBuilder& build, const VectorNodes& axis, NodeId radius,
                  const VectorNodes& first, const VectorNodes& second) {
    ExprBuilder& builder = build.builder();
    const NodeId turn = builder.variable(1);
    const NodeId back = build.minus(build.number(0.0), build.of_turns(Op::Sin, turn));
    const NodeId ahead = build.of_turns(Op::Cos, turn);
    const VectorNodes from_axis =
        make_sum(builder, make_scaled(builder, build.times(radius, ahead), first),
                 make_scaled(builder, build.times(radius, back), second));
    return make_sum(builder, axis, from_axis);
}

std::array<Expr, 3> tube(const std::array<Expr, 3>& curve, std::size_t thickness) {
    std::array<Expr, 3> tangent;
    std::ranges::transform(curve, tangent.begin(),
                           [](const Expr& graph) { return gradient_of(graph)[0]; });
    ShapeBuilder build;
    ExprBuilder& builder = build.builder();
    const VectorNodes way = build.copy(tangent);
    const VectorNodes first =
        make_unit(builder, make_cross(builder, way, build.constant(aside_of(tangent))));
    const VectorNodes second = make_unit(builder, make_cross(builder, way, first));
    const VectorNodes axis = build.copy(curve);
    return build.finish(about(build, axis, build.radius(axis, thickness), first, second),
                        names_of(curve[0], thickness));
}

/// Two directions at right angles to a straight line and to each other, whatever its direction is.
std::array<VectorNodes, 2> asides_of(ShapeBuilder& build, const VectorNodes& way) {
    ExprBuilder& builder = build.builder();
    const VectorNodes by_z = make_cross(builder, way, build.constant({0.0, 0.0, 1.0}));
    const VectorNodes by_x = make_cross(builder, way, build.constant({1.0, 0.0, 0.0}));
    const NodeId is_steep =
        make_call(builder, Op::Less, build.times(build.number(0.5), make_dot(builder, way, way)),
                  make_int_power(builder, way[2], 2));
    VectorNodes aside{};
    for (std::size_t i = 0; i < 3; ++i)
        aside.at(i) = make_call(builder, Op::If, is_steep, by_x.at(i), by_z.at(i));
    const VectorNodes first = make_unit(builder, aside);
    return {first, make_unit(builder, make_cross(builder, way, first))};
}

/// A cylinder about a segment, with both ends closed.
std::array<Expr, 3> rod(const std::array<Expr, 3>& line, std::size_t thickness) {
    ShapeBuilder build;
    std::array<Expr, 3> tangent;
    std::ranges::transform(line, tangent.begin(),
                           [](const Expr& graph) { return gradient_of(graph)[0]; });
    const auto [first, second] = asides_of(build, build.copy(tangent));
    const VectorNodes axis = build.moved(line, build.ramp(0.25, 0.75));
    const NodeId shape = build.minus(build.ramp(0.0, 0.25), build.ramp(0.75, 1.0));
    const NodeId radius = build.times(shape, build.radius(axis, thickness));
    return build.finish(about(build, axis, radius, first, second), names_of(line[0], thickness));
}

/// A rod with a cone at its end, which has three times its radius and takes half of its length at
/// most.
std::array<Expr, 3> arrow(const std::array<Expr, 3>& line, std::size_t thickness) {
    constexpr double head_length = 9.0;  // radii
    constexpr double head_radius = 3.0;
    ShapeBuilder build;
    ExprBuilder& builder = build.builder();
    std::array<Expr, 3> tangent;
    std::ranges::transform(line, tangent.begin(),
                           [](const Expr& graph) { return gradient_of(graph)[0]; });
    const VectorNodes way = build.copy(tangent);
    const auto [first, second] = asides_of(build, way);
    const NodeId length = make_length(builder, way);
    const NodeId thickest = build.times(build.number(0.5 / head_length), length);
    const VectorNodes tip = build.moved(line, build.number(1.0));
    const NodeId at_tip = build.least(build.radius(tip, thickness), thickest);
    const NodeId head =
        make_divide(builder, build.times(build.number(head_length), at_tip), length);
    const NodeId shaft = build.minus(build.number(1.0), head);
    const NodeId along = make_add(builder, build.times(shaft, build.ramp(0.25, 0.5)),
                                  build.times(head, build.ramp(0.75, 1.0)));
    const VectorNodes axis = build.moved(line, along);
    const NodeId own = build.least(build.radius(axis, thickness), thickest);
    const NodeId of_shaft =
        build.times(build.minus(build.ramp(0.0, 0.25), build.ramp(0.5, 0.75)), own);
    const NodeId of_head = build.times(build.minus(build.ramp(0.5, 0.75), build.ramp(0.75, 1.0)),
                                       build.times(build.number(head_radius), at_tip));
    return build.finish(about(build, axis, make_add(builder, of_shaft, of_head), first, second),
                        names_of(line[0], thickness));
}

std::array<Expr, 3> ball(const std::array<Expr, 3>& point, std::size_t thickness) {
    ShapeBuilder build;
    const VectorNodes middle = build.copy(point);
    const NodeId half_turn = build.times(build.number(0.5), build.builder().variable(0));
    const NodeId turn = build.builder().variable(1);
    const NodeId size = build.radius(middle, thickness);
    const NodeId across = build.times(size, build.of_turns(Op::Sin, half_turn));
    const VectorNodes aside{build.times(across, build.of_turns(Op::Cos, turn)),
                            build.times(across, build.of_turns(Op::Sin, turn)),
                            build.times(size, build.of_turns(Op::Cos, half_turn))};
    return build.finish(make_sum(build.builder(), middle, aside), names_of(point[0], thickness));
}

}  // namespace

std::array<Expr, 3> shown_patch(const PatchGraphs& graphs, std::size_t thickness) {
    switch (graphs.kind) {
        case PatchKind::Surface: return graphs.point;
        case PatchKind::Curve: return tube(graphs.point, thickness);
        case PatchKind::Segment: return rod(graphs.point, thickness);
        case PatchKind::Arrow: return arrow(graphs.point, thickness);
        case PatchKind::Point: return ball(graphs.point, thickness);
        case PatchKind::Meeting: break;  // a surface f = 0
    }
    return graphs.point;
}

/// The point d away at which both f + grad f . d and g + grad g . d are 0 is nearest where
///   d^2 = (f^2 G - 2 f g H + g^2 F) / (F G - H^2),   F = |grad f|^2, G = |grad g|^2,
/// and H is the product of both gradients.
Expr meeting_tube(const PatchGraphs& graphs, std::size_t thickness) {
    ShapeBuilder build;
    ExprBuilder& builder = build.builder();
    const NodeId f = build.copy(graphs.point[0]);
    const NodeId g = build.copy(graphs.point[1]);
    const VectorNodes by_f = build.copy(gradient_of(graphs.point[0]));
    const VectorNodes by_g = build.copy(gradient_of(graphs.point[1]));
    const NodeId ff = make_dot(builder, by_f, by_f);
    const NodeId gg = make_dot(builder, by_g, by_g);
    const NodeId fg = make_dot(builder, by_f, by_g);
    const auto square = [&](NodeId a) { return make_int_power(builder, a, 2); };
    const NodeId mixed = build.times(build.number(2.0), build.times(build.times(f, g), fg));
    const NodeId distance = make_subtract(
        builder, make_add(builder, build.times(square(f), gg), build.times(square(g), ff)), mixed);
    const NodeId area = make_subtract(builder, build.times(ff, gg), square(fg));
    const VectorNodes place = make_place(builder);
    const NodeId radius = build.radius(place, thickness);
    NodeId root = make_subtract(builder, distance, build.times(square(radius), area));
    const Expr& condition = graphs.point[2];
    const bool is_limited = condition.node(condition.root()).op != Op::Constant;
    if (is_limited) root = make_call(builder, Op::Where, root, build.copy(condition));
    return builder.finish(root, names_of(graphs.point[0], thickness));
}

}  // namespace zeroset
