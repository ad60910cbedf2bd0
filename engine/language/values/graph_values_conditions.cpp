// Comparisons, and what truth values and numbers are in place of each other.

#include "engine/base/translation.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/values/graph_values.hpp"

namespace zeroset {

GraphValues::Number GraphValues::number_of(const BuiltValue& value, std::size_t offset) {
    if (value.is_complex()) return refuse_complex(offset);
    if (!value.is_single()) {
        return fail(offset, filled(tr("a number is wanted here, not {0}"), {value.described()}),
                    value.is_vector() ? tr("type its length(...), or a part of it such as p.x")
                                      : tr("type sum, min or max of it"));
    }
    if (!value.condition) return value.id;
    const NodeId one = builder_.constant(1.0);
    const NodeId zero = builder_.constant(0.0);
    note(offset, tr("a condition counts as 1 where it holds and as 0 elsewhere"));
    const Built number = done(make_call(builder_, Op::If, value.id, one, zero), offset);
    return number ? Number(number->id) : std::nullopt;
}

GraphValues::Number GraphValues::condition_of(const BuiltValue& value, std::size_t offset) {
    if (value.condition) return value.id;
    if (!value.is_single()) return number_of(value, offset);
    const Node node = builder_.node(value.id);
    const NodeId one = builder_.constant(1.0);
    const NodeId zero = builder_.constant(0.0);
    if (node.op == Op::If && node.b == one && node.c == zero) return node.a;
    note(offset, tr("a number in place of a condition holds where it is not 0"));
    const NodeId below = make_call(builder_, Op::Less, value.id, zero);
    const NodeId above = make_call(builder_, Op::Less, zero, value.id);
    const Built either = done(make_call(builder_, Op::Or, below, above), offset, true);
    return either ? Number(either->id) : std::nullopt;
}

GraphValues::Number GraphValues::compared(char mark, const BuiltValue& left,
                                          const BuiltValue& right, std::size_t offset) {
    if (mark == '=') note(offset, tr("this = compares, as == does; it holds on a thin set only"));
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
GraphValues::Number GraphValues::equality(const BuiltValue& left, const BuiltValue& right,
                                          std::size_t offset) {
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
GraphValues::Number GraphValues::same_truth(const BuiltValue& condition, const BuiltValue& other) {
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

}  // namespace zeroset
