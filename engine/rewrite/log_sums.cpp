#include "engine/expr/copy.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/passes.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t max_summands = 1000;

/// ln of a product of exponentials and constants above 0; nothing for other factors.
std::optional<NodeId> exponent(ExprBuilder& builder, NodeId id) {
    const Node node = builder.node(id);
    if (node.op == Op::Exp) return node.a;
    if (const auto value = exact_fraction(builder, id)) {
        if (value->p <= 0) return std::nullopt;
        return value->p == value->q ? builder.constant(0.0) : make_call(builder, Op::Log, id);
    }
    if (node.op != Op::Multiply && node.op != Op::Divide) return std::nullopt;
    const auto a = exponent(builder, node.a);
    const auto b = a ? exponent(builder, node.b) : std::nullopt;
    if (!b) return std::nullopt;
    return node.op == Op::Multiply ? make_add(builder, *a, *b) : make_subtract(builder, *a, *b);
}

/// The exponents of what a sum adds up; nothing where one is no exponential.
std::vector<NodeId> exponents(ExprBuilder& builder, NodeId sum) {
    std::vector<NodeId> open{sum};
    std::vector<NodeId> result;
    while (!open.empty()) {
        const Node node = builder.node(open.back());
        if (node.op == Op::Add && open.size() + result.size() < max_summands) {
            open.back() = node.b;
            open.push_back(node.a);
            continue;
        }
        const auto power = exponent(builder, open.back());
        if (!power) return {};
        result.push_back(*power);
        open.pop_back();
    }
    return result;
}

/// By halves, so that the graph is not deep.
NodeId log_sum_of(ExprBuilder& builder, std::vector<NodeId> powers) {
    while (powers.size() > 1) {
        std::vector<NodeId> sums;
        for (std::size_t i = 0; i + 1 < powers.size(); i += 2)
            sums.push_back(builder.apply(Op::LogSum, powers[i], powers[i + 1]));
        if (powers.size() % 2 != 0) sums.push_back(powers.back());
        powers = std::move(sums);
    }
    return powers.front();
}

bool is_logarithm(Op op) { return op == Op::Log || op == Op::Log2 || op == Op::Log10; }

NodeId with_log_sum(ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
    if (is_logarithm(node.op) && builder.node(a).op == Op::Add) {
        const std::vector<NodeId> powers = exponents(builder, a);
        if (!powers.empty()) {
            const NodeId sum = log_sum_of(builder, powers);
            if (node.op == Op::Log) return sum;
            const NodeId base = builder.constant(node.op == Op::Log2 ? 2.0 : 10.0);
            return make_divide(builder, sum, make_call(builder, Op::Log, base));
        }
    }
    return copy_node(builder, node, a, b, c);
}

}  // namespace

Expr with_log_sums(const Expr& expr) {
    const bool has_logarithm =
        std::ranges::any_of(expr.nodes(), [](const Node& node) { return is_logarithm(node.op); });
    return has_logarithm ? rebuilt(expr, with_log_sum) : expr;
}

}  // namespace zeroset
