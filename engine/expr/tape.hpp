#pragma once

#include "engine/expr/facts.hpp"
#include "engine/expr/kernel.hpp"
#include "engine/expr/parts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

// Straight-line code of a graph for an interpreter, and shorter code that does the same where
// choices (min, max, if, where) are known to fall the same way [Keeter20].

namespace zeroset {

/// A graph with what is known of its nodes and with its parts that have code of their own, shared
/// by all tapes made of it.
struct TapeGraph {
    TapeGraph(const Expr& graph, std::vector<Facts> known, Parts with_code);
    TapeGraph(const TapeGraph&) = delete;
    TapeGraph& operator=(const TapeGraph&) = delete;
    ~TapeGraph() = default;

    Expr expr;
    std::vector<Facts> facts;  ///< of parts: what their code keeps to
    Parts parts;
    std::vector<Kernel> part_kernels;  ///< of each part; they live as long as this

    /// Nothing is computed before it: it is taken from outside, or a part.
    [[nodiscard]] bool is_first(NodeId id) const;
    /// The nodes of which the root is the least; the root where it is no min.
    [[nodiscard]] std::vector<NodeId> least_of() const;
};

/// Immutable.
class Tape {
public:
    using Index = std::uint32_t;
    static constexpr Index no_choice = ~Index{0};

    /// Computes a node. Its value goes to a slot that none of its operands has.
    struct Step {
        NodeId node;
        Index slot;
        std::array<Index, 3> operands;  ///< earlier steps, as many as the operator has
        Index choice = ~Index{0};       ///< its place in a ChoiceRecord
        bool by_sign = false;           ///< of its value only the sign matters, and where it is 0
    };

    explicit Tape(std::shared_ptr<const TapeGraph> graph);
    /// Of what a node of the graph computes.
    Tape(std::shared_ptr<const TapeGraph> graph, NodeId root);

    /// The tape for cells of a batch of which `record` tells; nothing where it would not be
    /// shorter. On whatever part of space these cells cover it computes a function with the same
    /// signs and zeros, and beside the zeros the same one.
    [[nodiscard]] std::optional<Tape> shortened(const ChoiceRecord& record,
                                                std::span<const std::size_t> cells) const;

    [[nodiscard]] std::span<const Step> steps() const { return steps_; }
    /// So many steps at the front are the same for a whole batch; they keep their slots.
    [[nodiscard]] std::size_t uniform_steps() const { return uniform_; }
    [[nodiscard]] Index slots() const { return slots_; }
    [[nodiscard]] std::size_t choices() const { return choices_; }
    /// The last step is the root.
    [[nodiscard]] const Step& root() const { return steps_.back(); }
    [[nodiscard]] const Node& node(const Step& step) const { return graph_->expr.node(step.node); }
    [[nodiscard]] const Facts& facts(const Step& step) const { return graph_->facts[step.node]; }
    /// The part that the step computes, or Parts::none.
    [[nodiscard]] std::uint32_t part(const Step& step) const {
        return graph_->parts.of_node[step.node];
    }
    [[nodiscard]] const std::shared_ptr<const TapeGraph>& graph() const { return graph_; }

private:
    class Builder;
    class Reduction;
    Tape() = default;
    void mark_by_sign();

    std::shared_ptr<const TapeGraph> graph_;
    std::vector<Step> steps_;
    std::size_t uniform_ = 0;
    Index slots_ = 0;
    std::size_t choices_ = 0;
    bool sums_ = false;  ///< there are sums, which are shorter where a choice leaves a summand 0
};

}  // namespace zeroset
