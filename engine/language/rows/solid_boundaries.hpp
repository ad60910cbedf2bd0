#pragma once

#include "engine/language/values/graph_values.hpp"

#include <unordered_map>

namespace zeroset {

/// The boundaries of the solids in which conditions hold.
class SolidBoundaries {
public:
    explicit SolidBoundaries(GraphValues& values) : values_(values) {}

    /// A number below 0 where the condition holds and above 0 where it does not; nothing of one
    /// that is no inequality and not joined of them, or after an error.
    GraphValues::Number boundary(NodeId condition, std::size_t offset);

private:
    using Number = GraphValues::Number;
    [[nodiscard]] bool joins(const Node& condition) const;
    [[nodiscard]] std::optional<NodeId> part_without_boundary(NodeId id) const;
    Number boundary_by_parts(NodeId id);

    GraphValues& values_;
    std::unordered_map<NodeId, Number> known_;  ///< by condition
};

}  // namespace zeroset
