#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/rewrite/passes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

/// Operators around a choice, from the inside out. Each keeps or turns the order of its operand's
/// values, also of the rounded ones.
class Mover {
public:
    explicit Mover(const Expr& expr)
        : expr_(expr),
          facts_(facts_of(expr)),
          plain_(expr.nodes().size(), true),
          takes_(expr.nodes().size(), false),
          uses_(expr.nodes().size(), 0),
          size_(expr.nodes().size(), 1),
          around_(expr.nodes().size(), nothing),
          built_(expr.nodes().size(), 0) {
        look_at_nodes();
    }

    Expr move();

private:
    /// An operator that goes inside a choice: an operand of `node`, and what goes inside after it.
    struct Wrapper {
        NodeId node;
        std::size_t hole;
        bool falls;  ///< together with the outer ones
        std::size_t outer;
    };
    static constexpr std::size_t nothing = ~std::size_t{0};
    static constexpr std::uint32_t large = 20;  ///< too much to be computed for each part

    [[nodiscard]] std::array<NodeId, 3> operands(NodeId id) const {
        const Node& node = expr_.node(id);
        return {node.a, node.b, node.c};
    }
    [[nodiscard]] std::size_t operand_count(NodeId id) const {
        return static_cast<std::size_t>(arity(expr_.node(id).op));
    }
    void look_at_nodes();
    /// The operand of which the node is a rising or falling function, if all others are plain.
    [[nodiscard]] std::optional<std::size_t> hole_of(NodeId id) const;
    [[nodiscard]] bool falls(NodeId id, std::size_t hole) const;
    /// Hands what is around a node down to its operands.
    void hand_down(NodeId id);
    void build(NodeId id);
    /// The operand of a choice, with what is around the choice.
    NodeId alternative(NodeId id, std::size_t around);

    const Expr& expr_;
    std::vector<Facts> facts_;
    std::vector<bool> plain_;  ///< depends on no choice
    std::vector<bool> takes_;  ///< what is around its only user goes on into the node
    std::vector<std::uint32_t> uses_;
    std::vector<std::uint32_t> size_;  ///< as a tree, up to `large`
    std::vector<std::size_t> around_;
    std::vector<Wrapper> wrappers_;
    ExprBuilder builder_;
    std::vector<NodeId> built_;
};

void Mover::look_at_nodes() {
    for (NodeId id = 0; id <= expr_.root(); ++id) {
        plain_[id] = facts_[id].uniform || !is_choice(expr_.node(id).op);
        const auto of = operands(id);
        for (std::size_t k = 0; k < operand_count(id); ++k) {
            plain_[id] = plain_[id] && plain_[of[k]];
            size_[id] = std::min(size_[id] + size_[of[k]], large);
            ++uses_[of[k]];
        }
    }
    for (NodeId id = 0; id <= expr_.root(); ++id) {
        if (plain_[id] || uses_[id] != 1) continue;
        const auto hole = hole_of(id);
        takes_[id] = is_choice(expr_.node(id).op) || (hole && takes_[operands(id)[*hole]]);
    }
}

std::optional<std::size_t> Mover::hole_of(NodeId id) const {
    const Op op = expr_.node(id).op;
    const auto of = operands(id);
    if (op == Op::Negate) return 0;
    if (op == Op::Add || op == Op::Subtract) {
        if (plain_[of[0]] == plain_[of[1]]) return std::nullopt;
        const std::size_t hole = plain_[of[0]] ? 1 : 0;
        if (size_[of[1 - hole]] == large && !facts_[of[1 - hole]].uniform) return std::nullopt;
        return hole;
    }
    const auto is_factor = [&](std::size_t k) {
        const auto& box = facts_[of[k]].constant;
        return box && (box->neg_lo < 0 || box->hi < 0);
    };
    if (op == Op::Multiply && is_factor(0)) return 1;
    if ((op == Op::Multiply || op == Op::Divide) && is_factor(1)) return 0;
    return std::nullopt;
}

bool Mover::falls(NodeId id, std::size_t hole) const {
    const Op op = expr_.node(id).op;
    if (op == Op::Negate) return true;
    if (op == Op::Add) return false;
    if (op == Op::Subtract) return hole == 1;
    return facts_[operands(id)[1 - hole]].constant->hi < 0;
}

void Mover::hand_down(NodeId id) {
    if (plain_[id]) return;
    const auto of = operands(id);
    if (is_choice(expr_.node(id).op)) {
        for (std::size_t k = 0; k < operand_count(id); ++k) {
            if (takes_[of[k]] && is_alternative(expr_.node(id).op, k)) around_[of[k]] = around_[id];
        }
        return;
    }
    const auto hole = hole_of(id);
    if (!hole || !takes_[of[*hole]]) return;
    const std::size_t outer = around_[id];
    const bool turned = outer != nothing && wrappers_[outer].falls;
    wrappers_.push_back(
        {.node = id, .hole = *hole, .falls = falls(id, *hole) != turned, .outer = outer});
    around_[of[*hole]] = wrappers_.size() - 1;
}

NodeId Mover::alternative(NodeId id, std::size_t around) {
    NodeId value = built_[id];
    if (takes_[id]) return value;
    for (; around != nothing; around = wrappers_[around].outer) {
        const Wrapper& wrapper = wrappers_[around];
        const Node& node = expr_.node(wrapper.node);
        std::array of{built_[node.a], built_[node.b], built_[node.c]};
        of[wrapper.hole] = value;
        value = copy_node(builder_, node, of[0], of[1], of[2]);
    }
    return value;
}

void Mover::build(NodeId id) {
    Node node = expr_.node(id);
    std::array of{built_[node.a], built_[node.b], built_[node.c]};
    if (const auto hole = hole_of(id); !plain_[id] && hole && takes_[operands(id)[*hole]]) {
        built_[id] = of[*hole];  // which has this operator inside
        return;
    }
    const std::size_t around = around_[id];
    for (std::size_t k = 0; k < operand_count(id); ++k) {
        if (is_choice(node.op) && is_alternative(node.op, k))
            of[k] = alternative(operands(id)[k], around);
    }
    const bool turned = around != nothing && wrappers_[around].falls;
    if (turned && (node.op == Op::Min || node.op == Op::Max))
        node.op = node.op == Op::Min ? Op::Max : Op::Min;
    built_[id] = copy_node(builder_, node, of[0], of[1], of[2]);
}

Expr Mover::move() {
    for (NodeId id = expr_.root() + 1; id-- > 0;)
        hand_down(id);
    // The operators around a choice may stand behind it.
    for (const bool plain : {true, false}) {
        for (NodeId id = 0; id <= expr_.root(); ++id) {
            if (plain_[id] == plain) build(id);
        }
    }
    return builder_.finish(built_[expr_.root()], expr_.parameter_names());
}

}  // namespace

Expr with_outer_choices(const Expr& expr) { return Mover(expr).move(); }

}  // namespace zeroset
