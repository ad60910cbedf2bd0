#include "engine/algebra/node_facts.hpp"
#include "engine/algebra/switches.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/differences/differences.hpp"
#include "engine/rewrite/passes.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

/// More of them are left as they are: a sum of a thousand choices would be as many conditions for
/// each of its users.
constexpr int most_steps = 400;

/// value < limit, value <= limit or, with `above`, value > limit, value >= limit.
struct Comparison {
    NodeId value;
    Fraction limit;
    bool above;
    bool strict;
};

class PlainConditions {
public:
    PlainConditions() : facts_(builder_) {}

    ExprBuilder& builder() { return builder_; }
    NodeId make(const Node& node, NodeId a, NodeId b, NodeId c);

private:
    [[nodiscard]] NodeId truth(bool holds) { return builder_.constant(holds ? 1.0 : 0.0); }
    [[nodiscard]] std::optional<Fraction> exact(NodeId id) const {
        return exact_fraction(builder_, id);
    }
    [[nodiscard]] std::optional<bool> known(NodeId condition) const;
    bool is_total(NodeId id) { return facts_.is_total(id); }
    /// Whether its values are whole numbers, or undefined.
    bool is_whole(NodeId id);
    /// The condition, if `id` is 1 where it holds and 0 elsewhere.
    [[nodiscard]] std::optional<NodeId> indicated(NodeId id) const;

    NodeId compared(const Node& node, NodeId a, NodeId b);
    NodeId plain(Comparison comparison);
    /// The condition that the comparison comes to, if it is one of another form.
    std::optional<NodeId> reduced(const Comparison& comparison);
    std::optional<NodeId> of_choice(const Comparison& comparison);
    std::optional<NodeId> of_absolute_value(const Comparison& comparison);
    std::optional<NodeId> of_terms(const Comparison& comparison);
    /// The comparison of an operand that it is the same as.
    std::optional<Comparison> inside(const Comparison& comparison);
    std::optional<Comparison> moved(const Comparison& comparison, Op op, NodeId inner, NodeId by,
                                    bool turned);
    NodeId written(const Comparison& comparison);
    NodeId both_hold(NodeId a, NodeId b);
    NodeId either_holds(NodeId a, NodeId b);
    NodeId opposite(NodeId condition);
    /// v of a condition v < 0.
    [[nodiscard]] std::optional<NodeId> never_negative_operand(NodeId condition) const;
    /// Whether the node is undefined where the operand is; not seen for most.
    [[nodiscard]] bool needs(NodeId id, NodeId operand) const;
    NodeId chosen(NodeId condition, NodeId a, NodeId b);

    ExprBuilder builder_;
    NodeFacts facts_;
    std::vector<bool> whole_;  ///< of the first nodes
    int steps_ = 0;
};

std::optional<bool> PlainConditions::known(NodeId condition) const {
    const Node& node = builder_.node(condition);
    if (node.op != Op::Constant) return std::nullopt;
    if (node.lo > 0) return true;
    if (node.hi <= 0) return false;
    return std::nullopt;
}

bool PlainConditions::is_whole(NodeId id) {
    for (auto next = static_cast<NodeId>(whole_.size()); next <= id; ++next) {
        const Node& node = builder_.node(next);
        const bool kept = is_any_of(
            node.op, {Op::Add, Op::Subtract, Op::Multiply, Op::Negate, Op::Abs, Op::Min, Op::Max});
        bool whole = is_condition(node.op);
        if (kept) whole = whole_[node.a] && (arity(node.op) < 2 || whole_[node.b]);
        if (node.op == Op::If) whole = whole_[node.b] && whole_[node.c];
        if (node.op == Op::Constant) {
            const auto value = exact(next);
            whole = value && value->q == 1;
        }
        whole_.push_back(whole);
    }
    return whole_[id];
}

