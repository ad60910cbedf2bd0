#include "engine/algebra/node_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/exact.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <algorithm>
#include <optional>

namespace zeroset {
namespace {

constexpr std::size_t most_witnesses = 4;

/// The nodes of a graph with their ids.
ExprBuilder nodes_of(const Expr& f) {
    ExprBuilder nodes;
    copy_nodes(nodes, f);
    return nodes;
}

bool is_same(const ExprBuilder& builder, NodeId a, NodeId b) {
    if (a == b) return true;
    const auto x = exact_fraction(builder, a);
    const auto y = x ? exact_fraction(builder, b) : std::nullopt;
    return y && x->p == y->p && x->q == y->q;
}

bool is_difference(const ExprBuilder& f, NodeId id, NodeId u, NodeId v) {
    const Node& node = f.node(id);
    if (node.op == Op::Negate) return is_difference(f, node.a, u, v);
    return node.op == Op::Subtract && ((is_same(f, node.a, u) && is_same(f, node.b, v)) ||
                                       (is_same(f, node.a, v) && is_same(f, node.b, u)));
}

/// The operand that a choice is where the sides of its comparison are equal, if it is their
/// difference.
std::optional<NodeId> at_equality(const ExprBuilder& f, const Node& choice) {
    const Node& condition = f.node(choice.a);
    if (condition.op != Op::Less && condition.op != Op::LessEqual) return std::nullopt;
    const NodeId taken = condition.op == Op::Less ? choice.c : choice.b;
    const bool vanishes = is_difference(f, taken, condition.a, condition.b);
    return vanishes ? std::optional(taken) : std::nullopt;
}

/// A dividend and its divisor.
struct Division {
    NodeId dividend, divisor;
};

/// The division whose remainder the node is: mod(a, b), or a beside its floor or ceiling.
std::optional<Division> remainder_of(ExprBuilder& f, NodeId id) {
    const Node node = f.node(id);
    if (node.op == Op::Mod) return Division{.dividend = node.a, .divisor = node.b};
    if (node.op != Op::Subtract) return std::nullopt;
    const auto is_step_of = [&](NodeId step, NodeId of) {
        return is_any_of(f.node(step).op, {Op::Floor, Op::Ceil}) && f.node(step).a == of;
    };
    const auto of_one = [&](NodeId dividend) {
        return Division{.dividend = dividend, .divisor = f.constant(1.0)};
    };
    if (is_step_of(node.b, node.a)) return of_one(node.a);
    if (is_step_of(node.a, node.b)) return of_one(node.b);
    return std::nullopt;
}

/// The remainder from -b/2 to b/2: it crosses 0 where the one from 0 to b jumps to it.
NodeId centred_remainder(ExprBuilder& f, const Division& of) {
    const NodeId half = f.apply(Op::Divide, of.divisor, f.constant(2.0));
    return f.apply(Op::Subtract, f.apply(Op::Mod, f.apply(Op::Add, of.dividend, half), of.divisor),
                   half);
}

}  // namespace

std::vector<Expr> root_witnesses(const Expr& f) {
    ExprBuilder nodes = nodes_of(f);
    std::vector<NodeId> open{f.root()};
    std::vector<NodeId> found;
    while (!open.empty() && found.size() < most_witnesses) {
        const NodeId id = open.back();
        const Node& node = f.node(id);
        open.pop_back();
        if (node.op == Op::Multiply) {
            open.insert(open.end(), {node.b, node.a});
        } else if (is_any_of(node.op, {Op::Negate, Op::Abs, Op::OddRoot, Op::Divide}) ||
                   (node.op == Op::IntPower && node.number > 0)) {
            open.push_back(node.a);
        } else if (node.op == Op::If && at_equality(nodes, node)) {
            open.push_back(*at_equality(nodes, node));
        } else if (const auto division = remainder_of(nodes, id)) {
            found.push_back(centred_remainder(nodes, *division));
        } else if (node.op != Op::Constant && id != f.root() &&
                   std::ranges::find(found, id) == found.end()) {
            found.push_back(id);
        }
    }
    std::vector<Expr> witnesses;
    const auto names = f.parameters();
    witnesses.reserve(found.size());
    for (const NodeId id : found)
        witnesses.push_back(nodes.finish(id, {names.begin(), names.end()}));
    return witnesses;
}

std::optional<Expr> domain_witness(const Expr& f) {
    ExprBuilder builder = nodes_of(f);
    NodeFacts facts(builder);
    std::optional<NodeId> sum;
    const auto add = [&](NodeId term) { sum = sum ? builder.apply(Op::Add, *sum, term) : term; };
    const auto square = [&](NodeId id) { return builder.apply(Op::IntPower, id, 0, 0, 2); };
    const auto reciprocal = [&](NodeId id) {
        return builder.apply(Op::Divide, builder.constant(1.0), id);
    };
    for (NodeId id = 0; id <= f.root(); ++id) {
        if (!facts.is_partial(id)) continue;
        const Node& node = f.node(id);
        if (node.op == Op::Where) return std::nullopt;
        if (is_any_of(node.op, {Op::Atan2, Op::Angle, Op::AngleSin, Op::AngleCos})) {
            add(reciprocal(builder.apply(Op::Add, square(node.a), square(node.b))));
        } else if (is_any_of(node.op, {Op::Divide, Op::Mod, Op::Oriented})) {
            add(reciprocal(node.b));
        } else {
            add(id);
        }
    }
    if (!sum) return std::nullopt;
    const auto names = f.parameters();
    return builder.finish(*sum, {names.begin(), names.end()});
}

bool is_defined_everywhere(const Expr& f) {
    const ExprBuilder nodes = nodes_of(f);
    return NodeFacts(nodes).is_total(f.root());
}

}  // namespace zeroset
