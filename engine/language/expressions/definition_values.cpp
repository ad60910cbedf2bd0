#include "engine/language/expressions/definition_values.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/expressions/expression_reader.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <functional>
#include <string>

namespace zeroset {

std::size_t FunctionCallHash::operator()(const FunctionCall& call) const {
    std::size_t hash = std::hash<const Definition*>()(call.first);
    for (const NodeId argument : call.second) {
        hash = (hash ^ argument) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

const BuiltValue* DefinitionValues::known(const Definition& definition) const {
    const auto found = known_.values.find(&definition);
    return found == known_.values.end() ? nullptr : &found->second;
}

GraphValues::Built DefinitionValues::value(Definition& definition, const Syntax& name,
                                           const Context& context) {
    const bool by_row = context.row != nullptr && context.row->holds(definition);
    auto& values = by_row ? context.row->known.values : known_.values;
    if (const auto found = values.find(&definition); found != values.end()) return found->second;
    const std::size_t offset = context.at(name.offset);
    if (definition.in_progress) {
        if (is_built_in_value(name.text)) return reader_.names().said(name.text, offset);
        return reader_.values().fail(offset,
                                     filled(tr("{0} is defined by itself"), {quoted(name.text)}));
    }
    definition.in_progress = true;
    if (reader_.is_deep() && !settle(definition, context)) return std::nullopt;
    Context inner = context.with(by_row ? context.row->variables() : nullptr);
    inner.statement = definition.statement;
    const GraphValues::Built value = reader_.build(definition.body, inner);
    definition.in_progress = false;
    if (value) values.emplace(&definition, *value);
    return value;
}

/// Builds all values that a definition needs, the innermost first, so that a long chain of
/// definitions needs no deep stack.
bool DefinitionValues::settle(Definition& definition, const Context& context) {
    struct Visit {
        Definition* of;
        std::size_t next;
    };
    DefinitionTable& table = reader_.table();
    const bool is_bound = context.row != nullptr && context.row->variables() != nullptr;
    auto& settled = is_bound ? context.row->known.settled : known_.settled;
    std::vector<Visit> stack{{.of = &definition, .next = 0}};
    settled.insert(&definition);
    while (!stack.empty()) {
        const auto uses = table.uses(stack.back().of->statement);
        if (stack.back().next < uses.size()) {
            const NameUse& use = uses[stack.back().next++];
            Definition* const needed = table.meant(use, stack.back().of->statement);
            if (needed != nullptr && settled.insert(needed).second)
                stack.push_back({.of = needed, .next = 0});
            continue;
        }
        Definition& innermost = *stack.back().of;
        stack.pop_back();
        if (innermost.is_function || &innermost == &definition || innermost.in_progress) continue;
        if (!value(innermost, reader_.name_of(innermost), context)) return false;
    }
    return true;
}

GraphValues::Built DefinitionValues::call(const Syntax& call, const Context& context) {
    GraphValues& values = reader_.values();
    const std::size_t offset = context.at(call.offset);
    Definition* const function = reader_.table().function(call.text, context.statement);
    if (function == nullptr) {
        return values.fail(offset, filled(tr("{0} is not a function"), {quoted(call.text)}),
                           hint_to_define(call.text));
    }
    const std::size_t wanted = function->arguments.size();
    auto arguments = reader_.operands(call.operands, context);
    if (!arguments) return std::nullopt;
    const bool spreads = arguments->size() == 1 && wanted > 1 && arguments->front().is_vector() &&
                         arguments->front().size() == wanted;
    if (spreads) arguments = BuiltValues(*arguments->front().parts);
    if (arguments->size() != wanted) {
        const std::string given = std::to_string(arguments->size());
        const std::string reason =
            wanted == 1 ? filled(tr("{0} takes 1 argument, not {1}"), {call.text, given})
                        : filled(tr("{0} takes {1} arguments, not {2}"),
                                 {call.text, std::to_string(wanted), given});
        const bool is_point = wanted == 1 && arguments->size() > 1 && arguments->size() <= 4;
        return values.fail(offset, reason,
                           is_point
                               ? filled(tr("for a vector type {0}"), {call.text + "((a, b, ...))"})
                               : std::string());
    }
    if (function->in_progress) {
        return values.fail(offset, filled(tr("{0} is defined by itself"), {quoted(call.text)}),
                           tr("write the terms out, or use sum or prod"));
    }
    function->is_called = true;
    const GraphValues::Built result = value(*function, *arguments, context);
    if (result && function->called_with.empty()) {
        for (const BuiltValue& argument : *arguments)
            function->called_with.push_back(argument.is_complex() ? 1
                                            : argument.is_list()  ? argument.part(0).size()
                                                                  : argument.size());
    }
    return result;
}

/// Adds what tells a value apart from others: the nodes of its parts, and how many they are.
void DefinitionValues::add_key(const BuiltValue& value, std::vector<NodeId>& key) {
    if (value.is_single()) return key.push_back(value.id);
    constexpr NodeId lists = ~NodeId{0};
    constexpr NodeId vectors = lists - 1;
    constexpr NodeId complex = vectors - 1;
    key.push_back(value.is_list() ? lists : value.is_vector() ? vectors : complex);
    key.push_back(static_cast<NodeId>(value.size()));
    for (const BuiltValue& part : *value.parts) {
        reader_.values().count_step();
        add_key(part, key);
    }
}

GraphValues::Built DefinitionValues::value(Definition& function, const BuiltValues& arguments,
                                           const Context& context) {
    FunctionCall call{&function, {}};
    for (const BuiltValue& argument : arguments)
        add_key(argument, call.second);
    const bool by_row = context.row != nullptr && context.row->holds(function);
    auto& calls = by_row ? context.row->known.calls : known_.calls;
    if (const auto found = calls.find(call); found != calls.end()) return found->second;
    const LocalName* const outermost = by_row ? context.row->variables() : nullptr;
    std::vector<LocalName> scope;
    scope.reserve(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        scope.push_back({.name = function.arguments[i],
                         .value = arguments[i],
                         .outer = i == 0 ? outermost : &scope[i - 1]});
    }
    function.in_progress = true;
    Context inner = context.with(scope.empty() ? outermost : &scope.back());
    inner.statement = function.statement;
    const GraphValues::Built value = reader_.build(function.body, inner);
    function.in_progress = false;
    if (value) calls.emplace(std::move(call), *value);
    return value;
}

}  // namespace zeroset
