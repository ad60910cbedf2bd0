#include "engine/expr/copy.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/differences/differences.hpp"
#include "engine/rewrite/passes.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr int most_factors = 16;

/// A node or its negative.
struct SignedNode {
    bool negative;
    NodeId core;
    bool operator==(const SignedNode&) const = default;
};

SignedNode operator-(SignedNode term) { return {.negative = !term.negative, .core = term.core}; }

/// A constant times other factors.
struct Product {
    NodeId constant;
    std::vector<NodeId> factors;
};

/// The sum of two terms.
struct Pair {
    SignedNode first, second;
};

/// min(max(1/2 + slope (a + b), 0), 1) for the terms a and b.
struct Ramp {
    NodeId slope;
    Pair sum;
};

class Finder {
public:
    explicit Finder(ExprBuilder& builder) : builder_(builder) {}

    /// The smooth minimum or maximum that a sum or difference is.
    std::optional<NodeId> find(Op op, NodeId a, NodeId b);

private:
    /// min(a, b) - h^2/(4k) or max(a, b) + h^2/(4k) with h = max(k - |a - b|, 0).
    std::optional<NodeId> extreme_and_hat(Op wanted, NodeId extreme, NodeId rest);
    /// (b + h (a - b)) - k h (1 - h) with h from 0 to 1, 1/2 + (b - a)/(2k) between: a minimum. A
    /// maximum with + and 1/2 - (b - a)/(2k).
    std::optional<NodeId> mix_and_bump(Op op, NodeId mix, NodeId bump);
    std::optional<NodeId> mixed_extreme(Op op, NodeId mix, NodeId h, NodeId k);

    std::optional<Product> product(NodeId id);
    bool multiply_into(Product& product, NodeId id);
    std::optional<Pair> pair(NodeId id);
    /// Whether the sum is a - b.
    bool is_difference(const Pair& sum, NodeId a, NodeId b);
    /// k, if it is max(k - |a - b|, 0).
    std::optional<NodeId> hat_width(NodeId id, NodeId a, NodeId b);
    std::optional<Ramp> ramp(NodeId id);
    /// b + h (a - b) in one of its forms, for a given h: whether it is.
    bool is_mix(NodeId id, NodeId a, NodeId b, NodeId h);
    bool is_product_of(NodeId id, NodeId a, NodeId b);

    SignedNode term(NodeId id);
    NodeId made(const SignedNode& term);
    /// x / k
    NodeId scaled(NodeId x, NodeId k);
    /// k times the smooth minimum of a / k and b / k, or the maximum.
    NodeId smooth(Op extreme, NodeId a, NodeId b, NodeId k);
    bool is(NodeId constant, double value);
    bool is_positive(NodeId constant);
    NodeId times(NodeId a, NodeId b) { return builder_.apply(Op::Multiply, a, b); }
    NodeId number(double value) { return builder_.constant(value); }
    /// The operand beside the constant `value`, if the node is such an operator.
    std::optional<NodeId> beside(NodeId id, Op op, double value);

    ExprBuilder& builder_;
    int left_ = 0;  ///< the number of factors that may still be looked at
};

bool Finder::is(NodeId constant, double value) {
    const auto found =
        exact_fraction(builder_, builder_.apply(Op::Subtract, constant, number(value)));
    return found && found->p == 0;
}

bool Finder::is_positive(NodeId constant) {
    const auto value = exact_fraction(builder_, constant);
    return value && value->p > 0;
}

std::optional<NodeId> Finder::beside(NodeId id, Op op, double value) {
    const Node node = builder_.node(id);
    if (node.op != op) return std::nullopt;
    if (is(node.a, value)) return node.b;
    return is(node.b, value) ? std::optional(node.a) : std::nullopt;
}

