#include "engine/rewrite/choice_tree.hpp"

#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"

#include <map>
#include <optional>

namespace zeroset {
namespace {

using Kind = ChoiceTree::Kind;

class ChoiceSplitter {
public:
    ChoiceSplitter(const Expr& expr, std::size_t most)
        : expr_(expr), copies_(copy_nodes(builder_, expr)), most_(most) {}

    ChoiceTree split() {
        const std::uint32_t root = pieces(expr_.root());
        if (leaves_ > most_) return ChoiceTree{.nodes = {{}}, .functions = {expr_}};
        ChoiceTree tree;
        add(root, tree);
        return tree;
    }

private:
    struct TreeNode {
        Kind kind = Kind::Leaf;
        std::uint32_t a = 0, b = 0;  ///< pieces; of a leaf, `a` is a node of the builder
    };

    std::uint32_t leaf(NodeId node) {
        ++leaves_;
        tree_.push_back({.kind = Kind::Leaf, .a = node});
        return static_cast<std::uint32_t>(tree_.size() - 1);
    }
    std::uint32_t choice(Kind kind, std::uint32_t a, std::uint32_t b) {
        tree_.push_back({.kind = kind, .a = a, .b = b});
        return static_cast<std::uint32_t>(tree_.size() - 1);
    }
    [[nodiscard]] bool is_leaf(std::uint32_t piece) const {
        return tree_[piece].kind == Kind::Leaf;
    }
    /// The pieces of a node of the expression.
    std::uint32_t pieces(NodeId id);
    std::uint32_t negated(std::uint32_t piece);
    std::uint32_t sum(std::uint32_t x, std::uint32_t y);
    std::uint32_t scaled(std::uint32_t piece, NodeId factor);
    std::uint32_t product(NodeId id, const Node& node);
    [[nodiscard]] std::optional<double> constant(NodeId id) const;
    std::uint32_t add(std::uint32_t piece, ChoiceTree& tree);

    const Expr& expr_;
    ExprBuilder builder_;
    std::vector<NodeId> copies_;
    std::vector<TreeNode> tree_;
    std::size_t most_;
    std::size_t leaves_ = 0;  ///< that were made, some of them for other leaves
    std::map<NodeId, std::uint32_t> functions_;
};

std::uint32_t ChoiceSplitter::pieces(NodeId id) {
    const Node& node = expr_.node(id);
    if (leaves_ > most_) return leaf(copies_[id]);
    if (node.op == Op::Max) return choice(Kind::Max, pieces(node.a), pieces(node.b));
    if (node.op == Op::Min) return choice(Kind::Min, pieces(node.a), pieces(node.b));
    if (node.op == Op::Negate) return negated(pieces(node.a));
    if (node.op == Op::Add) return sum(pieces(node.a), pieces(node.b));
    if (node.op == Op::Subtract) return sum(pieces(node.a), negated(pieces(node.b)));
    if (node.op == Op::Multiply) return product(id, node);
    if (node.op != Op::Abs) return leaf(copies_[id]);
    const std::uint32_t inner = pieces(node.a);
    return choice(Kind::Max, inner, negated(inner));
}

std::uint32_t ChoiceSplitter::negated(std::uint32_t piece) {
    const TreeNode own = tree_[piece];
    if (own.kind == Kind::Leaf) return leaf(make_negate(builder_, own.a));
    const std::uint32_t a = negated(own.a);
    return choice(own.kind == Kind::Max ? Kind::Min : Kind::Max, a, negated(own.b));
}

std::uint32_t ChoiceSplitter::sum(std::uint32_t x, std::uint32_t y) {
    const TreeNode first = tree_[x];
    const TreeNode second = tree_[y];
    if (leaves_ > most_) return x;
    if (first.kind != Kind::Leaf) {
        const std::uint32_t a = sum(first.a, y);
        return choice(first.kind, a, sum(first.b, y));
    }
    if (second.kind != Kind::Leaf) {
        const std::uint32_t a = sum(x, second.a);
        return choice(second.kind, a, sum(x, second.b));
    }
    return leaf(make_add(builder_, first.a, second.a));
}

std::optional<double> ChoiceSplitter::constant(NodeId id) const {
    const Node& node = expr_.node(id);
    if (node.op != Op::Constant || node.lo * node.hi <= 0) return std::nullopt;
    return node.lo;
}

std::uint32_t ChoiceSplitter::scaled(std::uint32_t piece, NodeId factor) {
    const TreeNode own = tree_[piece];
    if (own.kind == Kind::Leaf) return leaf(make_multiply(builder_, factor, own.a));
    const std::uint32_t a = scaled(own.a, factor);
    return choice(own.kind, a, scaled(own.b, factor));
}

std::uint32_t ChoiceSplitter::product(NodeId id, const Node& node) {
    for (const auto& [factor, other] : {std::pair{node.a, node.b}, std::pair{node.b, node.a}}) {
        const auto number = constant(factor);
        if (!number) continue;
        const std::uint32_t inner = pieces(other);
        if (is_leaf(inner)) return leaf(copies_[id]);
        if (*number > 0) return scaled(inner, copies_[factor]);
        return scaled(negated(inner), make_negate(builder_, copies_[factor]));
    }
    return leaf(copies_[id]);
}

std::uint32_t ChoiceSplitter::add(std::uint32_t piece, ChoiceTree& tree) {
    const TreeNode own = tree_[piece];
    ChoiceTree::Node node{.kind = own.kind};
    if (own.kind == Kind::Leaf) {
        const auto next = static_cast<std::uint32_t>(tree.functions.size());
        const auto [known, fresh] = functions_.emplace(own.a, next);
        const auto names = expr_.parameters();
        if (fresh) tree.functions.push_back(builder_.finish(own.a, {names.begin(), names.end()}));
        node.a = known->second;
    } else {
        node.a = add(own.a, tree);
        node.b = add(own.b, tree);
    }
    tree.nodes.push_back(node);
    return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

}  // namespace

ChoiceTree choice_tree(const Expr& expr, std::size_t most_functions) {
    return ChoiceSplitter(expr, most_functions).split();
}

}  // namespace zeroset
