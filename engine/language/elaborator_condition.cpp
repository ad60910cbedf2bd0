// Builds comparisons and connectives, and converts between truth values and numbers.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"

#include <algorithm>

namespace zeroset {

Elaborator::Number Elaborator::condition(SyntaxId id, const Binding* scope, Numbers numbers) {
    const Built value = build(id, scope);
    if (!value) return std::nullopt;
    const std::size_t offset = tree_[id].offset;
    if (!value->condition && numbers == Numbers::Refused) {
        return fail(offset, tr("a condition is wanted here"), tr("compare, for example z < 1"));
    }
    return values_.condition_of(*value, at(offset));
}

/// Builds a comparison; a < b < c is a < b and b < c.
Elaborator::Built Elaborator::compare(const Syntax& syntax, const Binding* scope) {
    Built left = build(syntax.operands[0], scope);
    Number all;
    for (std::size_t i = 1; left && i < syntax.operands.size(); ++i) {
        const Built right = build(syntax.operands[i], scope);
        if (!right) return std::nullopt;
        const Number one = values_.compared(syntax.marks[i - 1], *left, *right, at(syntax.offset));
        if (!one) return std::nullopt;
        all = all ? make_call(builder_, Op::And, *all, *one) : *one;
        if (!done(*all, syntax.offset)) return std::nullopt;
        left = right;
    }
    if (!left) return std::nullopt;
    return Value{.id = *all, .condition = true};
}

Elaborator::Built Elaborator::connected(const Syntax& syntax, Op op, const Binding* scope) {
    Number all = condition(syntax.operands[0], scope, Numbers::TrueUnlessZero);
    for (std::size_t i = 1; all && i < syntax.operands.size(); ++i) {
        const Number further = condition(syntax.operands[i], scope, Numbers::TrueUnlessZero);
        if (!further) return std::nullopt;
        all = make_call(builder_, op, *all, *further);
        if (!done(*all, syntax.offset)) return std::nullopt;
    }
    if (!all) return std::nullopt;
    return Value{.id = *all, .condition = true};
}

Elaborator::Built Elaborator::cases(const Syntax& syntax, const Binding* scope) {
    const Numbers numbers = syntax.marks == "?" ? Numbers::TrueUnlessZero : Numbers::Refused;
    Built value;
    std::size_t i = syntax.operands.size();
    if (i % 2 == 1) {
        value = operand(syntax.operands[--i], scope);
        if (!value) return std::nullopt;
    }
    for (; i >= 2; i -= 2) {
        const Number where = condition(syntax.operands[i - 2], scope, numbers);
        const Built there = where ? operand(syntax.operands[i - 1], scope) : std::nullopt;
        if (!there) return std::nullopt;
        Values all{{.id = *where}, *there};
        if (value) all.push_back(*value);
        value = mapped(all, syntax.offset, [&](std::span<const NodeId> of) {
            return of.size() == 3 ? make_call(builder_, Op::If, of[0], of[1], of[2])
                                  : make_call(builder_, Op::Where, of[1], of[0]);
        });
        if (!value) return std::nullopt;
    }
    return value;
}

}  // namespace zeroset
