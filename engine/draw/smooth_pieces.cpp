#include "engine/draw/smooth_pieces.hpp"

#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

namespace zeroset {
namespace {

bool has_kink(Op op) { return op == Op::Abs || op == Op::Min || op == Op::Max; }

/// The last of the graph's kinks: no other one is made of it.
std::optional<NodeId> outermost_kink(const Expr& f) {
    for (NodeId id = f.root() + 1; id-- > 0;) {
        if (has_kink(f.node(id).op)) return id;
    }
    return std::nullopt;
}

enum class Side : std::uint8_t { First, Second };

/// The graph with a kink held at its first or second operand; abs at its operand or the negative of
/// that.
Expr held(const Expr& f, NodeId kink, Side side) {
    ExprBuilder builder;
    std::vector<NodeId> copies;
    for (NodeId id = 0; id <= f.root(); ++id) {
        const Node& node = f.node(id);
        if (id != kink) {
            copies.push_back(copy_node(builder, node, copies));
        } else if (side == Side::First) {
            copies.push_back(copies[node.a]);
        } else {
            copies.push_back(node.op == Op::Abs ? make_negate(builder, copies[node.a])
                                                : copies[node.b]);
        }
    }
    return builder.finish(copies.back(), f.parameter_names());
}

/// Where the kink's sides are equal.
Expr border_of(const Expr& f, NodeId kink) {
    ExprBuilder builder;
    const std::vector<NodeId> copies = copy_nodes(builder, f);
    const Node& node = f.node(kink);
    const NodeId border = node.op == Op::Abs
                              ? copies[node.a]
                              : make_subtract(builder, copies[node.a], copies[node.b]);
    return builder.finish(border, f.parameter_names());
}

}  // namespace

std::vector<Expr> smooth_pieces(const Expr& f) {
    constexpr std::size_t most_pieces = 64;
    std::vector<Expr> open{f};
    std::vector<Expr> pieces;
    std::unordered_set<std::string> known;
    while (!open.empty()) {
        const Expr next = std::move(open.back());
        open.pop_back();
        const auto kink = outermost_kink(next);
        if (!kink) {
            pieces.push_back(next);
            continue;
        }
        for (const Side side : {Side::First, Side::Second}) {
            Expr part = held(next, *kink, side);
            if (known.insert(part.key()).second) open.push_back(std::move(part));
        }
        if (open.size() + pieces.size() > most_pieces) return {f};
    }
    return pieces;
}

std::vector<CreaseBorder> kinks_of(const Expr& f) {
    std::vector<CreaseBorder> kinks;
    for (NodeId id = 0; id <= f.root(); ++id) {
        if (has_kink(f.node(id).op))
            kinks.push_back({.beside = held(f, id, Side::First), .border = border_of(f, id)});
    }
    return kinks;
}

std::vector<bool> restrictions_in(const Expr& f) {
    std::vector<bool> is_condition(f.nodes().size(), false);
    for (NodeId id = f.root() + 1; id-- > 0;) {
        const Node& node = f.node(id);
        if (node.op == Op::Where) is_condition[node.b] = true;
        const bool combines = node.op == Op::And || node.op == Op::Or || node.op == Op::Not;
        if (!is_condition[id] || !combines) continue;
        is_condition[node.a] = true;
        if (arity(node.op) > 1) is_condition[node.b] = true;
    }
    return is_condition;
}

std::vector<Expr> restriction_borders(const Expr& f) {
    const std::vector<bool> is_condition = restrictions_in(f);
    std::vector<Expr> borders;
    for (NodeId id = 0; id <= f.root(); ++id) {
        const Node& node = f.node(id);
        if (!is_condition[id] || (node.op != Op::Less && node.op != Op::LessEqual)) continue;
        ExprBuilder builder;
        const std::vector<NodeId> copies = copy_nodes(builder, f);
        const NodeId border = make_subtract(builder, copies[node.a], copies[node.b]);
        borders.push_back(builder.finish(border, f.parameter_names()));
    }
    return borders;
}

}  // namespace zeroset
