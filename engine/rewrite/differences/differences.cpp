#include "engine/rewrite/differences/differences.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <vector>

namespace zeroset {
namespace {

/// Larger graphs do not grow any more.
constexpr std::size_t most_nodes = 50'000;

/// Whether the formula adds a small constant anywhere, or divides by one.
bool has_small_step(const Expr& expr) {
    constexpr double small = 0.01;
    const UpwardRounding upward;
    const std::vector<Facts> facts = facts_of(expr);
    const auto is_small = [&](NodeId id) {
        const auto& constant = facts[id].constant;
        return constant && constant->hi <= small && constant->neg_lo <= small;
    };
    return std::ranges::any_of(expr.nodes(), [&](const Node& node) {
        const bool sum = node.op == Op::Add || node.op == Op::Subtract;
        if (node.op == Op::Divide) return is_small(node.b);
        return sum && (is_small(node.a) || is_small(node.b));
    });
}

}  // namespace

Expr without_small_differences(const Expr& expr) {
    if (!has_small_step(expr)) return expr;
    std::optional<NodeFacts> facts;
    std::unordered_map<NodeId, Difference> differences;
    return rebuilt(expr, [&](ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
        if (!facts) facts.emplace(builder);
        if (node.op == Op::Divide && differences.contains(a) && exact_fraction(builder, b)) {
            const Difference& top = differences.at(a);
            return make_multiply(builder, ratio(builder, top.delta, b), top.divided);
        }
        if (node.op == Op::Subtract && builder.size() < most_nodes) {
            if (const auto difference = divided_difference(builder, *facts, a, b)) {
                const NodeId result =
                    make_multiply(builder, difference->delta, difference->divided);
                differences.emplace(result, *difference);
                return result;
            }
        }
        return copy_node(builder, node, a, b, c);
    });
}

}  // namespace zeroset
