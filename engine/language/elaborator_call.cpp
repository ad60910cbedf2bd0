// Builds calls: of built-in functions, of functions that the text defines, of sums.

#include "engine/base/translation.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/elaborator.hpp"
#include "engine/language/vocabulary/field_source.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/words.hpp"

#include <array>
#include <cmath>
#include <functional>

namespace zeroset {
namespace {

constexpr double max_terms = 10'000;
constexpr double most_terms_of_slider = 32;  // where a slider gives the last index
constexpr double largest_bound = 1e15;       // up to here i + 1 is exact and differs from i

using Join = NodeId (*)(ExprBuilder&, NodeId, NodeId);

/// The constructor that adds one term more to a sum, a product, the least or the greatest.
Join joiner(Composed kind) {
    if (kind == Composed::Sum) return make_add;
    if (kind == Composed::Product) return make_multiply;
    if (kind == Composed::Least)
        return [](ExprBuilder& to, NodeId a, NodeId b) { return make_call(to, Op::Min, a, b); };
    return [](ExprBuilder& to, NodeId a, NodeId b) { return make_call(to, Op::Max, a, b); };
}

}  // namespace

Elaborator::Built Elaborator::call(const Syntax& syntax, const Binding* scope) {
    if (syntax.function == nullptr) return defined_call(syntax, scope);
    if (syntax.function->is_thing()) return refuse_thing(syntax);
    if (syntax.function->repeats() && syntax.operands.size() > 1) return repeated(syntax, scope);
    if (syntax.function->is_of_library()) return library_call(syntax, scope);
    if (syntax.function->is_noise()) return noise(syntax, scope);
    const std::optional<Composed> composed = syntax.function->composed;
    if (composed == Composed::DistanceEstimate) return distance_estimate(syntax, scope);
    if (syntax.function->iterates()) return iterated(syntax, scope);
    if (composed == Composed::Keep || composed == Composed::Kept) return kept_value(syntax, scope);
    const std::optional<Op> op = syntax.function->op;
    Values arguments;
    for (const SyntaxId id : syntax.operands) {
        const std::size_t place = arguments.size();
        if (library_offset_ && op == Op::If && place == 1) {
            if (const auto truth = values_.known_truth(arguments[0].id))
                return build(syntax.operands[*truth ? 1 : 2], scope);
        }
        Built argument = argument_of(*syntax.function, place, id, scope);
        if (!argument) return std::nullopt;
        arguments.push_back(std::move(*argument));
    }
    return applied(syntax, arguments);
}

/// The argument of a function at `place`, which is a condition of if and where.
Elaborator::Built Elaborator::argument_of(const Function& function, std::size_t place, SyntaxId id,
                                          const Binding* scope) {
    const bool is_condition =
        (function.op == Op::If && place == 0) || (function.op == Op::Where && place == 1);
    if (!is_condition) return operand(id, scope);
    const Number holds = condition(id, scope, Numbers::TrueUnlessZero);
    return holds ? Built(Value{.id = *holds}) : std::nullopt;
}

/// A function of op.def or functions.def over values.
Elaborator::Built Elaborator::applied(const Syntax& syntax, const Values& arguments) {
    const Function& function = *syntax.function;
    const bool is_alone = arguments.size() == 1;
    const bool is_bundle = is_alone && !arguments[0].is_single();
    if (function.composed == Composed::Length || function.composed == Composed::Hypot)
        return values_.length(function, arguments, at(syntax.offset));
    if (is_bundle && arguments[0].is_vector() && syntax.marks == "|")
        return values_.length(*find_function("length"), arguments, at(syntax.offset));
    if (function.makes_vector()) return values_.made_vector(function, arguments, at(syntax.offset));
    if (is_bundle && (function.joins() || function.repeats()))
        return values_.joined_parts(function, arguments[0], at(syntax.offset));
    if (is_alone && !function.takes_a_number()) {
        if (library_offset_ && function.repeats()) return arguments[0];
        return fail(
            syntax.offset, function.refusal(1),
            filled(tr("type {0}, or a list: {1}"),
                   {std::string(function.name) + "(" + std::string(function.arguments) + ")",
                    std::string(function.name) + "([a, b, c])"}));
    }
    return mapped(arguments, syntax.offset, [&](std::span<const NodeId> of) {
        return make_function(builder_, function, of);
    });
}

std::optional<std::vector<NodeId>> Elaborator::numbers(std::span<const SyntaxId> ids,
                                                       const Binding* scope) {
    std::vector<NodeId> values;
    for (const SyntaxId id : ids) {
        const Number value = number(id, scope);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

/// Calls a function of library.def: builds its body with the arguments and without the text's
/// names.
Elaborator::Built Elaborator::library_call(const Syntax& syntax, const Binding* scope) {
    const LibraryFunction& function = tree_.library.at(syntax.function);
    auto arguments = operands(syntax.operands, scope);
    if (!arguments || !fits(syntax, *arguments)) return std::nullopt;
    std::vector<Binding> names;
    names.reserve(arguments->size());
    for (std::size_t i = 0; i < arguments->size(); ++i) {
        names.push_back({.name = function.arguments[i],
                         .value = (*arguments)[i],
                         .outer = i == 0 ? nullptr : &names[i - 1]});
    }
    const auto outer = library_offset_;
    library_offset_ = outer.value_or(syntax.offset);
    const Built value = build(function.body, &names.back());
    library_offset_ = outer;
    return value;
}

Elaborator::Built Elaborator::volume(const Syntax& syntax, const Binding* scope) {
    const auto point = numbers(syntax.operands, scope);
    if (!point) return std::nullopt;
    const auto field = field_of(syntax);
    if (!field) return std::nullopt;
    return done(builder_.look_up(field, (*point)[0], (*point)[1], (*point)[2]), syntax.offset);
}

/// The field of a file; nullptr is an error.
std::shared_ptr<const Field> Elaborator::field_of(const Syntax& syntax) {
    const auto known = fields_.find(syntax.text);
    if (known != fields_.end()) return known->second;
    if (files_ == nullptr) {
        fail(syntax.offset, tr("no files are read here"));
        return nullptr;
    }
    const FieldCall call = read_field_call(syntax.text).call;
    const auto field = files_->open(call);
    if (!field) {
        const FieldError& error = field.error();
        const bool has_place = !error.at.empty();
        const std::size_t inside =
            has_place ? static_cast<std::size_t>(error.at.data() - call.text.data()) : 0;
        fail(syntax.offset + inside, error.reason, error.hint);
        return nullptr;
    }
    fields_.emplace(syntax.text, *field);
    return *field;
}

/// Builds psh(i, a), which is 1 and keeps a, or csd(i), the value last kept for i.
Elaborator::Built Elaborator::kept_value(const Syntax& syntax, const Binding* scope) {
    const std::string name(syntax.function->name);
    const auto index =
        whole_number(syntax.operands[0], scope,
                     {.reason = filled(tr("the first argument of {0} is a whole number"), {name}),
                      .hint = tr("type 0, 1, ...")});
    if (!index) return std::nullopt;
    if (syntax.function->composed == Composed::Keep) {
        const Number value = number(syntax.operands[1], scope);
        if (!value) return std::nullopt;
        kept_.insert_or_assign(*index, *value);
        return done(builder_.constant(1.0), syntax.offset);
    }
    const auto kept = kept_.find(*index);
    if (kept != kept_.end()) return Value{.id = kept->second, .condition = false};
    return fail(syntax.offset, tr("csd reads what no psh before it keeps"),
                tr("type psh(i, a) for the same i before it"));
}

/// The exact value of a bound or an index, which must be a whole number.
std::optional<double> Elaborator::whole_number(SyntaxId id, const Binding* scope,
                                               const Complaint& otherwise) {
    const Number value = number(id, scope);
    if (!value) return std::nullopt;
    const std::optional<double> exact = exact_value(builder_, *value);
    const bool is_whole =
        exact && *exact == std::floor(*exact) && std::abs(*exact) <= largest_bound;
    if (is_whole) return exact;
    return fail(tree_[id].offset, otherwise.reason, otherwise.hint);
}

/// Writes out sum(f, i, m, n), prod, least or greatest.
Elaborator::Built Elaborator::repeated(const Syntax& syntax, const Binding* scope) {
    const std::string name(syntax.function->name);
    const std::string example = filled(tr("for example {0}"), {name + "(x^i, i, 1, 5)"});
    const Syntax& index = tree_[syntax.operands[1]];
    if (index.kind != SyntaxKind::Name) {
        return fail(index.offset, filled(tr("the second argument of {0} is a name"), {name}),
                    example);
    }
    const Number last = number(syntax.operands[3], scope);
    if (!last) return std::nullopt;
    const bool is_of_sliders =
        !reads_function_ && !values_.uses_space(*last) && !values_.facts(*last).constant;
    std::optional<double> bounds[2];
    for (std::size_t i = 0; i < (is_of_sliders ? 1U : 2U); ++i) {
        const std::string rule = library_offset_
                                     ? tr("the number of parts here is a whole number")
                                     : filled(tr("the bounds of {0} are whole numbers"), {name});
        const std::string hint = library_offset_ ? tr("type one, such as 8") : example;
        bounds[i] = whole_number(syntax.operands[2 + i], scope, {.reason = rule, .hint = hint});
        if (!bounds[i]) return std::nullopt;
    }
    if (is_of_sliders) return repeated_up_to(syntax, scope, *bounds[0], *last);
    if (*bounds[1] - *bounds[0] >= max_terms) {
        return fail(syntax.offset, filled(tr("{0} has more than 10 000 terms"), {name}),
                    tr("use fewer"));
    }
    const Composed kind = *syntax.function->composed;
    const bool is_empty = *bounds[1] < *bounds[0];
    if (is_empty && (kind == Composed::Least || kind == Composed::Greatest))
        return fail(syntax.offset, filled(tr("{0} has no terms"), {name}),
                    tr("let m be at most n"));
    return repeated_from(syntax, scope, *bounds[0], *bounds[1]);
}

/// Joins the terms of a sum, product, least or greatest from one index to another.
Elaborator::Built Elaborator::repeated_from(const Syntax& syntax, const Binding* scope,
                                            double first, double last) {
    const Composed kind = *syntax.function->composed;
    const Syntax& index = tree_[syntax.operands[1]];
    Built total = done(builder_.constant(kind == Composed::Sum ? 0.0 : 1.0), syntax.offset);
    for (double i = first; total && i <= last; ++i) {
        const Binding binding{
            .name = index.text, .value = {.id = builder_.constant(i)}, .outer = scope};
        if (!done(binding.value.id, index.offset)) return std::nullopt;
        Built term = operand(syntax.operands[0], &binding);
        if (!term) return std::nullopt;
        if (i != first) term = combined(*total, *term, syntax.offset, joiner(kind));
        if (!term) return std::nullopt;
        total = std::move(term);
    }
    return total;
}

/// Writes out sum(f, i, m, n) and its like where sliders give n: all terms that there may be, each
/// only where i <= n. There is no value where n is larger, or where a least has no terms.
Elaborator::Built Elaborator::repeated_up_to(const Syntax& syntax, const Binding* scope,
                                             double first, NodeId last) {
    const Composed kind = *syntax.function->composed;
    const std::string& index = tree_[syntax.operands[1]].text;
    const double end = first + most_terms_of_slider;
    note(syntax.offset, filled(tr("a bound that changes is at most {0} here"),
                               {std::to_string(static_cast<long long>(end - 1))}));
    const bool is_extreme = kind == Composed::Least || kind == Composed::Greatest;
    Value otherwise{.id = builder_.constant(kind == Composed::Sum ? 0.0 : 1.0)};
    Built total;
    for (double i = first; i < end; ++i) {
        const NodeId number = builder_.constant(i);
        const Binding binding{.name = index, .value = {.id = number}, .outer = scope};
        Built term = done(number, syntax.offset);
        if (term) term = operand(syntax.operands[0], &binding);
        if (!term) return std::nullopt;
        if (is_extreme && i == first) otherwise = *term;
        const NodeId counts = make_call(builder_, Op::LessEqual, number, last);
        const std::array<Value, 3> choice{Value{.id = counts}, *term, otherwise};
        term = mapped(choice, syntax.offset, [&](std::span<const NodeId> of) {
            return make_call(builder_, Op::If, of[0], of[1], of[2]);
        });
        if (!term) return term;
        total = total ? combined(*total, *term, syntax.offset, joiner(kind)) : term;
        if (!total) return total;
    }
    NodeId holds = make_call(builder_, Op::Less, last, builder_.constant(end));
    if (is_extreme) {
        const NodeId some = make_call(builder_, Op::LessEqual, builder_.constant(first), last);
        holds = make_call(builder_, Op::And, some, holds);
    }
    return mapped(
        std::array<Value, 2>{*total, Value{.id = holds}}, syntax.offset,
        [&](std::span<const NodeId> of) { return make_call(builder_, Op::Where, of[0], of[1]); });
}

Elaborator::Built Elaborator::defined_call(const Syntax& syntax, const Binding* scope) {
    Definition* const definition = table_.function(syntax.text, statement_);
    if (definition == nullptr) {
        return fail(syntax.offset, filled(tr("{0} is not a function"), {quoted(syntax.text)}),
                    hint_to_define(syntax.text));
    }
    const std::size_t wanted = definition->arguments.size();
    auto arguments = operands(syntax.operands, scope);
    if (!arguments) return std::nullopt;
    const bool spreads = arguments->size() == 1 && wanted > 1 && arguments->front().is_vector() &&
                         arguments->front().size() == wanted;
    if (spreads) arguments = Values(*arguments->front().parts);
    if (arguments->size() != wanted) {
        const std::string given = std::to_string(arguments->size());
        const std::string reason =
            wanted == 1 ? filled(tr("{0} takes 1 argument, not {1}"), {syntax.text, given})
                        : filled(tr("{0} takes {1} arguments, not {2}"),
                                 {syntax.text, std::to_string(wanted), given});
        const bool is_point = wanted == 1 && arguments->size() > 1 && arguments->size() <= 4;
        return fail(syntax.offset, reason,
                    is_point ? filled(tr("for a vector type {0}"), {syntax.text + "((a, b, ...))"})
                             : std::string());
    }
    if (definition->in_progress) {
        return fail(syntax.offset, filled(tr("{0} is defined by itself"), {quoted(syntax.text)}),
                    tr("write the terms out, or use sum or prod"));
    }
    definition->is_called = true;
    const Built value = function_value(*definition, *arguments);
    if (value && definition->called_with.empty()) {
        for (const Value& argument : *arguments)
            definition->called_with.push_back(argument.is_list() ? argument.part(0).size()
                                                                 : argument.size());
    }
    return value;
}

std::size_t Elaborator::CallHash::operator()(const Call& call) const {
    std::size_t hash = std::hash<const Definition*>()(call.first);
    for (const NodeId argument : call.second) {
        hash = (hash ^ argument) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

/// Adds what tells a value apart from others: the nodes of its parts, and how many they are.
void Elaborator::add_key(const Value& value, std::vector<NodeId>& key) {
    if (value.is_single()) return key.push_back(value.id);
    constexpr NodeId lists = ~NodeId{0};
    constexpr NodeId vectors = lists - 1;
    key.push_back(value.is_list() ? lists : vectors);
    key.push_back(static_cast<NodeId>(value.size()));
    for (const Value& part : *value.parts) {
        values_.count_step();
        add_key(part, key);
    }
}

Elaborator::Built Elaborator::function_value(Definition& definition, const Values& arguments) {
    Call call{&definition, {}};
    for (const Value& argument : arguments)
        add_key(argument, call.second);
    const bool by_row = goes_by_row(definition);
    auto& calls = by_row ? row_calls_ : calls_;
    if (const auto known = calls.find(call); known != calls.end()) return known->second;
    const Binding* const outermost = by_row ? row_ : nullptr;
    std::vector<Binding> scope;
    scope.reserve(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        scope.push_back({.name = definition.arguments[i],
                         .value = arguments[i],
                         .outer = i == 0 ? outermost : &scope[i - 1]});
    }
    definition.in_progress = true;
    const std::size_t outer = std::exchange(statement_, definition.statement);
    const Built value = build(definition.body, scope.empty() ? outermost : &scope.back());
    statement_ = outer;
    definition.in_progress = false;
    if (value) calls.emplace(std::move(call), *value);
    return value;
}

}  // namespace zeroset
