#include "engine/rewrite/differences/derivatives.hpp"

// The carrier before the templates that look its operations up.
#include "engine/rewrite/differences/graph_number.hpp"
// Rules over any carrier.
#include "engine/algebra/algebra.hpp"
#include "engine/expr/copy.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {
namespace {

using Gradient = std::array<std::optional<GraphNumber>, 3>;

/// Derivatives of the nodes of one builder, each made only once.
class Differentiator {
public:
    explicit Differentiator(ExprBuilder& builder) : builder_(builder) {}

    /// By x, y and z; one that is absent is 0.
    Gradient of(NodeId root);

private:
    /// Nodes that the root is made of and whose derivatives are not known yet, operands first.
    [[nodiscard]] std::vector<NodeId> unknown_below(NodeId root) const;
    Dual<GraphNumber> made(NodeId id);
    [[nodiscard]] bool is_known(NodeId id) const { return id < known_.size() && known_[id]; }

    ExprBuilder& builder_;
    DualAlgebra<GraphNumber> algebra_;
    std::vector<std::optional<Dual<GraphNumber>>> known_;  ///< by node
};

std::vector<NodeId> Differentiator::unknown_below(NodeId root) const {
    std::vector<bool> needed(root + 1);
    needed[root] = true;
    std::vector<NodeId> nodes;
    for (NodeId id = root + 1; id-- > 0;) {
        if (!needed[id] || is_known(id)) continue;
        nodes.push_back(id);
        const Node& node = builder_.node(id);
        const std::array operands{node.a, node.b, node.c};
        for (int i = 0; i < arity(node.op); ++i)
            needed[operands.at(static_cast<std::size_t>(i))] = true;
    }
    return {nodes.rbegin(), nodes.rend()};
}

Dual<GraphNumber> Differentiator::made(NodeId id) {
    const Node node = builder_.node(id);
    const GraphNumber itself{.builder = &builder_, .id = id};
    Dual<GraphNumber> result{.value = itself, .slope = {}};
    if (node.op == Op::Variable) {
        const auto v = static_cast<std::size_t>(node.number);
        if (v < 3) result.slope.set(v, like(itself, 1.0));
    } else if (arity(node.op) > 0) {
        static const Facts unknown;
        result = apply_to(algebra_, node, [&](NodeId operand) {
            return Operand<Dual<GraphNumber>>{.value = *known_[operand], .facts = unknown};
        });
        result.value = itself;
    }
    return result;
}

Gradient Differentiator::of(NodeId root) {
    for (const NodeId id : unknown_below(root)) {
        if (known_.size() <= id) known_.resize(id + 1);
        known_[id] = made(id);
    }
    const Slopes<GraphNumber>& slopes = known_[root]->slope;
    return {slopes[0], slopes[1], slopes[2]};
}

std::optional<GraphNumber> sum(const std::optional<GraphNumber>& a,
                               const std::optional<GraphNumber>& b) {
    if (!a) return b;
    return b ? *a + *b : *a;
}

std::optional<GraphNumber> difference(const std::optional<GraphNumber>& a,
                                      const std::optional<GraphNumber>& b) {
    if (!b) return a;
    return a ? *a - *b : -*b;
}

std::optional<GraphNumber> product(const std::optional<GraphNumber>& a,
                                   const std::optional<GraphNumber>& b) {
    if (!a || !b) return std::nullopt;
    return *a * *b;
}

/// f with its first and second derivatives.
class Shape {
public:
    explicit Shape(const Expr& f) : f_(f), differentiator_(builder_) {
        gradient_ = differentiator_.of(copy_nodes(builder_, f).back());
    }

