#pragma once

#include "engine/num/interval.hpp"
#include "engine/tape/parts.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Graphs without the values of their constants, and code for all those that differ in nothing else.

namespace zeroset {

/// A graph, or a part of one, as nodes in the order in which it is read, with places for constants:
/// a Constant whose `number` is above 0 is place number - 1. The others are the same in all graphs
/// of a shape.
struct Skeleton {
    NodeId root = 0;
    std::vector<Node> nodes;
    std::vector<Interval<double>> constants;  ///< of the places

    /// Equal for graphs of one shape.
    [[nodiscard]] std::string key() const { return key_of(nodes); }
};

/// Reads parts of a graph one by one; the graph and what is known of it must outlive it.
class SkeletonReader {
public:
    SkeletonReader(const Expr& expr, std::span<const Facts> facts)
        : expr_(expr), facts_(facts), place_(expr.nodes().size(), unplaced) {}

    /// The nodes that a node is computed from; nothing where that has more nodes than `most_nodes`.
    std::optional<Skeleton> read(NodeId root, std::size_t most_nodes);

private:
    using Index = std::uint32_t;
    static constexpr Index unplaced = ~Index{0};

    [[nodiscard]] bool is_constant(NodeId id) const { return facts_[id].constant.has_value(); }
    Index append(const Node& node) {
        part_.nodes.push_back(node);
        return static_cast<Index>(part_.nodes.size() - 1);
    }
    /// A place for a constant wherever it is used.
    Index append_constant(const Facts& facts, bool negated);
    void append_operator(NodeId id);
    /// The first operand that has to be read before the node.
    [[nodiscard]] std::optional<NodeId> waits_for(const Node& node) const;

    const Expr& expr_;
    std::span<const Facts> facts_;
    std::vector<Index> place_;  ///< in the part at work
    std::vector<NodeId> read_;  ///< those that have one
    Skeleton part_;
};

/// Reads the whole graph.
Skeleton skeleton_of(const Expr& expr);

/// Whether places of skeletons of one shape hold different constants in some of them.
class VaryingPlaces {
public:
    explicit VaryingPlaces(const Skeleton& first) : varies_(first.constants.size(), false) {}

    /// Adds those in which the other differs from the first.
    void add(const Skeleton& first, const Skeleton& other);
    [[nodiscard]] bool any() const;
    [[nodiscard]] bool at(std::size_t place) const { return varies_[place]; }

private:
    std::vector<bool> varies_;
};

/// Makes the code's graph of skeletons with the same key: places that hold the same constant in all
/// of them hold it in the graph, too; the others become uniforms.
class ShapeMaker {
public:
    /// The skeleton must outlive it.
    ShapeMaker(const Skeleton& first, const VaryingPlaces& varying);

    /// Without code.
    PartShape make();
    /// A skeleton's values for the shape that was made.
    [[nodiscard]] Uniforms uniforms_of(const Skeleton& part) const;

private:
    NodeId add(const Node& node, std::span<const NodeId> added);
    /// The number of the shape's variable that is the formula's.
    int variable(int number);

    const Skeleton& first_;
    std::vector<std::optional<int>> uniform_of_place_;  ///< nothing where all have the same
    std::vector<std::size_t> shared_;
    ExprBuilder builder_;
};

}  // namespace zeroset
