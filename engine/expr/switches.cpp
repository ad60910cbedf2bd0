#include "engine/expr/switches.hpp"

#include <algorithm>

namespace zeroset {

bool is_switch(Op op) {
    return op == Op::Sign || op == Op::Floor || op == Op::Ceil || op == Op::Round ||
           op == Op::Mod || op == Op::Atan2 || op == Op::Less || op == Op::LessEqual;
}

bool has_kink(Op op) { return op == Op::Abs || op == Op::Min || op == Op::Max; }

bool has_branches(const Expr& expr) {
    return std::ranges::any_of(
        expr.nodes(), [](const Node& node) { return is_switch(node.op) || has_kink(node.op); });
}

std::vector<SwitchIndex> switches_of(const Expr& expr, std::span<const Facts> facts) {
    std::vector<SwitchIndex> switches;
    switches.reserve(expr.nodes().size());
    SwitchIndex next = 0;
    for (NodeId id = 0; id < expr.nodes().size(); ++id) {
        const bool varies = !facts[id].uniform && !facts[id].constant;
        switches.push_back(varies && is_switch(expr.node(id).op) ? next++ : no_switch);
    }
    return switches;
}

std::size_t count_switches(std::span<const SwitchIndex> switches) {
    return static_cast<std::size_t>(
        std::ranges::count_if(switches, [](SwitchIndex index) { return index != no_switch; }));
}

}  // namespace zeroset