std::optional<NodeId> PlainConditions::indicated(NodeId id) const {
    const Node& node = builder_.node(id);
    if (is_condition(node.op)) return id;
    if (node.op != Op::If || !is_condition(builder_.node(node.a).op)) return std::nullopt;
    const auto one = exact(node.b);
    const auto zero = exact(node.c);
    const bool is_indicator = one && zero && one->p == 1 && one->q == 1 && zero->p == 0;
    return is_indicator ? std::optional(node.a) : std::nullopt;
}

NodeId PlainConditions::both_hold(NodeId a, NodeId b) {
    const auto first = known(a);
    const auto second = known(b);
    if (first == true || (second == false && is_total(a))) return b;
    if (second == true || (first == false && is_total(b))) return a;
    return make_call(builder_, Op::And, a, b);
}

NodeId PlainConditions::either_holds(NodeId a, NodeId b) {
    const auto first = known(a);
    const auto second = known(b);
    if (first == false || (second == true && is_total(a))) return b;
    if (second == false || (first == true && is_total(b))) return a;
    return make_call(builder_, Op::Or, a, b);
}

NodeId PlainConditions::opposite(NodeId condition) {
    if (const auto holds = known(condition)) return truth(!*holds);
    return make_call(builder_, Op::Not, condition);
}

std::optional<NodeId> PlainConditions::never_negative_operand(NodeId condition) const {
    const Node& node = builder_.node(condition);
    const auto limit = node.op == Op::Less ? exact(node.b) : std::nullopt;
    return limit && limit->p <= 0 ? std::optional(node.a) : std::nullopt;
}

bool PlainConditions::needs(NodeId id, NodeId operand) const {
    constexpr int deepest = 4;
    for (int i = 0; i < deepest; ++i) {
        if (id == operand) return true;
        const Node& node = builder_.node(id);
        if (is_any_of(node.op, {Op::Add, Op::Subtract}) && node.b == operand) return true;
        if (!is_any_of(node.op, {Op::Add, Op::Subtract, Op::Negate, Op::Abs})) return false;
        id = node.a;
    }
    return false;
}

NodeId PlainConditions::chosen(NodeId condition, NodeId a, NodeId b) {
    if (const auto holds = known(condition)) return *holds ? a : b;
    const auto size = never_negative_operand(condition);
    if (size && facts_.is_nonnegative(*size) && needs(b, *size)) return b;
    if (a == b && is_total(condition)) return a;
    const Node& node = builder_.node(condition);
    if (node.op == Op::Not) return chosen(node.a, b, a);
    return builder_.apply(Op::If, condition, a, b);
}

NodeId PlainConditions::written(const Comparison& comparison) {
    const NodeId limit = constant_of(builder_, comparison.limit);
    const Op op = comparison.strict ? Op::Less : Op::LessEqual;
    if (comparison.above) return builder_.apply(op, limit, comparison.value);
    return builder_.apply(op, comparison.value, limit);
}

/// inner ~ limit op by; `turned` where the inner value falls when the outer one grows.
std::optional<Comparison> PlainConditions::moved(const Comparison& comparison, Op op, NodeId inner,
                                                 NodeId by, bool turned) {
    const NodeId limit = constant_of(builder_, comparison.limit);
    const NodeId left = turned && op == Op::Subtract ? by : limit;
    const NodeId right = turned && op == Op::Subtract ? limit : by;
    const auto value = exact(builder_.apply(op, left, right));
    if (!value) return std::nullopt;
    return Comparison{.value = inner,
                      .limit = *value,
                      .above = comparison.above != turned,
                      .strict = comparison.strict};
}