bool Finder::multiply_into(Product& product, NodeId id) {
    if (--left_ < 0) return false;
    const Node node = builder_.node(id);
    if (exact_fraction(builder_, id)) {
        product.constant = times(product.constant, id);
    } else if (node.op == Op::Negate) {
        product.constant = times(product.constant, number(-1));
        return multiply_into(product, node.a);
    } else if (node.op == Op::Multiply) {
        return multiply_into(product, node.a) && multiply_into(product, node.b);
    } else if (node.op == Op::Divide && exact_fraction(builder_, node.b)) {
        product.constant = builder_.apply(Op::Divide, product.constant, node.b);
        return multiply_into(product, node.a);
    } else if (node.op == Op::IntPower && node.number == 2) {
        return multiply_into(product, node.a) && multiply_into(product, node.a);
    } else {
        product.factors.push_back(id);
    }
    return true;
}

std::optional<Product> Finder::product(NodeId id) {
    left_ = most_factors;
    Product result{.constant = number(1), .factors = {}};
    return multiply_into(result, id) ? std::optional(result) : std::nullopt;
}

SignedNode Finder::term(NodeId id) {
    SignedNode result{.negative = false, .core = id};
    while (builder_.node(result.core).op == Op::Negate)
        result = {.negative = !result.negative, .core = builder_.node(result.core).a};
    return result;
}

NodeId Finder::made(const SignedNode& term) {
    return term.negative ? make_negate(builder_, term.core) : term.core;
}

std::optional<Pair> Finder::pair(NodeId id) {
    const SignedNode whole = term(id);
    const Node node = builder_.node(whole.core);
    if (node.op != Op::Add && node.op != Op::Subtract) return std::nullopt;
    Pair sum{.first = term(node.a), .second = term(node.b)};
    if (node.op == Op::Subtract) sum.second = -sum.second;
    return whole.negative ? Pair{.first = -sum.first, .second = -sum.second} : sum;
}

bool Finder::is_difference(const Pair& sum, NodeId a, NodeId b) {
    const SignedNode first = term(a);
    const SignedNode second = -term(b);
    return (sum.first == first && sum.second == second) ||
           (sum.first == second && sum.second == first);
}

std::optional<NodeId> Finder::hat_width(NodeId id, NodeId a, NodeId b) {
    const auto height = beside(id, Op::Max, 0);
    if (!height) return std::nullopt;
    const Node slope = builder_.node(*height);
    if (slope.op != Op::Subtract || !is_positive(slope.a)) return std::nullopt;
    const Node size = builder_.node(slope.b);
    const auto difference = size.op == Op::Abs ? pair(size.a) : std::nullopt;
    if (!difference) return std::nullopt;
    const bool fits = is_difference(*difference, a, b) || is_difference(*difference, b, a);
    return fits ? std::optional(slope.a) : std::nullopt;
}

std::optional<Ramp> Finder::ramp(NodeId id) {
    const auto above = beside(id, Op::Min, 1);
    const auto inner = above ? beside(*above, Op::Max, 0) : std::nullopt;
    if (!inner) return std::nullopt;
    const Node node = builder_.node(*inner);
    if (node.op != Op::Add && node.op != Op::Subtract) return std::nullopt;
    const bool begins = is(node.a, 0.5);
    if (!begins && !(node.op == Op::Add && is(node.b, 0.5))) return std::nullopt;
    const auto rest = product(begins ? node.b : node.a);
    if (!rest || rest->factors.size() != 1) return std::nullopt;
    const auto sum = pair(rest->factors[0]);
    if (!sum) return std::nullopt;
    const double sign = node.op == Op::Add ? 1 : -1;
    return Ramp{.slope = times(rest->constant, number(sign)), .sum = *sum};
}

NodeId Finder::scaled(NodeId x, NodeId k) {
    const Node node = builder_.node(x);
    if (node.op == Op::Multiply && builder_.node(node.b).op == Op::SmoothMin &&
        is(builder_.apply(Op::Divide, node.a, k), 1))
        return node.b;
    return make_multiply(builder_, ratio(builder_, number(1), k), x);
}

NodeId Finder::smooth(Op extreme, NodeId a, NodeId b, NodeId k) {
    const bool max = extreme == Op::Max;
    const auto turned = [&](NodeId x) { return max ? make_negate(builder_, x) : x; };
    const NodeId unit = builder_.apply(Op::SmoothMin, scaled(turned(a), k), scaled(turned(b), k));
    return turned(is(k, 1) ? unit : times(ratio(builder_, k, number(1)), unit));
}

