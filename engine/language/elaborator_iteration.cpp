// Builds iterations, and the estimates of distances that they give.

#include "engine/base/translation.hpp"
#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"
#include "engine/rewrite/differences/derivatives.hpp"

#include <string>

namespace zeroset {
namespace {

constexpr double most_steps = 100;
constexpr std::size_t most_nodes = 20'000;  // of one iteration

/// Values longer than this are not stepped further by distance_estimate. Steps of degree 8 stay
/// within the floats then, and for z^2 + c the estimate changes there by |c|/1000 of itself.
constexpr double far = 32.0;

}  // namespace

std::optional<int> Elaborator::step_count(const Syntax& syntax, const Binding* scope) {
    const Syntax& name = tree_[syntax.operands[0]];
    const std::string word(syntax.function->name);
    const std::string example = filled(tr("for example {0}"), {word + "(u, 3, x, u^2 + y)"});
    if (name.kind != SyntaxKind::Name) {
        fail(name.offset, filled(tr("the first argument of {0} is a name"), {word}), example);
        return std::nullopt;
    }
    const auto count =
        whole_number(syntax.operands[1], scope,
                     {.reason = tr("the number of steps is a whole number"), .hint = example});
    if (!count) return std::nullopt;
    if (*count < 0 || *count > most_steps) {
        fail(tree_[syntax.operands[1]].offset,
             filled(tr("{0} takes from 0 to {1} steps"),
                    {word, std::to_string(static_cast<int>(most_steps))}),
             tr("use fewer"));
        return std::nullopt;
    }
    return static_cast<int>(*count);
}

bool Elaborator::is_within_budget(const Syntax& syntax, std::size_t before, int steps) {
    if (builder_.size() - before <= most_nodes) return true;
    fail(syntax.offset,
         filled(tr("{0} steps of this iteration have more than {1} operations"),
                {std::to_string(steps), std::to_string(most_nodes)}),
         tr("use fewer steps or a shorter step"));
    return false;
}

/// Writes out iterate(p, n, start, step).
Elaborator::Built Elaborator::iterated(const Syntax& syntax, const Binding* scope) {
    const auto count = step_count(syntax, scope);
    if (!count) return std::nullopt;
    const std::string_view name = tree_[syntax.operands[0]].text;
    Built value = operand(syntax.operands[2], scope);
    const std::size_t before = builder_.size();
    for (int step = 0; value && step < *count; ++step) {
        const Binding binding{.name = name, .value = *value, .outer = scope};
        value = operand(syntax.operands[3], &binding);
        if (value && !is_within_budget(syntax, before, step + 1)) return std::nullopt;
    }
    return value;
}

/// The square of a number or of the length of a vector.
NodeId Elaborator::square_of(const Value& value) {
    NodeId sum = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const NodeId square = make_int_power(builder_, value.part(i).id, 2);
        sum = i == 0 ? square : make_add(builder_, sum, square);
    }
    return sum;
}

/// The first value where the condition holds, the second elsewhere; both of one size.
Elaborator::Value Elaborator::kept_where(NodeId condition, const Value& kept, const Value& other) {
    const auto chosen = [&](std::size_t i) {
        return Value{.id =
                         make_call(builder_, Op::If, condition, kept.part(i).id, other.part(i).id)};
    };
    if (kept.is_single()) return chosen(0);
    Values parts;
    for (std::size_t i = 0; i < kept.size(); ++i)
        parts.push_back(chosen(i));
    return bundle(Value::Kind::Vector, std::move(parts));
}

/// Writes out distance_estimate(p, n, start, step) [Hart89]: with m the square of the last value's
/// length r, r ln(m)/(2 |g|) where g, the gradient of m over r, has twice the length of r's. It is
/// taken by x, y and z, so that it is exact for any step, and no matter what moves the point.
Elaborator::Built Elaborator::distance_estimate(const Syntax& syntax, const Binding* scope) {
    const auto count = step_count(syntax, scope);
    if (!count) return std::nullopt;
    const std::string_view name = tree_[syntax.operands[0]].text;
    Built value = operand(syntax.operands[2], scope);
    const std::size_t before = builder_.size();
    const auto wrong_kind = [&](SyntaxId at) {
        return fail(tree_[at].offset,
                    tr("a step of distance_estimate gives a value of the kind that it starts "
                       "from, a number or a vector"),
                    filled(tr("for example {0}"),
                           {"distance_estimate(q, 8, (x, y, z, 0), quaternion_square(q) + "
                            "(-1, 0, 0, 0))"}));
    };
    if (value && value->is_list()) return wrong_kind(syntax.operands[2]);
    for (int step = 0; value && step < *count; ++step) {
        const NodeId is_far =
            make_call(builder_, Op::Less, builder_.constant(far * far), square_of(*value));
        const Binding binding{.name = name, .value = *value, .outer = scope};
        const Built next = operand(syntax.operands[3], &binding);
        if (!next) return std::nullopt;
        if (next->is_list() || next->kind != value->kind || next->size() != value->size())
            return wrong_kind(syntax.operands[3]);
        value = kept_where(is_far, *value, *next);
        if (!is_within_budget(syntax, before, step + 1)) return std::nullopt;
    }
    if (!value) return std::nullopt;
    const NodeId square = square_of(*value);
    const NodeId length = make_call(builder_, Op::Sqrt, square);
    const std::array<Expr, 3> slopes = gradient_of(builder_.finish(square));
    NodeId sum = builder_.constant(0.0);
    for (const Expr& slope : slopes) {
        const NodeId part = make_divide(builder_, copy_nodes(builder_, slope).back(), length);
        sum = make_add(builder_, sum, make_int_power(builder_, part, 2));
    }
    if (!is_within_budget(syntax, before, *count)) return std::nullopt;
    const NodeId above = make_multiply(builder_, length, make_call(builder_, Op::Log, square));
    const NodeId below =
        make_multiply(builder_, builder_.constant(2.0), make_call(builder_, Op::Sqrt, sum));
    return done(make_divide(builder_, above, below), syntax.offset);
}

}  // namespace zeroset
