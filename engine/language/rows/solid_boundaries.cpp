#include "engine/language/rows/solid_boundaries.hpp"

#include "engine/expr/simplify.hpp"

#include <vector>

namespace zeroset {

GraphValues::Number SolidBoundaries::boundary(NodeId condition, std::size_t offset) {
    // No recursion: a text may join conditions by the ten thousand.
    std::vector<NodeId> open;
    if (!known_.contains(condition)) open.push_back(condition);
    while (!open.empty()) {
        const NodeId id = open.back();
        if (const auto part = part_without_boundary(id)) {
            open.push_back(*part);
            continue;
        }
        const Number result = boundary_by_parts(id);
        if (result && !values_.done(*result, offset)) return std::nullopt;
        known_[id] = result;
        open.pop_back();
    }
    return known_.at(condition);
}

/// Whether a condition is joined of two. (a == b is, too, but holds on a surface, and in no solid.)
bool SolidBoundaries::joins(const Node& condition) const {
    if (condition.op != Op::And && condition.op != Op::Or) return false;
    const Node& a = values_.builder().node(condition.a);
    const Node& b = values_.builder().node(condition.b);
    return !(a.op == Op::LessEqual && b.op == Op::LessEqual && a.a == b.b && a.b == b.a);
}

/// The next part of a condition whose boundary must be known for its own.
std::optional<NodeId> SolidBoundaries::part_without_boundary(NodeId id) const {
    const Node& condition = values_.builder().node(id);
    const bool two = joins(condition);
    if (!two && condition.op != Op::Not) return std::nullopt;
    const auto first = known_.find(condition.a);
    if (first == known_.end()) return condition.a;
    if (two && first->second && !known_.contains(condition.b)) return condition.b;
    return std::nullopt;
}

/// The boundary of a condition whose parts have theirs.
GraphValues::Number SolidBoundaries::boundary_by_parts(NodeId id) {
    const Node condition = values_.builder().node(id);
    if (condition.op == Op::Less || condition.op == Op::LessEqual)
        return make_subtract(values_.builder(), condition.a, condition.b);
    const bool two = joins(condition);
    if (!two && condition.op != Op::Not) return std::nullopt;
    const Number left = known_.at(condition.a);
    if (!left) return std::nullopt;
    if (!two) return make_negate(values_.builder(), *left);
    const Number right = known_.at(condition.b);
    if (!right) return std::nullopt;
    return make_call(values_.builder(), condition.op == Op::And ? Op::Max : Op::Min, *left, *right);
}

}  // namespace zeroset
