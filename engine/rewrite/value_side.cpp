#include "engine/expr/copy.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <vector>

namespace zeroset {
namespace {

/// Whether x, y or z is below a node, for each node.
std::vector<bool> depend_on_space(const Expr& f) {
    std::vector<bool> depends;
    for (const Node& node : f.nodes()) {
        const int operands = arity(node.op);
        const bool variable = node.op == Op::Variable && node.number < variable_w;
        depends.push_back(variable || (operands > 0 && depends[node.a]) ||
                          (operands > 1 && depends[node.b]) || (operands > 2 && depends[node.c]));
    }
    return depends;
}

}  // namespace

Expr value_side(const Expr& f) {
    Expr whole = unrestricted(f).value_or(f);
    const Node& root = whole.node(whole.root());
    if (root.op != Op::Subtract) return whole;
    const std::vector<bool> depends = depend_on_space(whole);
    if (depends[root.a] == depends[root.b]) return whole;
    return graph_below(whole, depends[root.a] ? root.a : root.b);
}

}  // namespace zeroset