std::optional<Comparison> PlainConditions::inside(const Comparison& comparison) {
    const Node node = builder_.node(comparison.value);
    if (node.op == Op::Negate) {
        return moved(comparison, Op::Multiply, node.a, builder_.constant(-1.0), true);
    }
    const bool binary = is_any_of(node.op, {Op::Add, Op::Subtract, Op::Multiply, Op::Divide});
    if (!binary) return std::nullopt;
    const auto a = exact(node.a);
    const auto b = exact(node.b);
    if (a && b) return std::nullopt;
    if (node.op == Op::Add && b) return moved(comparison, Op::Subtract, node.a, node.b, false);
    if (node.op == Op::Add && a) return moved(comparison, Op::Subtract, node.b, node.a, false);
    if (node.op == Op::Subtract && b) return moved(comparison, Op::Add, node.a, node.b, false);
    if (node.op == Op::Subtract && a) return moved(comparison, Op::Subtract, node.b, node.a, true);
    if (node.op == Op::Multiply && a && a->p != 0)
        return moved(comparison, Op::Divide, node.b, node.a, a->p < 0);
    if (node.op == Op::Multiply && b && b->p != 0)
        return moved(comparison, Op::Divide, node.a, node.b, b->p < 0);
    if (node.op == Op::Divide && b && b->p != 0)
        return moved(comparison, Op::Multiply, node.a, node.b, b->p < 0);
    return std::nullopt;
}

/// The condition that the comparison of a choice between numbers comes to.
std::optional<NodeId> PlainConditions::of_choice(const Comparison& comparison) {
    if (is_condition(builder_.node(comparison.value).op)) {
        const double limit =
            static_cast<double>(comparison.limit.p) / static_cast<double>(comparison.limit.q);
        const auto holds = [&](double value) {
            if (value == limit) return !comparison.strict;
            return (value > limit) == comparison.above;
        };
        const bool if_true = holds(1.0);
        const bool if_false = holds(0.0);
        if (if_true && !if_false) return comparison.value;
        if (if_false && !if_true) return opposite(comparison.value);
        if (is_total(comparison.value)) return truth(if_true);
        return std::nullopt;
    }
    const Node node = builder_.node(comparison.value);
    const bool of_numbers = node.op == Op::If && exact(node.b) && exact(node.c);
    if (!of_numbers || !is_condition(builder_.node(node.a).op)) return std::nullopt;
    const auto holds = [&](NodeId value) {
        return known(plain({.value = value,
                            .limit = comparison.limit,
                            .above = comparison.above,
                            .strict = comparison.strict}));
    };
    const auto if_true = holds(node.b);
    const auto if_false = holds(node.c);
    if (!if_true || !if_false) return std::nullopt;
    if (*if_true && !*if_false) return node.a;
    if (*if_false && !*if_true) return opposite(node.a);
    return is_total(node.a) ? std::optional(truth(*if_true)) : std::nullopt;
}

std::optional<NodeId> PlainConditions::of_absolute_value(const Comparison& comparison) {
    const Node node = builder_.node(comparison.value);
    if (node.op != Op::Abs || comparison.limit.p < 0) return std::nullopt;
    if (comparison.limit.p == 0 && comparison.above == comparison.strict) return std::nullopt;
    const Fraction below{.p = -comparison.limit.p, .q = comparison.limit.q};
    const NodeId high = plain({.value = node.a,
                               .limit = comparison.limit,
                               .above = comparison.above,
                               .strict = comparison.strict});
    const NodeId low = plain(
        {.value = node.a, .limit = below, .above = !comparison.above, .strict = comparison.strict});
    return comparison.above ? either_holds(low, high) : both_hold(low, high);
}

/// Sums and products of what is never below 0, compared with 0.
std::optional<NodeId> PlainConditions::of_terms(const Comparison& comparison) {
    const Node node = builder_.node(comparison.value);
    if (comparison.limit.p != 0 || comparison.above != comparison.strict) return std::nullopt;
    const bool sum = node.op == Op::Add;
    if (!sum && node.op != Op::Multiply) return std::nullopt;
    if (!facts_.is_nonnegative(node.a) || !facts_.is_nonnegative(node.b)) return std::nullopt;
    const NodeId a = plain({.value = node.a,
                            .limit = comparison.limit,
                            .above = comparison.above,
                            .strict = comparison.strict});
    const NodeId b = plain({.value = node.b,
                            .limit = comparison.limit,
                            .above = comparison.above,
                            .strict = comparison.strict});
    return sum == comparison.above ? either_holds(a, b) : both_hold(a, b);
}

