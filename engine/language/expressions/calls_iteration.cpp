// Builds iterations, and the estimates of distances that they give.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/expressions/calls.hpp"
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

std::optional<int> step_count(const CallSite& site) {
    const std::string word = site.word();
    const std::string example = filled(tr("for example {0}"), {word + "(u, 3, x, u^2 + y)"});
    if (site.argument(0).kind != SyntaxKind::Name) {
        refuse_argument(site, 0, filled(tr("the first argument of {0} is a name"), {word}),
                        example);
        return std::nullopt;
    }
    const auto count = site.reader.whole_number(
        site.call.operands[1], site.context,
        {.reason = tr("the number of steps is a whole number"), .hint = example});
    if (!count) return std::nullopt;
    if (*count < 0 || *count > most_steps) {
        refuse_argument(site, 1,
                        filled(tr("{0} takes from 0 to {1} steps"),
                               {word, std::to_string(static_cast<int>(most_steps))}),
                        tr("use fewer"));
        return std::nullopt;
    }
    return static_cast<int>(*count);
}

bool is_within_budget(const CallSite& site, std::size_t before, int steps) {
    if (site.builder().size() - before <= most_nodes) return true;
    refuse_call(site,
                filled(tr("{0} steps of this iteration have more than {1} operations"),
                       {std::to_string(steps), std::to_string(most_nodes)}),
                tr("use fewer steps or a shorter step"));
    return false;
}

GraphValues::Built stepped(const CallSite& site,
                           const std::function<bool(const BuiltValue&)>& take) {
    const auto count = step_count(site);
    if (!count) return std::nullopt;
    const std::string_view name = site.argument(0).text;
    GraphValues::Built value = site.reader.operand(site.call.operands[2], site.context);
    const std::size_t before = site.builder().size();
    if (!value || !take(*value)) return std::nullopt;
    for (int step = 0; step < *count; ++step) {
        const LocalName local{.name = name, .value = *value, .outer = site.context.scope};
        value = site.reader.operand(site.call.operands[3], site.context.with(&local));
        if (!value || !take(*value) || !is_within_budget(site, before, step + 1))
            return std::nullopt;
    }
    return value;
}

/// The square of a number or of the length of a vector.
NodeId square_of(ExprBuilder& builder, const BuiltValue& value) {
    NodeId sum = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const NodeId square = make_int_power(builder, value.part(i).id, 2);
        sum = i == 0 ? square : make_add(builder, sum, square);
    }
    return sum;
}

/// The estimate that a value with this square of its length r gives: r ln(m)/(2 |g|) for the square
/// m, where g, the gradient of m over r, has twice the length of r's.
NodeId distance_where(ExprBuilder& builder, NodeId square, const std::array<NodeId, 3>& gradient) {
    const NodeId length = make_call(builder, Op::Sqrt, square);
    NodeId sum = builder.constant(0.0);
    for (const NodeId slope : gradient) {
        const NodeId part = make_divide(builder, slope, length);
        sum = make_add(builder, sum, make_int_power(builder, part, 2));
    }
    const NodeId above = make_multiply(builder, length, make_call(builder, Op::Log, square));
    const NodeId below =
        make_multiply(builder, builder.constant(2.0), make_call(builder, Op::Sqrt, sum));
    return make_divide(builder, above, below);
}

}  // namespace

GraphValues::Built read_iteration(const CallSite& site) {
    return stepped(site, [](const BuiltValue&) { return true; });
}

/// Writes out distance_estimate(p, n, start, step) [Hart89]: the estimate of the first value that
/// is far, else of the last. It is taken by x, y and z, so that it is exact for any step, and no
/// matter what moves the point. What is chosen is the estimate: it hardly differs from one step to
/// the next, so where a box has both, its range is narrow, while values and slopes are squared.
GraphValues::Built read_distance_estimate(const CallSite& site) {
    ExprBuilder& builder = site.builder();
    const std::size_t before = builder.size();
    std::optional<BuiltValue> first;
    std::vector<NodeId> squares;
    const auto take = [&](const BuiltValue& value) {
        const bool same_kind =
            !first || (value.kind == first->kind && value.size() == first->size());
        if (value.is_list() || !same_kind) {
            refuse_argument(
                site, first ? 3 : 2,
                tr("a step of distance_estimate gives a value of the kind that it starts "
                   "from, a number or a vector"),
                filled(tr("for example {0}"),
                       {"distance_estimate(q, 8, (x, y, z, 0), quaternion_square(q) + "
                        "(-1, 0, 0, 0))"}));
            return false;
        }
        if (!first) first = value;
        squares.push_back(square_of(builder, value));
        return true;
    };
    if (!stepped(site, take)) return std::nullopt;
    const auto gradients = gradients_in(builder, squares);
    NodeId estimate = distance_where(builder, squares.back(), gradients.back());
    for (std::size_t i = squares.size() - 1; i-- > 0;) {
        const NodeId is_far = make_call(builder, Op::Less, builder.constant(far * far), squares[i]);
        estimate = make_call(builder, Op::If, is_far,
                             distance_where(builder, squares[i], gradients[i]), estimate);
    }
    if (!is_within_budget(site, before, static_cast<int>(squares.size()) - 1)) return std::nullopt;
    return site.values().done(estimate, site.offset());
}

}  // namespace zeroset
