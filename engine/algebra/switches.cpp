#include "engine/algebra/switches.hpp"

#include <algorithm>

namespace zeroset {
namespace {

bool is_logic(Op op) { return op == Op::And || op == Op::Or || op == Op::Not; }

/// The nodes that only make other conditions: these are the switches in their place.
std::vector<bool> inner_conditions(const Expr& expr) {
    const std::span<const Node> nodes = expr.nodes();
    std::vector<bool> inner(nodes.size(), true);
    inner.back() = false;
    for (const Node& node : nodes) {
        if (is_logic(node.op)) continue;
        const int operands = arity(node.op);
        if (operands > 0) inner[node.a] = false;
        if (operands > 1) inner[node.b] = false;
        if (operands > 2) inner[node.c] = false;
    }
    for (NodeId id = 0; id < nodes.size(); ++id)
        inner[id] = inner[id] && is_condition(nodes[id].op);
    return inner;
}

}  // namespace

bool is_switch(Op op) {
    return op == Op::Sign || op == Op::Floor || op == Op::Ceil || op == Op::Round ||
           op == Op::Mod || op == Op::Atan2 || is_condition(op);
}

bool is_condition(Op op) { return op == Op::Less || op == Op::LessEqual || is_logic(op); }

bool has_kink(Op op) { return op == Op::Abs || op == Op::Fold || op == Op::Min || op == Op::Max; }

bool has_branches(const Expr& expr) {
    return std::ranges::any_of(
        expr.nodes(), [](const Node& node) { return is_switch(node.op) || has_kink(node.op); });
}

std::vector<SwitchIndex> switches_of(const Expr& expr, std::span<const Facts> facts) {
    std::vector<SwitchIndex> switches;
    switches.reserve(expr.nodes().size());
    const std::vector<bool> inner = inner_conditions(expr);
    SwitchIndex next = 0;
    for (NodeId id = 0; id < expr.nodes().size(); ++id) {
        const bool varies = !facts[id].uniform && !facts[id].constant;
        switches.push_back(varies && !inner[id] && is_switch(expr.node(id).op) ? next++
                                                                               : no_switch);
    }
    return switches;
}

std::size_t count_switches(std::span<const SwitchIndex> switches) {
    return static_cast<std::size_t>(
        std::ranges::count_if(switches, [](SwitchIndex index) { return index != no_switch; }));
}

}  // namespace zeroset
