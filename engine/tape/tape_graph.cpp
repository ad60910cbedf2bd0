#include "engine/tape/tape_graph.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/graph_facts.hpp"
#include "engine/tape/parts.hpp"

#include <utility>

namespace zeroset {

TapeGraph::TapeGraph(Expr graph, std::vector<Facts> known, Parts with_code)
    : expr(std::move(graph)), facts(std::move(known)), parts(std::move(with_code)) {
    parts.of_node.resize(expr.nodes().size(), Parts::none);
    // The code of parts does not know their constants.
    const std::vector<Facts> whole = std::exchange(facts, {});
    for (NodeId id = 0; id < whole.size(); ++id) {
        const std::uint32_t part = parts.of_node[id];
        if (part != Parts::none) {
            facts.push_back(parts.shapes[parts.parts[part].shape].facts);
        } else {
            facts.push_back(parts.parts.empty() ? whole[id] : facts_of_node(expr.node(id), facts));
        }
    }
    for (NodeId id = 0; id < expr.nodes().size(); ++id) {
        const Node& node = expr.node(id);
        const bool first = parts.of_node[id] != Parts::none || is_leaf(node, facts[id]);
        operand_counts.push_back(first ? 0 : static_cast<std::uint8_t>(arity(node.op)));
    }
    switches = switches_of(expr, facts);
    switch_count = count_switches(switches);
    for (std::uint32_t part = 0; part < parts.parts.size(); ++part)
        part_kernels.push_back(kernel_of_part(parts, part));
}

std::vector<NodeId> TapeGraph::union_parts() const {
    std::vector<bool> seen(expr.nodes().size(), false);
    std::vector<NodeId> stack{expr.root()};
    std::vector<NodeId> least;
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (seen[id]) continue;
        seen[id] = true;
        const Node& node = expr.node(id);
        if (node.op != Op::Min || is_first(id)) {
            least.push_back(id);
        } else {
            stack.insert(stack.end(), {node.b, node.a});
        }
    }
    return least;
}

}  // namespace zeroset
