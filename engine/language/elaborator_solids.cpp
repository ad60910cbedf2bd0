// Conditions that stand alone: the boundaries of the solids in which they hold.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// A number below 0 where the condition and all that restrict it hold, above 0 elsewhere.
Elaborator::Number Elaborator::solid(const Value& condition, const StatementSyntax& statement) {
    const std::size_t offset = tree_[statement.relation].offset;
    Number all = boundary(condition.id, offset);
    for (const SyntaxId id : statement.restrictions) {
        if (!all) break;
        const Syntax& syntax = tree_[id];
        const Number further = this->condition(id, nullptr, Numbers::Refused);
        if (!further) return std::nullopt;
        const Number one = boundary(*further, syntax.offset);
        all = one ? Number(make_call(builder_, Op::Max, *all, *one)) : std::nullopt;
        if (all && !done(*all, syntax.offset)) return std::nullopt;
    }
    if (values_.failed()) return std::nullopt;
    if (!all) {
        return fail(offset, tr("this condition has no boundary that is a surface"),
                    tr("type inequalities such as z > x^2 + y^2, or a surface and a comma before "
                       "it: x^2 + y^2 = 1, z < 1"));
    }
    is_solid_ = true;
    return all;
}

/// A number below 0 where the condition holds and above 0 where it does not; nothing of one that is
/// no inequality and not joined of them, or after an error.
Elaborator::Number Elaborator::boundary(NodeId condition, std::size_t offset) {
    // No recursion: a text may join conditions by the ten thousand.
    std::vector<NodeId> open;
    if (!boundaries_.contains(condition)) open.push_back(condition);
    while (!open.empty()) {
        const NodeId id = open.back();
        if (const auto part = part_without_boundary(id)) {
            open.push_back(*part);
            continue;
        }
        const Number result = boundary_by_parts(id);
        if (result && !done(*result, offset)) return std::nullopt;
        boundaries_[id] = result;
        open.pop_back();
    }
    return boundaries_.at(condition);
}

/// Whether a condition is joined of two. (a == b is, too, but holds on a surface, and in no solid.)
bool Elaborator::joins(const Node& condition) const {
    if (condition.op != Op::And && condition.op != Op::Or) return false;
    const Node& a = builder_.node(condition.a);
    const Node& b = builder_.node(condition.b);
    return !(a.op == Op::LessEqual && b.op == Op::LessEqual && a.a == b.b && a.b == b.a);
}

/// The next part of a condition whose boundary must be known for its own.
std::optional<NodeId> Elaborator::part_without_boundary(NodeId id) const {
    const Node& condition = builder_.node(id);
    const bool two = joins(condition);
    if (!two && condition.op != Op::Not) return std::nullopt;
    const auto first = boundaries_.find(condition.a);
    if (first == boundaries_.end()) return condition.a;
    if (two && first->second && !boundaries_.contains(condition.b)) return condition.b;
    return std::nullopt;
}

/// The boundary of a condition whose parts have theirs.
Elaborator::Number Elaborator::boundary_by_parts(NodeId id) {
    const Node condition = builder_.node(id);
    if (condition.op == Op::Less || condition.op == Op::LessEqual)
        return make_subtract(builder_, condition.a, condition.b);
    const bool two = joins(condition);
    if (!two && condition.op != Op::Not) return std::nullopt;
    const Number left = boundaries_.at(condition.a);
    if (!left) return std::nullopt;
    if (!two) return make_negate(builder_, *left);
    const Number right = boundaries_.at(condition.b);
    if (!right) return std::nullopt;
    return make_call(builder_, condition.op == Op::And ? Op::Max : Op::Min, *left, *right);
}

}  // namespace zeroset
