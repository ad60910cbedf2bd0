// From calls of functions to nodes: built-in ones, those of the text, sums.

#include "engine/expr/elaborator.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/expr/words.hpp"

#include <cmath>
#include <functional>

namespace zeroset {
namespace {

constexpr double max_terms = 10'000;
constexpr double largest_bound = 1e15;  // i + 1 is another number

}  // namespace

Elaborator::Built Elaborator::call(const Syntax& syntax, const Binding* scope) {
    if (syntax.function == nullptr) return defined_call(syntax, scope);
    if (syntax.function->repeats()) return repeated(syntax, scope);
    const std::optional<Op> op = syntax.function->op;
    std::vector<NodeId> arguments;
    for (const SyntaxId id : syntax.operands) {
        const std::size_t place = arguments.size();
        const bool is_condition = (op == Op::If && place == 0) || (op == Op::Where && place == 1);
        const Number argument =
            is_condition ? condition(id, scope, Numbers::TrueUnlessZero) : number(id, scope);
        if (!argument) return std::nullopt;
        arguments.push_back(*argument);
    }
    return done(make_function(builder_, *syntax.function, arguments), syntax.offset);
}

/// sum(f, i, m, n) and prod(f, i, m, n), written out.
Elaborator::Built Elaborator::repeated(const Syntax& syntax, const Binding* scope) {
    const std::string name(syntax.function->name);
    const Syntax& index = tree_[syntax.operands[1]];
    if (index.kind != SyntaxKind::Name) {
        return fail(index.offset, "the second argument of " + name + " is a name",
                    "for example " + name + "(x^i, i, 1, 5)");
    }
    std::optional<double> bounds[2];
    for (std::size_t i = 0; i < 2; ++i) {
        const Number bound = number(syntax.operands[2 + i], scope);
        if (!bound) return std::nullopt;
        bounds[i] = exact_value(builder_, *bound);
        if (!bounds[i] || *bounds[i] != std::floor(*bounds[i]) ||
            std::abs(*bounds[i]) > largest_bound) {
            return fail(tree_[syntax.operands[2 + i]].offset,
                        "the bounds of " + name + " are whole numbers",
                        "for example " + name + "(x^i, i, 1, 5)");
        }
    }
    if (*bounds[1] - *bounds[0] >= max_terms) {
        return fail(syntax.offset, name + " has more than 10 000 terms", "use fewer");
    }
    const bool adds = syntax.function->composed == Composed::Sum;
    NodeId total = builder_.constant(adds ? 0.0 : 1.0);
    for (double i = *bounds[0]; i <= *bounds[1]; ++i) {
        const Binding binding{index.text, {builder_.constant(i), false}, scope};
        if (!done(binding.value.id, index.offset)) return std::nullopt;
        const Number term = number(syntax.operands[0], &binding);
        if (!term) return std::nullopt;
        const bool first = i == *bounds[0];
        total = first  ? *term
                : adds ? make_add(builder_, total, *term)
                       : make_multiply(builder_, total, *term);
        if (!done(total, syntax.offset)) return std::nullopt;
    }
    return done(total, syntax.offset);
}

Elaborator::Built Elaborator::defined_call(const Syntax& syntax, const Binding* scope) {
    Definition* const definition = table_.function(syntax.text, statement_);
    if (definition == nullptr) {
        return fail(syntax.offset, quoted(syntax.text) + " is not a function",
                    "define it, as in " + syntax.text + "(u, v) = u^2 + v^2");
    }
    const std::size_t wanted = definition->arguments.size();
    if (syntax.operands.size() != wanted) {
        return fail(syntax.offset, syntax.text + " takes " + std::to_string(wanted) +
                                       (wanted == 1 ? " argument, not " : " arguments, not ") +
                                       std::to_string(syntax.operands.size()));
    }
    std::vector<NodeId> arguments;
    for (const SyntaxId id : syntax.operands) {
        const Number argument = number(id, scope);
        if (!argument) return std::nullopt;
        arguments.push_back(*argument);
    }
    if (definition->in_progress) {
        return fail(syntax.offset, quoted(syntax.text) + " is defined by itself",
                    "write the terms out, or use sum or prod");
    }
    return function_value(*definition, arguments);
}

std::size_t Elaborator::CallHash::operator()(const Call& call) const {
    std::size_t hash = std::hash<const Definition*>()(call.first);
    for (const NodeId argument : call.second) {
        hash = (hash ^ argument) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

Elaborator::Built Elaborator::function_value(Definition& definition,
                                             const std::vector<NodeId>& arguments) {
    const auto [entry, is_new] = calls_.try_emplace(Call{&definition, arguments}, Value{0, false});
    Value& known = entry->second;
    if (!is_new) return known;
    std::vector<Binding> scope;
    scope.reserve(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        scope.push_back(
            {definition.arguments[i], {arguments[i], false}, i == 0 ? nullptr : &scope[i - 1]});
    }
    definition.in_progress = true;
    const std::size_t outer = std::exchange(statement_, definition.statement);
    const Built value = build(definition.body, scope.empty() ? nullptr : &scope.back());
    statement_ = outer;
    definition.in_progress = false;
    if (value) known = *value;
    return value;
}

}  // namespace zeroset
