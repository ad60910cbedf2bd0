#include "engine/rewrite/differences/removable_poles.hpp"

#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/differences/differences.hpp"
#include "engine/rewrite/differences/known_value.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace zeroset {
namespace {

/// Graphs do not grow beyond this, and larger ones are left alone.
constexpr std::size_t most_of_graph = 5'000;
constexpr int most_quotients = 200;
constexpr int largest_exponent = 8;
constexpr std::size_t most_factors = 8;

/// Divides numerators by what they vanish with.
class PoleRemover {
public:
    explicit PoleRemover(ExprBuilder& builder) : builder_(builder), facts_(builder) {}

    /// top/bottom without its removable poles; nothing where it has none that is seen.
    std::optional<NodeId> quotient(NodeId top, NodeId bottom) {
        if (builder_.size() > most_of_graph || --quotients_left_ < 0) return std::nullopt;
        if (known_value(builder_, bottom)) return std::nullopt;
        std::vector<NodeId> factors;
        collect_factors(bottom, 1, factors);
        if (factors.size() > 1 && factors.size() <= most_factors) {
            if (const auto whole = divided(top, bottom)) return whole;
        }
        NodeId rest = builder_.constant(1.0);
        bool is_any = false;
        for (const NodeId factor : factors) {
            const auto less = factors.size() <= most_factors ? divided(top, factor) : std::nullopt;
            is_any = is_any || less;
            if (less) {
                top = *less;
            } else {
                rest = make_multiply(builder_, rest, factor);
            }
        }
        if (is_any) return make_divide(builder_, top, rest);
        const auto inverse = divided(bottom, top);
        return inverse ? std::optional(make_divide(builder_, builder_.constant(1.0), *inverse))
                       : std::nullopt;
    }

private:
    void collect_factors(NodeId id, int exponent, std::vector<NodeId>& factors) const {
        const Node node = builder_.node(id);
        if (factors.size() > most_factors) return;
        if (node.op == Op::Multiply) {
            collect_factors(node.a, exponent, factors);
            return collect_factors(node.b, exponent, factors);
        }
        if (node.op == Op::IntPower && node.number * exponent <= largest_exponent)
            return collect_factors(node.a, node.number * exponent, factors);
        factors.insert(factors.end(), static_cast<std::size_t>(exponent), id);
    }

    /// The continuous quotient of a function and a divisor a, a - b or a + b which it vanishes
    /// with: with 0 for a, b for a or -b for a it is 0.
    std::optional<NodeId> divided(NodeId top, NodeId by) {
        const Node node = builder_.node(by);
        if (node.op == Op::Constant) return std::nullopt;
        if (const auto whole = divided(top, by, {.from = by, .by = builder_.constant(0.0)}))
            return whole;
        if (node.op == Op::Subtract) {
            if (const auto first = divided(top, by, {.from = node.a, .by = node.b})) return first;
            const NodeId turned = make_subtract(builder_, node.b, node.a);
            const auto second = divided(top, turned, {.from = node.b, .by = node.a});
            return second ? std::optional(make_negate(builder_, *second)) : std::nullopt;
        }
        if (node.op != Op::Add) return std::nullopt;
        if (const auto first =
                divided(top, by, {.from = node.a, .by = make_negate(builder_, node.b)}))
            return first;
        return divided(top, by, {.from = node.b, .by = make_negate(builder_, node.a)});
    }
    std::optional<NodeId> divided(NodeId top, NodeId delta, const Replacement& replaced) {
        if (has_factor(top, replaced.from)) return std::nullopt;  // a hole that the text has
        if (known_value(builder_, replaced.from)) return std::nullopt;
        const NodeId there = with_replaced(top, replaced);
        if (there == top || !is_known_zero(builder_, there)) return std::nullopt;
        return divided_difference(builder_, facts_, top, there, replaced, delta);
    }
    [[nodiscard]] bool has_factor(NodeId product, NodeId factor) const {
        std::vector<NodeId> open{product};
        std::unordered_set<NodeId> seen;
        while (!open.empty()) {
            const NodeId id = open.back();
            open.pop_back();
            if (id == factor) return true;
            const Node& node = builder_.node(id);
            const bool is_product = is_any_of(node.op, {Op::Multiply, Op::IntPower, Op::Negate});
            if (!is_product || !seen.insert(id).second) continue;
            open.push_back(node.a);
            if (node.op == Op::Multiply) open.push_back(node.b);
        }
        return false;
    }
    /// The function with the replaced node, otherwise operator by operator as it was.
    NodeId with_replaced(NodeId root, const Replacement& replaced) {
        std::unordered_map<NodeId, NodeId> copies{{replaced.from, replaced.by}};
        std::vector<NodeId> open{root};
        while (!open.empty()) {
            const NodeId id = open.back();
            const Node node = builder_.node(id);
            const std::array operands{node.a, node.b, node.c};
            const auto count = static_cast<std::size_t>(arity(node.op));
            const std::size_t before = open.size();
            for (std::size_t k = 0; k < count && !copies.contains(id); ++k) {
                if (!copies.contains(operands.at(k))) open.push_back(operands.at(k));
            }
            if (open.size() > before) continue;
            open.pop_back();
            if (copies.contains(id)) continue;
            const bool same = std::ranges::all_of(std::span(operands).first(count),
                                                  [&](NodeId k) { return copies.at(k) == k; });
            const NodeId copy = same ? id : copy_node(builder_, node, [&](NodeId operand) {
                return copies.at(operand);
            });
            copies.emplace(id, copy);
        }
        return copies.at(root);
    }

    ExprBuilder& builder_;
    NodeFacts facts_;
    int quotients_left_ = most_quotients;
};

}  // namespace

std::optional<Expr> without_removable_poles(const Expr& expr) {
    const auto divides = [](const Node& node) { return node.op == Op::Divide; };
    if (expr.nodes().size() > most_of_graph || std::ranges::none_of(expr.nodes(), divides))
        return std::nullopt;
    ExprBuilder builder;
    PoleRemover remover(builder);
    bool is_any = false;
    Expr result = rebuilt(
        builder, expr, [&](ExprBuilder& to, const Node& node, NodeId a, NodeId b, NodeId c) {
            const auto continuous = divides(node) ? remover.quotient(a, b) : std::nullopt;
            is_any = is_any || continuous;
            return continuous ? *continuous : copy_node(to, node, a, b, c);
        });
    return is_any ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace zeroset
