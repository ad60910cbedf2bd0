// Conditions that stand alone: the boundaries of the solids in which they hold.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"

#include <cstddef>
#include <string>

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
    if (error_) return std::nullopt;
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
    if (const auto known = boundaries_.find(condition); known != boundaries_.end())
        return known->second;
    const Number result = boundary_of(condition, offset);
    if (result && !done(*result, offset)) return std::nullopt;
    boundaries_[condition] = result;
    return result;
}

Elaborator::Number Elaborator::boundary_of(NodeId id, std::size_t offset) {
    const Node condition = builder_.node(id);
    if (condition.op == Op::Less || condition.op == Op::LessEqual)
        return make_subtract(builder_, condition.a, condition.b);
    if (condition.op == Op::Not) {
        const Number inner = boundary(condition.a, offset);
        return inner ? Number(make_negate(builder_, *inner)) : std::nullopt;
    }
    if (condition.op != Op::And && condition.op != Op::Or) return std::nullopt;
    const Node a = builder_.node(condition.a);
    const Node b = builder_.node(condition.b);
    // a == b holds on a surface, and in no solid.
    const bool equates = a.op == Op::LessEqual && b.op == Op::LessEqual && a.a == b.b && a.b == b.a;
    if (equates) return std::nullopt;
    const Number left = boundary(condition.a, offset);
    const Number right = left ? boundary(condition.b, offset) : std::nullopt;
    if (!right) return std::nullopt;
    return make_call(builder_, condition.op == Op::And ? Op::Max : Op::Min, *left, *right);
}

}  // namespace zeroset
