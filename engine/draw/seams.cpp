#include "engine/draw/seams.hpp"

#include "engine/draw/smooth_pieces.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t most_seams = 64;

using MakeNode = std::function<NodeId(ExprBuilder&, const std::vector<NodeId>& copies)>;

/// A formula made from copies of a graph's nodes.
Expr made_of(const Expr& f, const MakeNode& make) {
    ExprBuilder builder;
    const std::vector<NodeId> copies = copy_nodes(builder, f);
    return builder.finish(make(builder, copies), f.parameter_names());
}

/// The branch of a choice whose condition is a constant, or the node itself.
NodeId decided(ExprBuilder& builder, const Node& node, const std::vector<NodeId>& copies) {
    if (node.op != Op::If || builder.node(copies[node.a]).op != Op::Constant)
        return copy_node(builder, node, copies);
    return copies[builder.node(copies[node.a]).lo > 0.0 ? node.b : node.c];
}

/// The graph with another node in place of one.
Expr with_node(const Expr& f, NodeId at, const MakeNode& make) {
    ExprBuilder builder;
    std::vector<NodeId> copies;
    for (NodeId id = 0; id <= f.root(); ++id)
        copies.push_back(id == at ? make(builder, copies) : decided(builder, f.node(id), copies));
    return builder.finish(copies.back(), f.parameter_names());
}

class SeamFinder {
public:
    SeamFinder(const Expr& f, const std::function<Bounds(const Expr&)>& values_of)
        : f_(f), values_of_(values_of), is_restriction_(restrictions_in(f)) {}

    Seams run() {
        for (NodeId id = 0; id <= f_.root(); ++id)
            add(id);
        return std::move(seams_);
    }

private:
    void add(NodeId id);
    void add(NodeId id, const MakeNode& border, const MakeNode& one, const MakeNode& other);
    /// The seams of a step, at the whole numbers and a shift of what `steps` makes; `held` makes
    /// what it is there.
    void add_steps(NodeId id, const MakeNode& steps, double shift,
                   const std::function<MakeNode(double)>& held, double below, double above);
    [[nodiscard]] MakeNode operand(NodeId id) const {
        return [id](ExprBuilder&, const std::vector<NodeId>& copies) { return copies[id]; };
    }
    static MakeNode number(double value) {
        return [value](ExprBuilder& builder, const std::vector<NodeId>&) {
            return builder.constant(value);
        };
    }

    const Expr& f_;
    const std::function<Bounds(const Expr&)>& values_of_;
    std::vector<bool> is_restriction_;
    Seams seams_;
};

void SeamFinder::add(NodeId id, const MakeNode& border, const MakeNode& one,
                     const MakeNode& other) {
    if (seams_.list.size() >= most_seams) {
        seams_.complete = false;
        return;
    }
    seams_.list.push_back({.border = made_of(f_, border),
                           .beside = {with_node(f_, id, one), with_node(f_, id, other)}});
}

void SeamFinder::add_steps(NodeId id, const MakeNode& steps, double shift,
                           const std::function<MakeNode(double)>& held, double below,
                           double above) {
    const Bounds values = values_of_(made_of(f_, steps));
    if (!(values.lo <= values.hi)) return;
    const double first = std::ceil(values.lo - shift);
    const double last = std::floor(values.hi - shift);
    if (!(last - first < static_cast<double>(most_seams))) {
        seams_.complete = false;
        return;
    }
    for (double k = first; k <= last; k += 1.0) {
        const auto border = [&steps, at = k + shift](ExprBuilder& builder,
                                                     const std::vector<NodeId>& copies) {
            return make_subtract(builder, steps(builder, copies), builder.constant(at));
        };
        add(id, border, held(k + below), held(k + above));
    }
}

void SeamFinder::add(NodeId id) {
    const Node& node = f_.node(id);
    const auto divided = [a = node.a, b = node.b](ExprBuilder& builder,
                                                  const std::vector<NodeId>& copies) {
        return make_divide(builder, copies[a], copies[b]);
    };
    const auto remainder = [a = node.a, b = node.b](double k) -> MakeNode {
        return [a, b, k](ExprBuilder& builder, const std::vector<NodeId>& copies) {
            const NodeId whole = make_multiply(builder, builder.constant(k), copies[b]);
            return make_subtract(builder, copies[a], whole);
        };
    };
    const bool compares = node.op == Op::Less || node.op == Op::LessEqual;
    if (compares && !is_restriction_[id]) {
        const auto border = [a = node.a, b = node.b](ExprBuilder& builder,
                                                     const std::vector<NodeId>& copies) {
            return make_subtract(builder, copies[a], copies[b]);
        };
        add(id, border, number(0.0), number(1.0));
    }
    constexpr double pi = std::numbers::pi;
    if (node.op == Op::Sign) add(id, operand(node.a), number(-1.0), number(1.0));
    if (node.op == Op::Atan2) add(id, operand(node.a), number(-pi), number(pi));
    if (node.op == Op::Floor) add_steps(id, operand(node.a), 0.0, number, -1.0, 0.0);
    if (node.op == Op::Ceil) add_steps(id, operand(node.a), 0.0, number, 0.0, 1.0);
    if (node.op == Op::Round) add_steps(id, operand(node.a), 0.5, number, 0.0, 1.0);
    if (node.op == Op::Mod) add_steps(id, divided, 0.0, remainder, -1.0, 0.0);
}

}  // namespace

Seams seams_of(const Expr& f, const std::function<Bounds(const Expr&)>& values_of) {
    return SeamFinder(f, values_of).run();
}

}  // namespace zeroset
