#include "engine/algebra/graph_facts.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/real/rounding.hpp"

#include <cmath>

namespace zeroset {
namespace {

bool nonnegative(const Node& node, const Facts& a, const Facts& b, const Facts& c) {
    switch (node.op) {
        case Op::IntPower: return node.number % 2 == 0 || a.nonnegative;
        case Op::Sqrt:
        case Op::Abs:
        case Op::Exp:
        case Op::Acos:
        case Op::Cosh:
        case Op::Acosh:
        case Op::Length:
        case Op::Fold:
        case Op::Sinhc:
        case Op::Atanc:
        case Op::Less:
        case Op::LessEqual:
        case Op::And:
        case Op::Or:
        case Op::Not: return true;
        case Op::OddRoot:
        case Op::Sign:
        case Op::Floor:
        case Op::Ceil:
        case Op::Round:
        case Op::Asin:
        case Op::Atan:
        case Op::Sinh:
        case Op::Tanh:
        case Op::Asinh:
        case Op::Atanh:
        case Op::Where: return a.nonnegative;
        case Op::Mod: return b.nonnegative;
        case Op::Add:
        case Op::Multiply:
        case Op::Min: return a.nonnegative && b.nonnegative;
        case Op::Max: return a.nonnegative || b.nonnegative;
        case Op::If: return b.nonnegative && c.nonnegative;
        case Op::Constant:
        case Op::Variable:
        case Op::Negate:
        case Op::Subtract:
        case Op::Divide:
        case Op::Sin:
        case Op::Cos:
        case Op::Tan:
        case Op::Cot:
        case Op::Atan2:
        case Op::Angle:
        case Op::AngleSin:
        case Op::AngleCos:
        case Op::Oriented:
        case Op::Sinc:
        case Op::LogSum:
        case Op::SmoothMin:
        case Op::Log:
        case Op::Log10:
        case Op::Log2:
        case Op::Field: return false;
    }
    return false;
}

/// The enclosure of a node whose operands are constant.
Enclosure<double> folded(const Node& node, const Facts& a, const Facts& b, const Facts& c) {
    const UpwardRounding upward;
    const Enclosure<double> x{.range = *a.constant};
    const Enclosure<double> y{.range = *b.constant};
    const Enclosure<double> z{.range = *c.constant};
    IntervalAlgebra<double> algebra;
    return apply(algebra, node, {.value = x, .facts = a}, {.value = y, .facts = b},
                 {.value = z, .facts = c});
}

/// Proved defined, on one smooth piece and finite.
bool is_number(const Enclosure<double>& value) {
    return value.somewhere.value_or(true) && value.everywhere.value_or(true) &&
           value.continuous.value_or(true) && std::isfinite(value.range.neg_lo) &&
           std::isfinite(value.range.hi);
}

/// Whether undefined operands leave the operator undefined.
bool undefined_by_operands(Op op, const Facts& a, const Facts& b, const Facts& c) {
    if (op != Op::If) return a.undefined || b.undefined || c.undefined;
    if (a.undefined || (b.undefined && c.undefined)) return true;
    if (!a.constant) return false;
    const bool holds = may_hold(*a.constant);
    const bool fails = may_fail(*a.constant);
    return (b.undefined && !fails) || (c.undefined && !holds);
}

Facts facts_of_operator(const Node& node, const Facts& a, const Facts& b, const Facts& c) {
    Facts facts;
    facts.uniform = a.uniform && b.uniform && c.uniform;
    facts.undefined = undefined_by_operands(node.op, a, b, c);
    if (a.constant && b.constant && c.constant) {
        const Enclosure<double> value = folded(node, a, b, c);
        if (is_number(value)) facts.constant = value.range;
        facts.undefined = !value.somewhere.value_or(true);
    }
    facts.nonnegative = facts.constant ? facts.constant->neg_lo <= 0 : nonnegative(node, a, b, c);
    return facts;
}

void set_middle(Facts& facts) {
    if (!facts.constant) return;
    const NearestRounding nearest;
    facts.middle = 0.5 * (facts.constant->hi - facts.constant->neg_lo);
    facts.middle_float = static_cast<float>(facts.middle);
}

}  // namespace

Facts facts_of_node(const Node& node, std::span<const Facts> before) {
    Facts facts;
    if (node.op == Op::Constant) {
        facts = {.nonnegative = node.lo >= 0,
                 .uniform = true,
                 .constant = Interval<double>{.neg_lo = -node.lo, .hi = node.hi}};
    } else if (node.op == Op::Variable) {
        facts = {.uniform = node.number >= variable_w, .constant = std::nullopt};
    } else {
        const Facts& a = before[node.a];
        const Facts& b = arity(node.op) < 2 ? a : before[node.b];
        const Facts& c = arity(node.op) < 3 ? a : before[node.c];
        facts = facts_of_operator(node, a, b, c);
    }
    set_middle(facts);
    return facts;
}

std::vector<Facts> facts_of(const Expr& expr) {
    std::vector<Facts> facts;
    facts.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes())
        facts.push_back(facts_of_node(node, facts));
    return facts;
}

}  // namespace zeroset
