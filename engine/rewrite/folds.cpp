#include "engine/expr/copy.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/differences/differences.hpp"
#include "engine/rewrite/passes.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

/// remainder of `value` by a constant d > 0.
struct Remainder {
    NodeId value;
    NodeId d;
};

std::optional<Remainder> remainder(const ExprBuilder& builder, NodeId id) {
    const Node& node = builder.node(id);
    if (node.op != Op::Mod) return std::nullopt;
    const auto d = exact_fraction(builder, node.b);
    if (!d || d->p <= 0) return std::nullopt;
    return Remainder{.value = node.a, .d = node.b};
}

/// Whether 2 a is b.
bool is_half(ExprBuilder& builder, NodeId a, NodeId b) {
    const NodeId two = builder.constant(2.0);
    const auto twice = exact_fraction(builder, builder.apply(Op::Multiply, two, a));
    const auto whole = exact_fraction(builder, b);
    return twice && whole && twice->p == whole->p && twice->q == whole->q;
}

/// The remainder from whose middle the node is the distance, with either sign.
std::optional<Remainder> centred_remainder(ExprBuilder& builder, NodeId id) {
    const Node node = builder.node(id);
    if (node.op == Op::Negate) return centred_remainder(builder, node.a);
    if (node.op != Op::Subtract && node.op != Op::Add) return std::nullopt;
    NodeId middle = node.b;
    auto found = remainder(builder, node.a);
    if (!found) {
        found = remainder(builder, node.b);
        middle = node.a;
    }
    if (!found) return std::nullopt;
    if (node.op == Op::Add) middle = make_negate(builder, middle);
    return is_half(builder, middle, found->d) ? found : std::nullopt;
}

/// x of x + c for a constant c, and c.
std::pair<NodeId, NodeId> without_summand(ExprBuilder& builder, NodeId id) {
    const Node node = builder.node(id);
    if (node.op == Op::Add && exact_fraction(builder, node.b)) return {node.a, node.b};
    if (node.op == Op::Subtract && exact_fraction(builder, node.b))
        return {node.a, make_negate(builder, node.b)};
    return {id, builder.constant(0.0)};
}

/// The number that differs by a multiple of 2 and is from 0 on below 2, of a constant.
NodeId below_two(ExprBuilder& builder, NodeId constant) {
    const auto value = exact_fraction(builder, constant);
    if (!value || value->q > std::numeric_limits<int>::max()) return constant;
    const long long turn = 2 * value->q;
    return constant_of(builder, {.p = (value->p % turn + turn) % turn, .q = value->q});
}

/// |mod(x + c, d) - d/2| = d/2 fold(2 x/d + 2 c/d + 1)
NodeId folded(ExprBuilder& builder, const Remainder& of) {
    const NodeId one = builder.constant(1.0);
    const NodeId half = ratio(builder, of.d, builder.constant(2.0));
    const NodeId per_half = ratio(builder, one, half);
    const auto [x, c] = without_summand(builder, of.value);
    const NodeId shift =
        below_two(builder, make_add(builder, make_multiply(builder, per_half, c), one));
    const NodeId turns = make_add(builder, make_multiply(builder, per_half, x), shift);
    return make_multiply(builder, half, builder.apply(Op::Fold, turns));
}

NodeId with_fold(ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
    if (node.op == Op::Abs) {
        if (const auto of = centred_remainder(builder, a)) return folded(builder, *of);
    }
    if (node.op == Op::IntPower && node.number % 2 == 0) {
        if (const auto of = centred_remainder(builder, a))
            return make_int_power(builder, folded(builder, *of), node.number);
    }
    return copy_node(builder, node, a, b, c);
}

}  // namespace

Expr with_folds(const Expr& expr) {
    const bool has_remainders =
        std::ranges::any_of(expr.nodes(), [](const Node& node) { return node.op == Op::Mod; });
    return has_remainders ? rebuilt(expr, with_fold) : expr;
}

}  // namespace zeroset
