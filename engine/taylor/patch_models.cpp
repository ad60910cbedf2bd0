// Models of the coordinates of a patch, node by node [MakBer03]: polynomials about the middles of
// boxes, with bounds of what is beyond their degree, of the functions' own series and of rounding.

#include "engine/taylor/patch_models.hpp"

#include "engine/real/unbounded.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/taylor/patch_models.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/algebra/facts.hpp"
#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/taylor/model-inl.hpp"
#include "engine/taylor/series.hpp"

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#ifndef ZEROSET_PATCH_GRAPH
#define ZEROSET_PATCH_GRAPH
namespace zeroset {

/// The coordinates' graphs in one, so that what they share is computed once.
struct PatchGraph {
    std::vector<Node> nodes;  ///< operands first
    std::vector<Facts> facts;
    std::array<NodeId, 3> roots;
};

}  // namespace zeroset
#endif

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The middle and the radius of an interval.
inline std::array<double, 2> middle_of(double neg_lo, double hi) {
    const double middle = 0.5 * hi - 0.5 * neg_lo;
    return {middle, std::max(hi - middle, middle + neg_lo)};
}

/// Variable 0 or 1 over the boxes.
inline Model variable_model(const UvBox* boxes, int variable) {
    HWY_ALIGN double middles[lanes<double>];
    HWY_ALIGN double radii[lanes<double>];
    for (std::size_t lane = 0; lane < lanes<double>; ++lane) {
        const UvBox& box = boxes[lane];
        middles[lane] = variable == 0 ? box.u : box.v;
        radii[lane] = variable == 0 ? box.u_radius : box.v_radius;
    }
    Model model = constant_model(hn::Load(d<double>, middles), number(0.0));
    model.terms[variable == 0 ? patch_term(1, 0) : patch_term(0, 1)] = hn::Load(d<double>, radii);
    return model;
}

inline Model leaf_model(const Node& node, const Facts& facts, const UvBox* boxes,
                        const Uniforms& uniforms) {
    if (facts.constant) {
        const auto [middle, radius] = middle_of(facts.constant->neg_lo, facts.constant->hi);
        return constant_model(number(middle), number(radius));
    }
    if (node.op != Op::Variable || node.number == 2) return unknown_model();
    if (node.number < 2) return variable_model(boxes, node.number);
    const auto ends = uniforms.all_boxes<double>();
    const std::size_t at = 2 * static_cast<std::size_t>(node.number - variable_w);
    if (at + 1 >= ends.size()) return unknown_model();
    const auto [middle, radius] = middle_of(ends[at], ends[at + 1]);
    return constant_model(number(middle), number(radius));
}

inline Model quotient_of(const Model& a, const Model& b) {
    return product_of(a, composed(b, reciprocal_series));
}

inline Model function_of(Op op, const Model& a) {
    return composed(a, [op](double c, double reach) { return series_of(op, c, reach); });
}

/// tanh(a) = 1 - 2 / (exp(2 a) + 1).
inline Model tanh_of(const Model& a) {
    const Model one = constant_model(number(1.0), number(0.0));
    const Model two = constant_model(number(2.0), number(0.0));
    const Model below = sum_of(function_of(Op::Exp, sum_of(a, a)), one);
    return sum_of(one, negated(quotient_of(two, below)));
}

inline Model product_with(const Node& node, const std::vector<Facts>& facts, const Model* models) {
    const Model& a = models[node.a];
    const Model& b = models[node.b];
    if (facts[node.a].uniform) return scaled(b, a.terms[0], a.error);
    if (facts[node.b].uniform) return scaled(a, b.terms[0], b.error);
    return product_of(a, b);
}

inline Model operator_model(const Node& node, const std::vector<Facts>& facts,
                            const Model* models) {
    const Model& a = models[node.a];
    const Model& b = models[node.b];
    if (has_series(node.op)) return function_of(node.op, a);
    if (node.op == Op::Negate) return negated(a);
    if (node.op == Op::Add) return sum_of(a, b);
    if (node.op == Op::Subtract) return sum_of(a, negated(b));
    if (node.op == Op::Multiply) return product_with(node, facts, models);
    if (node.op == Op::Divide) return quotient_of(a, b);
    if (node.op == Op::IntPower) return power_of(a, node.number);
    if (node.op == Op::Tan) return quotient_of(function_of(Op::Sin, a), function_of(Op::Cos, a));
    if (node.op == Op::Cot) return quotient_of(function_of(Op::Cos, a), function_of(Op::Sin, a));
    if (node.op == Op::Tanh) return tanh_of(a);
    if (node.op == Op::Length)
        return function_of(Op::Sqrt, sum_of(product_of(a, a), product_of(b, b)));
    if (node.op == Op::Abs) return size_of(a);
    if (node.op == Op::Max) return larger_of(a, b);
    if (node.op == Op::Min) return negated(larger_of(negated(a), negated(b)));
    return unknown_model();
}

