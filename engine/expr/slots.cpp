#include "engine/expr/slots.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

/// The last node that needs each node; the root is needed to the end.
std::vector<NodeId> last_uses(const Expr& expr) {
    std::vector<NodeId> last(expr.nodes().size());
    for (NodeId id = 0; id <= expr.root(); ++id) {
        const Node& node = expr.node(id);
        const std::array operands{node.a, node.b, node.c};
        std::for_each_n(operands.begin(), arity(node.op), [&](NodeId k) { last[k] = id; });
    }
    last.back() = expr.root();
    return last;
}

}  // namespace

Slots assign_slots(const Expr& expr, std::span<const Facts> facts) {
    std::vector<NodeId> last = last_uses(expr);
    Slots slots;
    slots.of.resize(expr.nodes().size());
    std::vector<std::uint32_t> unused;
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (facts[id].uniform || unused.empty()) {
            slots.of[id] = slots.count++;
        } else {
            slots.of[id] = unused.back();
            unused.pop_back();
        }
        if (facts[id].uniform) continue;
        // An operand's slot is free for the nodes after this one: a value is never written over
        // what it is computed from.
        const Node& node = expr.node(id);
        const std::array operands{node.a, node.b, node.c};
        std::for_each_n(operands.begin(), arity(node.op), [&](NodeId k) {
            if (last[k] != id || facts[k].uniform) return;
            unused.push_back(slots.of[k]);
            last[k] = expr.root() + 1;  // also where it is the next operand
        });
    }
    return slots;
}

}  // namespace zeroset
