// Builds calls: of built-in functions over values, of files, of psh and csd.

#include "engine/language/expressions/calls.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

/// The error for a thing that is used as a value.
std::nullopt_t refuse_thing(const CallSite& site) {
    return refuse_call(
        site, filled(tr("{0} is drawn by itself, and is no value"), {call_of(*site.call.function)}),
        tr("type it alone in a row"));
}

}  // namespace

std::string call_of(const Function& function) {
    return std::string(function.name) + "(" + std::string(function.arguments) + ")";
}

std::nullopt_t refuse_call(const CallSite& site, std::string reason, std::string hint) {
    return site.values().fail(site.offset(), std::move(reason), std::move(hint));
}

std::nullopt_t refuse_argument(const CallSite& site, std::size_t place, std::string reason,
                               std::string hint) {
    return site.values().fail(site.offset_of(place), std::move(reason), std::move(hint));
}

ExpressionReader::Built ExpressionReader::call(const Syntax& syntax, const Context& context) {
    if (syntax.function == nullptr) return definitions_.call(syntax, context);
    const Function& function = *syntax.function;
    const CallSite site{.reader = *this, .call = syntax, .context = context};
    if (function.is_thing()) return refuse_thing(site);
    if (function.repeats() && syntax.operands.size() > 1) return read_repeated(site);
    if (function.is_of_library()) return read_library_call(site);
    const std::optional<Composed> composed = function.composed;
    if (composed == Composed::Blobs || composed == Composed::Metaballs ||
        composed == Composed::Blinn)
        return read_blobs(site);
    if (function.is_noise()) return read_noise(site);
    if (function.is_polynomial()) return read_polynomial(site);
    if (function.is_special()) return read_special(site);
    if (composed == Composed::DistanceEstimate) return read_distance_estimate(site);
    if (function.iterates()) return read_iteration(site);
    if (composed == Composed::Keep || composed == Composed::Kept)
        return kept_value(syntax, context);
    return plain_call(syntax, context);
}

/// A call whose arguments are values of any kind, or conditions.
ExpressionReader::Built ExpressionReader::plain_call(const Syntax& syntax, const Context& context) {
    const Function& function = *syntax.function;
    BuiltValues arguments;
    for (const SyntaxId id : syntax.operands) {
        const std::size_t place = arguments.size();
        if (context.library_offset && function.op == Op::If && place == 1) {
            if (const auto truth = values_.known_truth(arguments[0].id))
                return build(syntax.operands[*truth ? 1 : 2], context);
        }
        Built argument = argument_of(function, place, id, context);
        if (!argument) return std::nullopt;
        arguments.push_back(std::move(*argument));
    }
    return applied(syntax, arguments, context);
}

/// The argument of a function at `place`, which is a condition of if and where.
ExpressionReader::Built ExpressionReader::argument_of(const Function& function, std::size_t place,
                                                      SyntaxId id, const Context& context) {
    const bool is_condition =
        (function.op == Op::If && place == 0) || (function.op == Op::Where && place == 1);
    if (!is_condition) return operand(id, context);
    const Number holds = condition(id, context, Numbers::TrueUnlessZero);
    return holds ? Built(BuiltValue{.id = *holds}) : std::nullopt;
}

/// A function of op.def or functions.def over values.
ExpressionReader::Built ExpressionReader::applied(const Syntax& syntax,
                                                  const BuiltValues& arguments,
                                                  const Context& context) {
    const std::size_t offset = context.at(syntax.offset);
    const Function& function = *syntax.function;
    if (function.is_of_complex() || std::ranges::any_of(arguments, &BuiltValue::is_complex)) {
        note_if_real(syntax, arguments.front(), context);
        return values_.complex_call(function, arguments, offset);
    }
    const bool is_alone = arguments.size() == 1;
    const bool is_bundle = is_alone && !arguments[0].is_single();
    if (function.composed == Composed::Length || function.composed == Composed::Hypot)
        return values_.length(function, arguments, offset);
    if (is_bundle && arguments[0].is_vector() && syntax.marks == "|")
        return values_.length(*find_function("length"), arguments, offset);
    if (function.makes_vector()) return values_.made_vector(function, arguments, offset);
    if (is_bundle && (function.joins() || function.repeats()))
        return values_.joined_parts(function, arguments[0], offset);
    if (is_alone && !function.takes_a_number()) {
        if (context.library_offset && function.repeats()) return arguments[0];
        return values_.fail(
            offset, function.refusal(1),
            filled(tr("type {0}, or a list: {1}"),
                   {call_of(function), std::string(function.name) + "([a, b, c])"}));
    }
    return values_.mapped(arguments, offset, [&](std::span<const NodeId> of) {
        return make_function(values_.builder(), function, of);
    });
}

/// Notes that Re, Im, arg or conj is asked of a real number: z is the coordinate.
void ExpressionReader::note_if_real(const Syntax& call, const BuiltValue& of,
                                    const Context& context) {
    if (of.is_complex()) return;
    note(context.at(call.offset),
         filled(tr("{0} is of a real number here, as x, y and z are; a complex one is typed {1}"),
                {std::string(call.function->name), "x + i y"}),
         context);
}

ExpressionReader::Built ExpressionReader::volume(const Syntax& syntax, const Context& context) {
    const auto point = numbers(syntax.operands, context);
    if (!point) return std::nullopt;
    const std::size_t offset = context.at(syntax.offset);
    const auto field = files_.field(syntax.text, offset);
    if (!field) return std::nullopt;
    return values_.done(values_.builder().look_up(field, (*point)[0], (*point)[1], (*point)[2]),
                        offset);
}

/// Builds psh(i, a), which is 1 and keeps a, or csd(i), the value last kept for i.
ExpressionReader::Built ExpressionReader::kept_value(const Syntax& syntax, const Context& context) {
    const std::string name(syntax.function->name);
    const std::size_t offset = context.at(syntax.offset);
    const auto index =
        whole_number(syntax.operands[0], context,
                     {.reason = filled(tr("the first argument of {0} is a whole number"), {name}),
                      .hint = tr("type 0, 1, ...")});
    if (!index) return std::nullopt;
    if (syntax.function->composed == Composed::Keep) {
        const Number value = number(syntax.operands[1], context);
        if (!value) return std::nullopt;
        kept_.insert_or_assign(*index, *value);
        return values_.done(values_.builder().constant(1.0), offset);
    }
    const auto kept = kept_.find(*index);
    if (kept != kept_.end()) return BuiltValue{.id = kept->second};
    return values_.fail(offset, tr("csd reads what no psh before it keeps"),
                        tr("type psh(i, a) for the same i before it"));
}

}  // namespace zeroset
