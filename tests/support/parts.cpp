#include "tests/support/parts.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/interpret/interpret.hpp"

#include <vector>

namespace zeroset::test {
namespace {

/// min(f, g) for the graph f, where g is f with other constants. The nodes of f come first.
Expr beside_another(const Expr& expr) {
    ExprBuilder builder;
    std::vector<NodeId> own;
    std::vector<NodeId> other;
    for (const Node& node : expr.nodes()) {
        const auto add = [&](std::vector<NodeId>& to, double factor) {
            Node scaled = node;
            scaled.lo *= factor;
            scaled.hi *= factor;
            to.push_back(copy_node(builder, scaled, to));
        };
        add(own, 1.0);
        add(other, 0.75);
    }
    return builder.finish(builder.apply(Op::Min, own.back(), other.back()), expr.parameter_names());
}

}  // namespace

Kernel interpret_with_parts(const Expr& expr, const MakeCode& make) {
    const Expr two = beside_another(expr);
    Parts parts = parts_of(two, facts_of(two), 100'000);
    parts.make_code(make);
    parts.of_node.resize(expr.nodes().size());
    return interpret(expr, facts_of(expr), std::move(parts));
}

Kernel interpret_with_parts(const Expr& expr) {
    return interpret_with_parts(expr,
                                [](const Expr& shape) { return std::optional(interpret(shape)); });
}

}  // namespace zeroset::test
