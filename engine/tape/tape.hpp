#pragma once

#include "engine/algebra/switches.hpp"
#include "engine/expr/op.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/num/interval.hpp"
#include "engine/tape/tape_graph.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

// Straight-line code of a graph for an interpreter, and shorter code that does the same where
// choices (min, max, if, where) are known to fall the same way [Keeter20].
//
// Which operand of a min may go depends on what is made of the result. Where only the zeros of f
// matter, one above 0 may. Another smooth minimum than SmoothMin is m - q with m = min(a, b) and q
// from 0 to d, 0 where |a - b| >= k. Where it is at most U, m is at most U + d, and an operand
// above U + d + k has no part in it: that may go, and q with it. So each value has a band in which
// it matters, wider from one smooth minimum to the next inside it.

namespace zeroset {

/// The values of a step that matter: outside the band, only on which side the value lies does.
struct Band {
    double lo, hi;

    static constexpr Band everything() { return {.lo = -infinity, .hi = infinity}; }
    /// The band of a value that nobody asks for.
    static constexpr Band nothing() { return {.lo = everything().hi, .hi = everything().lo}; }
    [[nodiscard]] constexpr bool empty() const { return lo > hi; }
};

/// The band of an operand that min, max or a smooth minimum may take, from that of the result: an
/// operand above hi + 1 has no part in a smooth minimum of at most hi.
constexpr Band band_of_alternative(Op op, const Band& band) {
    return op == Op::SmoothMin ? Band{.lo = band.lo, .hi = band.hi + 1} : band;
}

/// Steps of straight-line code, the last of which computes the root. Immutable.
class Tape {
public:
    using Index = std::uint32_t;
    static constexpr Index no_choice = ~Index{0};

    /// Computes a node. Its value goes to a slot that none of its operands has.
    struct Step {
        NodeId node;
        Index slot;
        std::array<Index, 3> operands;  ///< earlier steps, as many as the operator has
        Index choice = no_choice;       ///< its place in a ChoiceRecord
        /// The place where the min in a smooth minimum m - q, or the max in a smooth maximum, tells
        /// which operand is left out as it is outside the band.
        Index tells = no_choice;
        /// The `tells` of the smooth minimum or maximum in whose q this max(k - |a - b|, 0) stands:
        /// it is 0 where that one leaves an operand out.
        Index heeds = no_choice;
        /// Its place among the switches of the graph; that of a condition whose place it took.
        SwitchIndex own_switch = no_switch;
        double reach = 0;   ///< of the smooth minimum or maximum: k + d, else 0
        double height = 0;  ///< of the max(k - |a - b|, 0): k, else 0
        Band band = Band::everything();
    };

    explicit Tape(const std::shared_ptr<const TapeGraph>& graph);
    /// The tape of what one node of the graph computes.
    Tape(std::shared_ptr<const TapeGraph> graph, NodeId root);

    /// The tape for cells of a batch of which `record` tells; nothing where it would not be
    /// shorter. On whatever part of space these cells cover it computes a function with the same
    /// signs and zeros, and beside the zeros the same one.
    [[nodiscard]] std::optional<Tape> specialized(const ChoiceRecord& record,
                                                  std::span<const std::size_t> cells) const;

    [[nodiscard]] std::span<const Step> steps() const { return steps_; }
    /// The number of steps at the front that are the same for a whole batch; they keep their slots.
    [[nodiscard]] std::size_t uniform_steps() const { return uniform_; }
    [[nodiscard]] Index slots() const { return slots_; }
    [[nodiscard]] std::size_t choices() const { return choices_; }
    /// Whether there are sums, which are shorter where a choice leaves a summand 0.
    [[nodiscard]] bool has_sums() const { return sums_; }
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
    Tape() = default;
    /// Marks the smooth minimum or maximum that ends with a step.
    void mark_blend(Index sum);

    std::shared_ptr<const TapeGraph> graph_;
    std::vector<Step> steps_;
    std::size_t uniform_ = 0;
    Index slots_ = 0;
    std::size_t choices_ = 0;
    bool sums_ = false;
};

}  // namespace zeroset
