// Builds iterations, and the estimates of distances that they give.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"
#include "engine/rewrite/differences/derivatives.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace zeroset {
namespace {

constexpr double most_steps = 100;
constexpr std::size_t most_nodes = 20'000;  // of one iteration

/// The length of values from which on distance_estimate takes no further steps. For z^2 + c the
/// estimate changes there by |c|/1000 of itself.
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

Elaborator::Built Elaborator::stepped(const Syntax& syntax, const Binding* scope,
                                      const std::function<bool(const Value&)>& take) {
    const auto count = step_count(syntax, scope);
    if (!count) return std::nullopt;
    const std::string_view name = tree_[syntax.operands[0]].text;
    Built value = operand(syntax.operands[2], scope);
    const std::size_t before = builder_.size();
    if (!value || !take(*value)) return std::nullopt;
    for (int step = 0; step < *count; ++step) {
        const Binding binding{.name = name, .value = *value, .outer = scope};
        value = operand(syntax.operands[3], &binding);
        if (!value || !take(*value) || !is_within_budget(syntax, before, step + 1))
            return std::nullopt;
    }
    return value;
}

/// Writes out iterate(p, n, start, step).
Elaborator::Built Elaborator::iterated(const Syntax& syntax, const Binding* scope) {
    return stepped(syntax, scope, [](const Value&) { return true; });
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

/// The estimate that a value with this square of its length r gives: r ln(m)/(2 |g|) for the square
/// m, where g, the gradient of m over r, has twice the length of r's.
NodeId Elaborator::distance_where(NodeId square, const std::array<NodeId, 3>& gradient) {
    const NodeId length = make_call(builder_, Op::Sqrt, square);
    NodeId sum = builder_.constant(0.0);
    for (const NodeId slope : gradient) {
        const NodeId part = make_divide(builder_, slope, length);
        sum = make_add(builder_, sum, make_int_power(builder_, part, 2));
    }
    const NodeId above = make_multiply(builder_, length, make_call(builder_, Op::Log, square));
    const NodeId below =
        make_multiply(builder_, builder_.constant(2.0), make_call(builder_, Op::Sqrt, sum));
    return make_divide(builder_, above, below);
}

/// Writes out distance_estimate(p, n, start, step) [Hart89]: the estimate of the first value that
/// is far, else of the last. It is taken by x, y and z, so that it is exact for any step, and no
/// matter what moves the point. What is chosen is the estimate: it hardly differs from one step to
/// the next, so where a box has both, its range is narrow, while values and slopes are squared.
Elaborator::Built Elaborator::distance_estimate(const Syntax& syntax, const Binding* scope) {
    const std::size_t before = builder_.size();
    std::optional<Value> first;
    std::vector<NodeId> squares;
    const auto take = [&](const Value& value) {
        const bool same_kind =
            !first || (value.kind == first->kind && value.size() == first->size());
        if (value.is_list() || !same_kind) {
            fail(tree_[syntax.operands[first ? 3 : 2]].offset,
                 tr("a step of distance_estimate gives a value of the kind that it starts "
                    "from, a number or a vector"),
                 filled(tr("for example {0}"),
                        {"distance_estimate(q, 8, (x, y, z, 0), quaternion_square(q) + "
                         "(-1, 0, 0, 0))"}));
            return false;
        }
        if (!first) first = value;
        squares.push_back(square_of(value));
        return true;
    };
    if (!stepped(syntax, scope, take)) return std::nullopt;
    const auto gradients = gradients_in(builder_, squares);
    NodeId estimate = distance_where(squares.back(), gradients.back());
    for (std::size_t i = squares.size() - 1; i-- > 0;) {
        const NodeId is_far =
            make_call(builder_, Op::Less, builder_.constant(far * far), squares[i]);
        estimate =
            make_call(builder_, Op::If, is_far, distance_where(squares[i], gradients[i]), estimate);
    }
    if (!is_within_budget(syntax, before, static_cast<int>(squares.size()) - 1))
        return std::nullopt;
    return done(estimate, syntax.offset);
}

}  // namespace zeroset
