// Builds comparisons and connectives, and converts between truth values and numbers.

#include "engine/base/translation.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"

#include <algorithm>

namespace zeroset {

/// A condition as a number: 1 where it holds, 0 elsewhere.
Elaborator::Number Elaborator::number_of(const Value& value, std::size_t offset) {
    if (!value.is_single()) {
        return fail(offset, filled(tr("a number is wanted here, not {0}"), {described(value)}),
                    value.is_vector() ? tr("type its length(...), or a part of it such as p.x")
                                      : tr("type sum, min or max of it"));
    }
    if (!value.condition) return value.id;
    const NodeId one = builder_.constant(1.0);
    const NodeId zero = builder_.constant(0.0);
    notes_.add(offset, tr("a condition counts as 1 where it holds and as 0 elsewhere"));
    const Built number = done(make_call(builder_, Op::If, value.id, one, zero), offset);
    return number ? Number(number->id) : std::nullopt;
}

/// A number as a condition: true where the number is not 0.
Elaborator::Number Elaborator::condition_of(const Value& value, std::size_t offset) {
    if (value.condition) return value.id;
    if (!value.is_single()) return number_of(value, offset);
    const Node node = builder_.node(value.id);
    const NodeId one = builder_.constant(1.0);
    const NodeId zero = builder_.constant(0.0);
    if (node.op == Op::If && node.b == one && node.c == zero) return node.a;
    notes_.add(offset, tr("a number in place of a condition holds where it is not 0"));
    const NodeId below = make_call(builder_, Op::Less, value.id, zero);
    const NodeId above = make_call(builder_, Op::Less, zero, value.id);
    const Built either = done(make_call(builder_, Op::Or, below, above), offset, true);
    return either ? Number(either->id) : std::nullopt;
}

Elaborator::Number Elaborator::condition(SyntaxId id, const Binding* scope, Numbers numbers) {
    const Built value = build(id, scope);
    if (!value) return std::nullopt;
    const std::size_t offset = tree_[id].offset;
    if (!value->condition && numbers == Numbers::Refused) {
        return fail(offset, tr("a condition is wanted here"), tr("compare, for example z < 1"));
    }
    return condition_of(*value, offset);
}

/// Builds a comparison; a < b < c is a < b and b < c.
Elaborator::Built Elaborator::compare(const Syntax& syntax, const Binding* scope) {
    Built left = build(syntax.operands[0], scope);
    Number all;
    for (std::size_t i = 1; left && i < syntax.operands.size(); ++i) {
        const Built right = build(syntax.operands[i], scope);
        if (!right) return std::nullopt;
        const Number one = compared(syntax.marks[i - 1], *left, *right, syntax.offset);
        if (!one) return std::nullopt;
        all = all ? make_call(builder_, Op::And, *all, *one) : *one;
        if (!done(*all, syntax.offset)) return std::nullopt;
        left = right;
    }
    if (!left) return std::nullopt;
    return Value{.id = *all, .condition = true};
}

Elaborator::Number Elaborator::compared(char mark, const Value& left, const Value& right,
                                        std::size_t offset) {
    if (mark == '=')
        notes_.add(offset, tr("this = compares, as == does; it holds on a thin set only"));
    if (mark == '=' || mark == 'e') return equality(left, right, offset);
    if (mark == 'n') {
        const Number same = equality(left, right, offset);
        return same ? Number(make_call(builder_, Op::Not, *same)) : std::nullopt;
    }
    const Number a = number_of(left, offset);
    const Number b = a ? number_of(right, offset) : std::nullopt;
    if (!b) return std::nullopt;
    const Op op = mark == '<' || mark == '>' ? Op::Less : Op::LessEqual;
    const bool ascending = mark == '<' || mark == 'l';
    return ascending ? make_call(builder_, op, *a, *b) : make_call(builder_, op, *b, *a);
}

/// Builds a == b of numbers as a <= b and b <= a; of truth values as both true or both false.
Elaborator::Number Elaborator::equality(const Value& left, const Value& right, std::size_t offset) {
    if (left.condition) {
        if (const Number same = same_truth(left, right)) return same;
    }
    if (right.condition) {
        if (const Number same = same_truth(right, left)) return same;
    }
    const Number a = number_of(left, offset);
    const Number b = a ? number_of(right, offset) : std::nullopt;
    if (!b) return std::nullopt;
    const NodeId up = make_call(builder_, Op::LessEqual, *a, *b);
    const NodeId down = make_call(builder_, Op::LessEqual, *b, *a);
    return make_call(builder_, Op::And, up, down);
}

/// Where a condition equals 0, 1 or another condition; nullopt for other numbers.
Elaborator::Number Elaborator::same_truth(const Value& condition, const Value& other) {
    const auto both = [&](NodeId a, NodeId b) { return make_call(builder_, Op::And, a, b); };
    if (other.condition) {
        const NodeId neither = both(make_call(builder_, Op::Not, condition.id),
                                    make_call(builder_, Op::Not, other.id));
        return make_call(builder_, Op::Or, both(condition.id, other.id), neither);
    }
    const std::optional<double> value = exact_value(builder_, other.id);
    if (value == 1.0) return condition.id;
    if (value == 0.0) return make_call(builder_, Op::Not, condition.id);
    return std::nullopt;
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
