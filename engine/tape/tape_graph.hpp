#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/algebra/switches.hpp"
#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/tape/parts.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// A graph with what is known of its nodes and with its parts that have code of their own, shared
/// by all tapes made of it.
struct TapeGraph {
    TapeGraph(Expr graph, std::vector<Facts> known, Parts with_code);
    TapeGraph(const TapeGraph&) = delete;
    TapeGraph& operator=(const TapeGraph&) = delete;
    ~TapeGraph() = default;

    Expr expr;
    std::vector<Facts> facts;           ///< of parts: what their code keeps to
    std::vector<SwitchIndex> switches;  ///< of each node
    std::size_t switch_count = 0;
    /// Operands of each node that are computed before it: none for what is taken from outside, or
    /// a part.
    std::vector<std::uint8_t> operand_counts;
    Parts parts;
    std::vector<Kernel> part_kernels;  ///< of each part; they live as long as this

    /// Nothing is computed before it: it is taken from outside, or a part.
    [[nodiscard]] bool is_first(NodeId id) const { return operand_counts[id] == 0; }
    /// The nodes of which the root is the least; the root where it is no min.
    [[nodiscard]] std::vector<NodeId> union_parts() const;
};

}  // namespace zeroset