std::optional<NodeId> Finder::extreme_and_hat(Op wanted, NodeId extreme, NodeId rest) {
    const Node node = builder_.node(extreme);
    if (node.op != wanted) return std::nullopt;
    const auto q = product(rest);
    if (!q || q->factors.size() != 2 || q->factors[0] != q->factors[1]) return std::nullopt;
    const auto k = hat_width(q->factors[0], node.a, node.b);
    if (!k || !is(times(times(number(4), *k), q->constant), 1)) return std::nullopt;
    return smooth(wanted, node.a, node.b, *k);
}

bool Finder::is_product_of(NodeId id, NodeId a, NodeId b) {
    const Node node = builder_.node(id);
    return node.op == Op::Multiply &&
           ((node.a == a && node.b == b) || (node.a == b && node.b == a));
}

bool Finder::is_mix(NodeId id, NodeId a, NodeId b, NodeId h) {
    const Node sum = builder_.node(id);
    if (sum.op != Op::Add) return false;
    for (const auto& [one, other] : {std::pair(sum.a, sum.b), std::pair(sum.b, sum.a)}) {
        const NodeId rest = builder_.apply(Op::Subtract, number(1), h);
        if (is_product_of(one, b, rest) && is_product_of(other, a, h)) return true;
        const Node share = builder_.node(other);
        if (one != b || share.op != Op::Multiply) continue;
        if (share.a != h && share.b != h) continue;
        const auto difference = pair(share.a == h ? share.b : share.a);
        if (difference && is_difference(*difference, a, b)) return true;
    }
    return false;
}

std::optional<NodeId> Finder::mixed_extreme(Op op, NodeId mix, NodeId h, NodeId k) {
    const auto slope = ramp(h);
    if (!slope) return std::nullopt;
    // For a minimum it slopes by (b - a)/(2k), for a maximum by (a - b)/(2k).
    const bool max = op == Op::Add;
    const NodeId unit = times(times(number(max ? -2 : 2), k), slope->slope);
    const bool turned = is(unit, -1);
    if (!turned && !is(unit, 1)) return std::nullopt;
    for (const auto& [p, q] : {std::pair(slope->sum.first, slope->sum.second),
                               std::pair(slope->sum.second, slope->sum.first)}) {
        const NodeId b = made(turned ? -p : p);
        const NodeId a = made(turned ? q : -q);
        if (is_mix(mix, a, b, h)) return smooth(max ? Op::Max : Op::Min, a, b, k);
    }
    return std::nullopt;
}

std::optional<NodeId> Finder::mix_and_bump(Op op, NodeId mix, NodeId bump) {
    if (builder_.node(mix).op != Op::Add) return std::nullopt;
    const auto q = product(bump);
    if (!q || q->factors.size() != 2 || !is_positive(q->constant)) return std::nullopt;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const NodeId h = q->factors[i];
        if (q->factors[1 - i] != builder_.apply(Op::Subtract, number(1), h)) continue;
        if (const auto found = mixed_extreme(op, mix, h, q->constant)) return found;
    }
    return std::nullopt;
}

std::optional<NodeId> Finder::find(Op op, NodeId a, NodeId b) {
    const Op wanted = op == Op::Add ? Op::Max : Op::Min;
    if (const auto found = extreme_and_hat(wanted, a, b)) return found;
    if (const auto found = mix_and_bump(op, a, b)) return found;
    const auto turned = extreme_and_hat(wanted, b, a);
    return turned && op == Op::Subtract ? std::optional(make_negate(builder_, *turned)) : turned;
}

}  // namespace

Expr with_smooth_minima(const Expr& expr) {
    const auto may_blend = [](const Node& node) { return node.op == Op::Max; };
    if (!std::ranges::any_of(expr.nodes(), may_blend)) return expr;
    return rebuilt(expr, [](ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
        if (node.op == Op::Add || node.op == Op::Subtract) {
            if (const auto found = Finder(builder).find(node.op, a, b)) return *found;
        }
        // Nested smooth maxima are negated twice.
        if (node.op == Op::Negate) return make_negate(builder, a);
        return copy_node(builder, node, a, b, c);
    });
}

}  // namespace zeroset
