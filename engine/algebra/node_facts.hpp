#pragma once

#include "engine/algebra/graph_facts.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace zeroset {

inline bool is_any_of(Op op, std::initializer_list<Op> ops) {
    return std::ranges::find(ops, op) != ops.end();
}

/// Facts of the nodes of a builder, which may get more nodes meanwhile.
class NodeFacts {
public:
    explicit NodeFacts(const ExprBuilder& builder) : builder_(builder) {}

    [[nodiscard]] bool is_nonnegative(NodeId id) { return known(id).facts_[id].nonnegative; }
    /// Whether the operator has no value for some values of its operands.
    [[nodiscard]] bool is_partial(NodeId id) { return known(id).lacks_values(builder_.node(id)); }
    /// Whether the node is defined for all values of the variables; not seen for all that are.
    [[nodiscard]] bool is_total(NodeId id) { return known(id).total_[id]; }

private:
    NodeFacts& known(NodeId id) {
        if (id < facts_.size()) return *this;
        const UpwardRounding upward;
        for (auto next = static_cast<NodeId>(facts_.size()); next <= id; ++next) {
            const Node& node = builder_.node(next);
            facts_.push_back(facts_of_node(node, facts_));
            const int operands = arity(node.op);
            total_.push_back(!lacks_values(node) && (operands < 1 || total_[node.a]) &&
                             (operands < 2 || total_[node.b]) && (operands < 3 || total_[node.c]));
        }
        return *this;
    }
    [[nodiscard]] bool lacks_values(const Node& node) const {
        if (node.op == Op::Sqrt) return !facts_[node.a].nonnegative;
        if (is_any_of(node.op, {Op::Divide, Op::Mod})) {
            const auto& divisor = facts_[node.b].constant;
            return !divisor || (divisor->hi >= 0 && divisor->neg_lo >= 0);
        }
        if (node.op == Op::Field) return !node.field->is_total() || node.number != 0;
        return is_any_of(node.op, {Op::Log, Op::Log10, Op::Log2, Op::Tan, Op::Cot, Op::Asin,
                                   Op::Acos, Op::Acosh, Op::Atanh, Op::Atan2, Op::Angle,
                                   Op::AngleSin, Op::AngleCos, Op::Oriented, Op::Where});
    }

    const ExprBuilder& builder_;
    std::vector<Facts> facts_;
    std::vector<bool> total_;
};

}  // namespace zeroset
