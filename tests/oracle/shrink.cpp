#include "tests/oracle/shrink.hpp"

#include "engine/expr/copy.hpp"
#include "tests/support/op_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace zeroset::test {
namespace {

bool is_leaf(const Node& node) { return arity(node.op) == 0; }
bool is_condition_node(const Node& node) {
    return !is_leaf(node) && is_condition(op_info(node.op));
}

std::array<NodeId, 3> operands(const Node& node) { return {node.a, node.b, node.c}; }

/// The formula with node `target` replaced by the node that `make` makes or finds in the copy.
template <class Make>
Expr replaced(const Expr& expr, NodeId target, Make make) {
    ExprBuilder builder;
    std::vector<NodeId> copies;
    for (NodeId id = 0; id <= expr.root(); ++id) {
        const Node& node = expr.node(id);
        copies.push_back(id == target ? make(builder, copies) : copy_node(builder, node, copies));
    }
    return builder.finish(copies.back());
}

/// Whether angles that are known only up to turns reach the value through sin or cos alone.
bool hides_turns(const Expr& expr) {
    std::vector<bool> turns;
    for (const Node& node : expr.nodes()) {
        bool below = node.op == Op::Angle;
        for (int k = 0; k < arity(node.op); ++k)
            below = below || turns[operands(node).at(static_cast<std::size_t>(k))];
        const bool seen = node.op == Op::Sin || node.op == Op::Cos;
        const bool passes = node.op == Op::Angle || node.op == Op::Multiply ||
                            node.op == Op::Negate || node.op == Op::IntPower;
        if (below && !seen && !passes) return false;
        turns.push_back(below && !seen);
    }
    return !turns.back();
}

template <class Real>
bool is_shorter(Real a, Real b) {
    return hex(static_cast<double>(a)).size() < hex(static_cast<double>(b)).size();
}

/// The number rounded to about `bits` bits.
template <class Real>
Real rounded(Real a, int bits) {
    if (a == 0 || !std::isfinite(a)) return a;
    const Real unit = std::ldexp(Real(1), std::ilogb(a) - bits);
    return std::nearbyint(a / unit) * unit;
}

template <class Real>
std::vector<Interval<Real>> simpler_intervals(const Interval<Real>& a) {
    const Real lo = -a.neg_lo;
    const Real hi = a.hi;
    std::vector<Interval<Real>> result;
    if (lo != hi) {
        const Real middle = lo / 2 + hi / 2;
        result = {{-lo, lo}, {-hi, hi}};
        if (middle > lo && middle < hi) {
            result.push_back({-lo, middle});
            result.push_back({-middle, hi});
        }
    }
    for (const int bits : {0, 2, 6, 12}) {
        const Real short_lo = rounded(lo, bits);
        const Real short_hi = rounded(hi, bits);
        if (is_shorter(short_lo, lo) && short_lo <= hi) result.push_back({-short_lo, hi});
        if (is_shorter(short_hi, hi) && short_hi >= lo) result.push_back({-lo, short_hi});
        if (lo == hi && is_shorter(short_lo, lo)) result.push_back({-short_lo, short_lo});
    }
    return result;
}

}  // namespace

std::vector<Expr> simpler_formulas(const Expr& expr) {
    std::vector<Expr> result;
    const auto keep = [&](Expr candidate) {
        if (hides_turns(candidate)) result.push_back(std::move(candidate));
    };
    for (NodeId id = expr.root() + 1; id-- > 0;) {
        const Node& node = expr.node(id);
        if (is_leaf(node)) continue;
        for (int k = 0; k < arity(node.op); ++k) {
            const NodeId operand = operands(node).at(static_cast<std::size_t>(k));
            if (is_condition_node(expr.node(operand)) != is_condition_node(node)) continue;
            keep(replaced(expr, id, [&](ExprBuilder&, auto& copies) { return copies[operand]; }));
        }
        if (is_condition_node(node)) continue;
        keep(replaced(expr, id, [](ExprBuilder& builder, auto&) { return builder.variable(0); }));
        keep(replaced(expr, id, [](ExprBuilder& builder, auto&) { return builder.constant(1); }));
    }
    return result;
}

template <class Real>
std::vector<Box4<Real>> simpler_boxes(const Box4<Real>& box) {
    std::vector<Box4<Real>> result;
    for (std::size_t v = 0; v < box.size(); ++v) {
        for (const Interval<Real>& simpler : simpler_intervals(box.at(v))) {
            result.push_back(box);
            result.back().at(v) = simpler;
        }
    }
    return result;
}

template std::vector<Box4<float>> simpler_boxes(const Box4<float>&);
template std::vector<Box4<double>> simpler_boxes(const Box4<double>&);

}  // namespace zeroset::test