    [[nodiscard]] const Gradient& gradient() const { return gradient_; }
    [[nodiscard]] std::optional<GraphNumber> square() const {
        std::optional<GraphNumber> all;
        for (const auto& slope : gradient_)
            all = sum(all, product(slope, slope));
        return all;
    }
    void differentiate_again() {
        for (std::size_t i = 0; i < 3; ++i) {
            if (gradient_[i]) hessian_[i] = differentiator_.of(gradient_[i]->id);
        }
    }
    [[nodiscard]] std::optional<GraphNumber> trace() const {
        return sum(hessian_[0][0], sum(hessian_[1][1], hessian_[2][2]));
    }
    /// g . M g for the gradient g and a symmetric matrix with these members.
    std::optional<GraphNumber> along_gradient(auto member) const {
        std::optional<GraphNumber> all;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k)
                all = sum(all, product(product(gradient_[i], member(i, k)), gradient_[k]));
        }
        return all;
    }
    [[nodiscard]] std::optional<GraphNumber> second(std::size_t i, std::size_t k) const {
        return hessian_[std::min(i, k)][std::max(i, k)];
    }
    /// dot(f's gradient, vector)
    std::optional<GraphNumber> along(const std::array<GraphNumber, 3>& vector) const {
        std::optional<GraphNumber> all;
        for (std::size_t i = 0; i < 3; ++i)
            all = sum(all, product(gradient_[i], vector[i]));
        return all;
    }
    /// A cofactor of the matrix of second derivatives, which is symmetric.
    [[nodiscard]] std::optional<GraphNumber> cofactor(std::size_t i, std::size_t k) const {
        const std::size_t i1 = (i + 1) % 3;
        const std::size_t i2 = (i + 2) % 3;
        const std::size_t k1 = (k + 1) % 3;
        const std::size_t k2 = (k + 2) % 3;
        return difference(product(second(i1, k1), second(i2, k2)),
                          product(second(i1, k2), second(i2, k1)));
    }

    [[nodiscard]] GraphNumber number(double value) {
        return {.builder = &builder_, .id = builder_.constant(value)};
    }
    [[nodiscard]] GraphNumber coordinate(std::size_t axis) {
        return {.builder = &builder_, .id = builder_.variable(static_cast<int>(axis))};
    }
    [[nodiscard]] Expr finish(const std::optional<GraphNumber>& root) {
        const NodeId id = root ? root->id : builder_.constant(0.0);
        return builder_.finish(id, f_.parameter_names());
    }

private:
    const Expr& f_;
    ExprBuilder builder_;
    Differentiator differentiator_;
    Gradient gradient_;
    std::array<Gradient, 3> hessian_;  ///< row i: the gradient of the i-th derivative
};

}  // namespace

std::array<Expr, 3> gradient_of(const Expr& f) {
    Shape shape(f);
    const Gradient slopes = shape.gradient();
    return {shape.finish(slopes[0]), shape.finish(slopes[1]), shape.finish(slopes[2])};
}

std::vector<std::array<NodeId, 3>> gradients_in(ExprBuilder& builder,
                                                std::span<const NodeId> roots) {
    Differentiator differentiator(builder);
    std::vector<std::array<NodeId, 3>> gradients;
    gradients.reserve(roots.size());
    for (const NodeId root : roots) {
        std::array<NodeId, 3>& gradient = gradients.emplace_back();
        const Gradient slopes = differentiator.of(root);
        for (std::size_t i = 0; i < 3; ++i)
            gradient[i] = slopes[i] ? slopes[i]->id : builder.constant(0.0);
    }
    return gradients;
}

Expr slope_from(const Expr& f, const std::array<double, 3>& point) {
    Shape shape(f);
    const auto from = [&](std::size_t i) { return shape.coordinate(i) - shape.number(point[i]); };
    return shape.finish(shape.along({from(0), from(1), from(2)}));
}

Expr slope_along(const Expr& f, const std::array<double, 3>& direction) {
    Shape shape(f);
    const auto member = [&](std::size_t i) { return shape.number(direction[i]); };
    return shape.finish(shape.along({member(0), member(1), member(2)}));
}

Expr gradient_size(const Expr& f) {
    Shape shape(f);
    const auto square = shape.square();
    if (!square) return shape.finish(std::nullopt);
    return shape.finish(square_root(*square));
}

Expr mean_curvature(const Expr& f) {
    Shape shape(f);
    shape.differentiate_again();
    const auto square = shape.square();
    if (!square) return shape.finish(std::nullopt);
    const auto bent = shape.along_gradient([&](auto i, auto k) { return shape.second(i, k); });
    const auto above = difference(product(square, shape.trace()), bent);
    if (!above) return shape.finish(std::nullopt);
    return shape.finish(*above / (shape.number(2.0) * (*square * square_root(*square))));
}

Expr gaussian_curvature(const Expr& f) {
    Shape shape(f);
    shape.differentiate_again();
    const auto square = shape.square();
    const auto above = shape.along_gradient([&](auto i, auto k) { return shape.cofactor(i, k); });
    if (!square || !above) return shape.finish(std::nullopt);
    return shape.finish(*above / point_power(*square, 2));
}

}  // namespace zeroset
