#include "engine/expr/facts.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/num/rounding.hpp"

#include <cmath>

namespace zeroset {
namespace {

bool nonnegative(const Node& node, const Facts& a, const Facts& b) {
    switch (node.op) {
        case Op::IntPower: return node.number % 2 == 0 || a.nonnegative;
        case Op::Sqrt:
        case Op::Abs:
        case Op::Exp:
        case Op::Acos: return true;
        case Op::Add:
        case Op::Multiply:
        case Op::Min: return a.nonnegative && b.nonnegative;
        case Op::Max: return a.nonnegative || b.nonnegative;
        case Op::Constant:
        case Op::Variable:
        case Op::Negate:
        case Op::Subtract:
        case Op::Divide:
        case Op::Sin:
        case Op::Cos:
        case Op::Atan2:
        case Op::Angle:
        case Op::Log: return false;
    }
    return false;
}

/// The enclosure of a node whose operands are constant, unless it may be undefined.
std::optional<Interval<double>> folded(const Node& node, const Facts& a, const Facts& b) {
    if (node.op == Op::Sin || node.op == Op::Cos || node.op == Op::Acos || node.op == Op::Exp ||
        node.op == Op::Log || node.op == Op::Atan2 || node.op == Op::Angle) {
        // The C library's functions have no proved bound: leave them to run time.
        return std::nullopt;
    }
    IntervalAlgebra<double> algebra;
    const Interval<double> value = apply(algebra, node, Operand<Interval<double>>{*a.constant, a},
                                         Operand<Interval<double>>{*b.constant, b});
    const bool valid = algebra.defined.value_or(true) && algebra.continuous.value_or(true) &&
                       std::isfinite(value.neg_lo) && std::isfinite(value.hi);
    if (!valid) return std::nullopt;
    return value;
}

Facts facts_of_operator(const Node& node, const Facts& a, const Facts& b) {
    Facts facts;
    facts.uniform = a.uniform && b.uniform;
    if (a.constant && b.constant) facts.constant = folded(node, a, b);
    facts.nonnegative = facts.constant ? facts.constant->neg_lo <= 0 : nonnegative(node, a, b);
    return facts;
}

void set_middle(Facts& facts) {
    if (!facts.constant) return;
    const NearestRounding nearest;
    facts.middle = 0.5 * (facts.constant->hi - facts.constant->neg_lo);
    facts.middle_float = static_cast<float>(facts.middle);
}

}  // namespace

std::vector<Facts> facts_of(const Expr& expr) {
    const UpwardRounding upward;
    std::vector<Facts> facts;
    facts.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes()) {
        if (node.op == Op::Constant) {
            facts.push_back({.nonnegative = node.lo >= 0,
                             .uniform = true,
                             .constant = Interval<double>{-node.lo, node.hi}});
        } else if (node.op == Op::Variable) {
            facts.push_back({.uniform = node.number >= variable_w, .constant = std::nullopt});
        } else {
            const NodeId b = op_info(node.op).arity == 2 ? node.b : node.a;
            facts.push_back(facts_of_operator(node, facts[node.a], facts[b]));
        }
        set_middle(facts.back());
    }
    return facts;
}

}  // namespace zeroset