/// The models of as many boxes as a vector has lanes.
inline void make_some(const PatchGraph& graph, const UvBox* boxes, const Uniforms& uniforms,
                      Model* models, PatchModel* out) {
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const Node& node = graph.nodes[i];
        const bool is_leaf = arity(node.op) == 0 || graph.facts[i].constant.has_value();
        models[i] = is_leaf ? leaf_model(node, graph.facts[i], boxes, uniforms)
                            : operator_model(node, graph.facts, models);
    }
    HWY_ALIGN double numbers[lanes<double>];
    for (std::size_t k = 0; k < 3; ++k) {
        const Model& model = models[graph.roots[k]];
        for (std::size_t term = 0; term < patch_terms; ++term) {
            hn::Store(model.terms[term], d<double>, numbers);
            for (std::size_t lane = 0; lane < lanes<double>; ++lane)
                out[lane].terms[k][term] = numbers[lane];
        }
        hn::Store(model.error, d<double>, numbers);
        for (std::size_t lane = 0; lane < lanes<double>; ++lane)
            out[lane].error[k] = numbers[lane];
    }
}

void make_all(const PatchGraph& graph, std::span<const UvBox> boxes, const Uniforms& uniforms,
              std::span<PatchModel> out) {
    const auto models = hwy::AllocateAligned<Model>(graph.nodes.size());
    std::array<UvBox, lanes<double>> some;
    std::array<PatchModel, lanes<double>> made;
    for (std::size_t first = 0; first < boxes.size(); first += lanes<double>) {
        const std::size_t count = std::min(lanes<double>, boxes.size() - first);
        for (std::size_t lane = 0; lane < lanes<double>; ++lane)
            some[lane] = boxes[first + std::min(lane, count - 1)];
        make_some(graph, some.data(), uniforms, models.get(), made.data());
        std::copy_n(made.begin(), count, out.begin() + static_cast<std::ptrdiff_t>(first));
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(make_all);

namespace {

/// Nothing is known of a coordinate whose numbers are not all finite.
void check(PatchModel& model) {
    for (std::size_t k = 0; k < 3; ++k) {
        double size = model.error[k];
        for (const double term : model.terms[k])
            size += std::abs(term);
        if (size < unbounded) continue;
        model.terms[k] = {};
        model.error[k] = unbounded;
    }
}

class GraphModeler final : public PatchModeler {
public:
    explicit GraphModeler(PatchGraph graph) : graph_(std::move(graph)) {}

    void make_models(std::span<const UvBox> boxes, const Uniforms& uniforms,
                     std::span<PatchModel> models) const override {
        assert(boxes.size() == models.size());
        HWY_DYNAMIC_DISPATCH(make_all)(graph_, boxes, uniforms, models);
        std::ranges::for_each(models, check);
    }

private:
    PatchGraph graph_;
};

/// Whether an operator has a model somewhere.
bool has_model(const Node& node) {
    if (has_series(node.op)) return true;
    constexpr std::array others{Op::Constant, Op::Variable, Op::Negate, Op::Add, Op::Subtract,
                                Op::Multiply, Op::Divide,   Op::Tan,    Op::Cot, Op::Tanh,
                                Op::Length,   Op::Abs,      Op::Max,    Op::Min};
    if (node.op == Op::IntPower) return node.number >= 1;
    return std::ranges::find(others, node.op) != others.end();
}

}  // namespace

std::shared_ptr<const PatchModeler> patch_modeler(const std::array<Expr, 3>& point) {
    ExprBuilder builder;
    PatchGraph graph;
    for (std::size_t k = 0; k < 3; ++k)
        graph.roots.at(k) = copy_nodes(builder, point.at(k)).back();
    for (NodeId id = 0; id < builder.size(); ++id) {
        graph.nodes.push_back(builder.node(id));
        graph.facts.push_back(facts_of_node(graph.nodes.back(), graph.facts));
        if (!graph.facts.back().constant && !has_model(graph.nodes.back())) return nullptr;
    }
    return std::make_shared<const GraphModeler>(std::move(graph));
}

}  // namespace zeroset

#endif
