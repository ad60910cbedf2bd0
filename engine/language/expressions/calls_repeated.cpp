// Writes out sums, products, the least and the greatest of terms.

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/expressions/calls.hpp"

#include <array>

namespace zeroset {
namespace {

constexpr double max_terms = 10'000;
constexpr double most_terms_of_slider = 32;  // where a slider gives the last index

/// The constructor that adds one term more to a sum, a product, the least or the greatest.
GraphValues::Binary joiner(Composed kind) {
    if (kind == Composed::Sum) return make_add;
    if (kind == Composed::Product) return make_multiply;
    if (kind == Composed::Least)
        return [](ExprBuilder& to, NodeId a, NodeId b) { return make_call(to, Op::Min, a, b); };
    return [](ExprBuilder& to, NodeId a, NodeId b) { return make_call(to, Op::Max, a, b); };
}

/// Joins the terms of a sum, product, least or greatest from one index to another.
GraphValues::Built repeated_from(const CallSite& site, double first, double last) {
    const Composed kind = site.composed();
    GraphValues& values = site.values();
    const Syntax& index = site.argument(1);
    GraphValues::Built total =
        values.done(site.builder().constant(kind == Composed::Sum ? 0.0 : 1.0), site.offset());
    for (double i = first; total && i <= last; ++i) {
        const LocalName local{.name = index.text,
                              .value = {.id = site.builder().constant(i)},
                              .outer = site.context.scope};
        if (!values.done(local.value.id, site.offset_of(1))) return std::nullopt;
        GraphValues::Built term =
            site.reader.operand(site.call.operands[0], site.context.with(&local));
        if (!term) return std::nullopt;
        if (i != first) term = values.combined(*total, *term, site.offset(), joiner(kind));
        if (!term) return std::nullopt;
        total = std::move(term);
    }
    return total;
}

/// Writes out sum(f, i, m, n) and its like where sliders give n: all terms that there may be, each
/// only where i <= n. There is no value where n is larger, or where a least has no terms.
GraphValues::Built repeated_up_to(const CallSite& site, double first, NodeId last) {
    const Composed kind = site.composed();
    ExprBuilder& builder = site.builder();
    GraphValues& values = site.values();
    const std::string& index = site.argument(1).text;
    const double end = first + most_terms_of_slider;
    site.reader.note(site.offset(),
                     filled(tr("a bound that changes is at most {0} here"),
                            {std::to_string(static_cast<long long>(end - 1))}),
                     site.context);
    const bool is_extreme = kind == Composed::Least || kind == Composed::Greatest;
    BuiltValue otherwise{.id = builder.constant(kind == Composed::Sum ? 0.0 : 1.0)};
    GraphValues::Built total;
    for (double i = first; i < end; ++i) {
        const NodeId number = builder.constant(i);
        const LocalName local{.name = index, .value = {.id = number}, .outer = site.context.scope};
        GraphValues::Built term = values.done(number, site.offset());
        if (term) term = site.reader.operand(site.call.operands[0], site.context.with(&local));
        if (!term) return std::nullopt;
        if (is_extreme && i == first) otherwise = *term;
        const NodeId counts = make_call(builder, Op::LessEqual, number, last);
        std::array<BuiltValue, 3> choice{BuiltValue{.id = counts}, *term, otherwise};
        values.make_alike(std::span(choice).subspan(1));
        term = values.mapped(choice, site.offset(), [&](std::span<const NodeId> of) {
            return make_call(builder, Op::If, of[0], of[1], of[2]);
        });
        if (!term) return term;
        total = total ? values.combined(*total, *term, site.offset(), joiner(kind)) : term;
        if (!total) return total;
    }
    NodeId holds = make_call(builder, Op::Less, last, builder.constant(end));
    if (is_extreme) {
        const NodeId some = make_call(builder, Op::LessEqual, builder.constant(first), last);
        holds = make_call(builder, Op::And, some, holds);
    }
    return values.mapped(
        std::array<BuiltValue, 2>{*total, BuiltValue{.id = holds}}, site.offset(),
        [&](std::span<const NodeId> of) { return make_call(builder, Op::Where, of[0], of[1]); });
}

}  // namespace

GraphValues::Built read_repeated(const CallSite& site) {
    const std::string name = site.word();
    const Syntax& call = site.call;
    const std::string example = filled(tr("for example {0}"), {name + "(x^i, i, 1, 5)"});
    if (site.argument(1).kind != SyntaxKind::Name) {
        return refuse_argument(site, 1, filled(tr("the second argument of {0} is a name"), {name}),
                               example);
    }
    const GraphValues::Number last = site.reader.number(call.operands[3], site.context);
    if (!last) return std::nullopt;
    const bool is_of_sliders = !site.context.reads_function && !site.values().uses_space(*last) &&
                               !site.values().facts(*last).constant;
    std::optional<double> bounds[2];
    for (std::size_t i = 0; i < (is_of_sliders ? 1U : 2U); ++i) {
        const std::string rule = site.context.library_offset
                                     ? tr("the number of parts here is a whole number")
                                     : filled(tr("the bounds of {0} are whole numbers"), {name});
        const std::string hint = site.context.library_offset ? tr("type one, such as 8") : example;
        bounds[i] = site.reader.whole_number(call.operands[2 + i], site.context,
                                             {.reason = rule, .hint = hint});
        if (!bounds[i]) return std::nullopt;
    }
    if (is_of_sliders) return repeated_up_to(site, *bounds[0], *last);
    if (*bounds[1] - *bounds[0] >= max_terms) {
        return refuse_call(site, filled(tr("{0} has more than 10 000 terms"), {name}),
                           tr("use fewer"));
    }
    const Composed kind = site.composed();
    const bool is_empty = *bounds[1] < *bounds[0];
    if (is_empty && (kind == Composed::Least || kind == Composed::Greatest))
        return refuse_call(site, filled(tr("{0} has no terms"), {name}), tr("let m be at most n"));
    return repeated_from(site, *bounds[0], *bounds[1]);
}

}  // namespace zeroset