std::optional<NodeId> PlainConditions::reduced(const Comparison& comparison) {
    const Fraction& limit = comparison.limit;
    if (const auto value = exact(comparison.value)) {
        const auto difference = exact(
            make_subtract(builder_, constant_of(builder_, *value), constant_of(builder_, limit)));
        if (!difference) return std::nullopt;
        if (difference->p == 0) return truth(!comparison.strict);
        return truth((difference->p > 0) == comparison.above);
    }
    // Without a value that is below 0.
    const bool at_most_zero =
        limit.p < 0 || (limit.p == 0 && comparison.above != comparison.strict);
    if (at_most_zero && facts_.is_nonnegative(comparison.value) && is_total(comparison.value))
        return truth(comparison.above);
    if (auto condition = of_choice(comparison)) return condition;
    if (auto condition = of_absolute_value(comparison)) return condition;
    return of_terms(comparison);
}

/// A comparison of whole numbers, as one of two kinds: above n, or at most n.
Comparison with_whole_limit(Comparison comparison) {
    const auto [p, q] = comparison.limit;
    const long long floor = p >= 0 ? p / q : -((-p + q - 1) / q);
    const bool whole = floor * q == p;
    const bool below_it = whole && comparison.strict != comparison.above;
    comparison.limit = {.p = below_it ? floor - 1 : floor, .q = 1};
    comparison.strict = comparison.above;
    return comparison;
}

NodeId PlainConditions::plain(Comparison comparison) {
    while (++steps_ < most_steps) {
        if (is_whole(comparison.value)) comparison = with_whole_limit(comparison);
        if (const auto condition = reduced(comparison)) return *condition;
        const auto next = inside(comparison);
        if (!next) break;
        comparison = *next;
    }
    return written(comparison);
}

NodeId PlainConditions::compared(const Node& node, NodeId a, NodeId b) {
    const bool strict = node.op == Op::Less;
    steps_ = 0;
    if (const auto limit = exact(b))
        return plain({.value = a, .limit = *limit, .above = false, .strict = strict});
    if (const auto limit = exact(a))
        return plain({.value = b, .limit = *limit, .above = true, .strict = strict});
    return builder_.apply(node.op, a, b);
}

NodeId PlainConditions::make(const Node& node, NodeId a, NodeId b, NodeId c) {
    if (node.op == Op::Less || node.op == Op::LessEqual) return compared(node, a, b);
    if (node.op == Op::And) return both_hold(a, b);
    if (node.op == Op::Or) return either_holds(a, b);
    if (node.op == Op::Not) return opposite(a);
    if (node.op == Op::If) return chosen(a, b, c);
    if (node.op == Op::Where && known(b) == true) return a;
    if (node.op == Op::Multiply) {
        const auto first = indicated(a);
        const auto second = first ? indicated(b) : std::nullopt;
        if (second) return chosen(both_hold(*first, *second), truth(true), truth(false));
    }
    if (node.op == Op::Abs && facts_.is_nonnegative(a)) return a;
    return copy_node(builder_, node, a, b, c);
}

}  // namespace

Expr with_plain_conditions(const Expr& expr) {
    const bool has_conditions =
        std::ranges::any_of(expr.nodes(), [](const Node& node) { return is_condition(node.op); });
    if (!has_conditions) return expr;
    PlainConditions conditions;
    return rebuilt(conditions.builder(), expr,
                   [&](ExprBuilder& /*builder*/, const Node& node, NodeId a, NodeId b, NodeId c) {
                       return conditions.make(node, a, b, c);
                   });
}

}  // namespace zeroset
