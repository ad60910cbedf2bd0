// Builds the nodes of expressions.

#include "engine/base/translation.hpp"
#include "engine/expr/constants.hpp"
#include "engine/expr/number.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/elaborator.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/words.hpp"

#include <cassert>

namespace zeroset {
namespace {

constexpr double largest_number = 1e300;
constexpr int deepest_tree = 5000;  // depth of trees within calls within trees
constexpr int deep = 500;           // from this depth on, definitions are settled before they are
                                    // looked up

NodeId make_mod(ExprBuilder& builder, NodeId a, NodeId b) {
    return make_call(builder, Op::Mod, a, b);
}

}  // namespace

Elaborator::Built Elaborator::build(SyntaxId id, const Binding* scope) {
    struct Level {
        int& depth;
        explicit Level(int& d) : depth(d) { ++depth; }
        ~Level() { --depth; }
    };
    const Level level(depth_);
    const Syntax& syntax = tree_[id];
    if (depth_ > deepest_tree)
        return fail(syntax.offset, tr("the definitions are nested too deep"));
    if (!counts(syntax.offset)) return std::nullopt;
    switch (syntax.kind) {
        case SyntaxKind::Number: return literal(syntax);
        case SyntaxKind::Name: return name(syntax, scope);
        case SyntaxKind::Negate: return negated(syntax, scope);
        case SyntaxKind::Sum: return sum(syntax, scope);
        case SyntaxKind::Product: return product(syntax, scope);
        case SyntaxKind::Power: return power(syntax, scope);
        case SyntaxKind::Volume: return volume(syntax, scope);
        case SyntaxKind::Vector: return vector(syntax, scope);
        case SyntaxKind::Items: return list(syntax, scope);
        case SyntaxKind::Part: return part(syntax, scope);
        case SyntaxKind::Replace: return replaced(syntax, scope);
        case SyntaxKind::Call: return call(syntax, scope);
        case SyntaxKind::Compare: return compare(syntax, scope);
        case SyntaxKind::And: return connected(syntax, Op::And, scope);
        case SyntaxKind::Or: return connected(syntax, Op::Or, scope);
        case SyntaxKind::Not: {
            const Number a = condition(syntax.operands[0], scope, Numbers::TrueUnlessZero);
            return a ? done(make_call(builder_, Op::Not, *a, 0), syntax.offset, true)
                     : std::nullopt;
        }
        case SyntaxKind::Cases: return cases(syntax, scope);
        case SyntaxKind::Let: return with_local_value(syntax, scope);
        case SyntaxKind::List: return last_of_list(syntax);
        case SyntaxKind::Earlier: return earlier_.at(syntax.operands[0]);
    }
    return std::nullopt;
}

Elaborator::Number Elaborator::number(SyntaxId id, const Binding* scope) {
    const Built value = build(id, scope);
    return value ? number_of(*value, tree_[id].offset) : std::nullopt;
}

Elaborator::Built Elaborator::literal(const Syntax& syntax) {
    const NumberEnclosure number = enclose_number(syntax.text);
    if (number.hi > largest_number) {
        return fail(syntax.offset, filled(tr("the number {0} is too large"), {quoted(syntax.text)}),
                    tr("stay below 1e300"));
    }
    return done(builder_.constant(number.lo, number.hi), syntax.offset);
}

Elaborator::Built Elaborator::name(const Syntax& syntax, const Binding* scope) {
    for (const Binding* binding = scope; binding != nullptr; binding = binding->outer) {
        values_.count_step();
        if (binding->name == syntax.text) return binding->value;
    }
    Definition* const definition =
        library_offset_ ? nullptr : table_.value(syntax.text, statement_);
    if (definition != nullptr) return defined_value(*definition, syntax);
    if (is_built_in_value(syntax.text)) return said(syntax);
    return unknown(syntax);
}

/// The parameter of this name, or the error for a name that can be none.
Elaborator::Built Elaborator::unknown(const Syntax& syntax) {
    const std::string& name = syntax.text;
    if (const Definition* const function = table_.function(name, statement_)) {
        std::string call = name + "(";
        for (const std::string& argument : function->arguments)
            call += (call.ends_with('(') ? "" : ", ") + argument;
        return fail(syntax.offset, filled(tr("{0} is a function"), {quoted(name)}),
                    filled(tr("type {0}"), {call + ")"}));
    }
    if (is_parameter_name(name)) return parameter(name, syntax.offset);
    if (auto foreign = error_for_foreign(name, syntax.offset)) {
        return fail(foreign->offset, std::move(foreign->reason), std::move(foreign->hint));
    }
    return values_.fail({.offset = at(syntax.offset),
                         .reason = filled(tr("{0} is not known"), {quoted(name)}),
                         .hint = hint_for_unknown(name),
                         .mend = library_offset_ ? std::nullopt : mend_for_unknown(name)});
}

Elaborator::Built Elaborator::said(const Syntax& syntax) {
    says_w_ = says_w_ || syntax.text == "w";
    says_t_ = says_t_ || syntax.text == "t";
    return done(built_in(syntax.text)->id, syntax.offset);
}

Elaborator::Built Elaborator::built_in(std::string_view name) {
    const auto variable = [&](int index) { return builder_.variable(index); };
    const auto radius = [&](int dimensions) {
        NodeId squares = make_power(builder_, variable(0), builder_.constant(2.0));
        for (int i = 1; i < dimensions; ++i) {
            squares = make_add(builder_, squares,
                               make_power(builder_, variable(i), builder_.constant(2.0)));
        }
        return make_call(builder_, Op::Sqrt, squares);
    };
    const auto value = [&]() -> NodeId {
        if (name == "x" || name == "y" || name == "z") return variable(name[0] - 'x');
        if (name == "w" || name == "t") return variable(variable_w);
        if (name == "r") return radius(3);
        if (name == "rho") return radius(2);
        if (name == "theta") return make_call(builder_, Op::Atan2, variable(1), variable(0));
        if (name == "phi") {
            return make_call(builder_, Op::Acos, make_divide(builder_, variable(2), radius(3)));
        }
        for (const NamedConstant& known : named_constants) {
            if (name == known.name) return builder_.constant(known.value.lo, known.value.hi);
        }
        assert(name == "golden");
        const NodeId root5 = make_call(builder_, Op::Sqrt, builder_.constant(5.0));
        return make_divide(builder_, make_add(builder_, builder_.constant(1.0), root5),
                           builder_.constant(2.0));
    };
    return Value{.id = value(), .condition = false};
}

Elaborator::Built Elaborator::parameter(const std::string& name, std::size_t offset) {
    const auto [entry, is_new] = parameter_index_.try_emplace(name, parameters_.size());
    if (is_new) {
        if (parameters_.size() == ProgramLimits::parameters) {
            return fail(offset, filled(tr("there are more than {0} parameters"),
                                       {std::to_string(ProgramLimits::parameters)}));
        }
        parameters_.push_back(name);
        note_capital(name, offset);
    }
    return done(builder_.variable(variable_w + 1 + static_cast<int>(entry->second)), offset);
}

/// Notes that X and E are parameters here, but the coordinate and 2.718... elsewhere.
void Elaborator::note_capital(const std::string& name, std::size_t offset) {
    const bool is_axis = name == "X" || name == "Y" || name == "Z";
    if (!is_axis && name != "E") return;
    const char* const note = is_axis ? tr("{0} is a parameter; for the coordinate type {1}")
                                     : tr("{0} is a parameter; for 2.718... type {1}");
    notes_.add(offset, filled(note, {name, in_small_letters(name)}));
}

Elaborator::Built Elaborator::defined_value(Definition& definition, const Syntax& syntax) {
    const bool by_row = goes_by_row(definition);
    const auto known = row_values_.find(&definition);
    if (by_row && known != row_values_.end()) return known->second;
    if (!by_row && definition.value) return definition.value;
    if (definition.in_progress) {
        if (is_built_in_value(syntax.text)) return said(syntax);
        return fail(syntax.offset, filled(tr("{0} is defined by itself"), {quoted(syntax.text)}));
    }
    definition.in_progress = true;
    if (depth_ > deep && !settle(definition)) return std::nullopt;
    const std::size_t outer = std::exchange(statement_, definition.statement);
    const Built value = build(definition.body, by_row ? row_ : nullptr);
    statement_ = outer;
    definition.in_progress = false;
    if (!by_row) definition.value = value;
    if (by_row && value) row_values_.emplace(&definition, *value);
    return value;
}

/// Builds all values that a definition needs, the innermost first, so that a long chain of
/// definitions needs no deep stack.
bool Elaborator::settle(Definition& definition) {
    struct Visit {
        Definition* of;
        std::size_t next;
    };
    std::vector<Visit> stack{{.of = &definition, .next = 0}};
    definition.settled_in = binding_;
    while (!stack.empty()) {
        const auto uses = table_.uses(stack.back().of->statement);
        if (stack.back().next < uses.size()) {
            const NameUse& use = uses[stack.back().next++];
            Definition* const needed = table_.meant(use, stack.back().of->statement);
            if (needed == nullptr || needed->settled_in == binding_) continue;
            needed->settled_in = binding_;
            stack.push_back({.of = needed, .next = 0});
            continue;
        }
        Definition& known = *stack.back().of;
        stack.pop_back();
        if (known.is_function || &known == &definition || known.in_progress) continue;
        const Syntax& relation = tree_[tree_.statements[known.statement].relation];
        if (!defined_value(known, tree_[relation.operands[0]])) return false;
    }
    return true;
}

Elaborator::Built Elaborator::negated(const Syntax& syntax, const Binding* scope) {
    const Built a = operand(syntax.operands[0], scope);
    if (!a) return std::nullopt;
    return mapped(std::span(&*a, 1), syntax.offset,
                  [&](std::span<const NodeId> of) { return make_negate(builder_, of[0]); });
}

Elaborator::Built Elaborator::power(const Syntax& syntax, const Binding* scope) {
    const Built a = operand(syntax.operands[0], scope);
    const Built b = a ? operand(syntax.operands[1], scope) : std::nullopt;
    if (!b) return std::nullopt;
    if (a->is_vector() || b->is_vector()) {
        return fail(syntax.offset, tr("a vector has no powers"),
                    tr("type dot(p, p) for its squared length"));
    }
    return combined(*a, *b, syntax.offset, make_power);
}

Elaborator::Built Elaborator::sum(const Syntax& syntax, const Binding* scope) {
    Built total = operand(syntax.operands[0], scope);
    for (std::size_t i = 1; total && i < syntax.operands.size(); ++i) {
        const Built term = operand(syntax.operands[i], scope);
        if (!term) return std::nullopt;
        const std::size_t offset = tree_[syntax.operands[i]].offset;
        if (total->is_vector() != term->is_vector() && !total->is_list() && !term->is_list())
            note(offset, tr("a number beside a vector counts for each of its parts"));
        total =
            combined(*total, *term, offset, syntax.marks[i - 1] == '+' ? make_add : make_subtract);
    }
    return total;
}

Elaborator::Built Elaborator::product(const Syntax& syntax, const Binding* scope) {
    Built total = operand(syntax.operands[0], scope);
    for (std::size_t i = 1; total && i < syntax.operands.size(); ++i) {
        const Built factor = operand(syntax.operands[i], scope);
        if (!factor) return std::nullopt;
        const std::size_t offset = tree_[syntax.operands[i]].offset;
        if (total->is_vector() && factor->is_vector()) {
            note(offset, tr("vectors are multiplied and divided part by part; type dot(a, b) or "
                            "cross(a, b) for their products"));
        }
        switch (syntax.marks[i - 1]) {
            case '[':
                if (!total->is_single()) return values_.refuse_index(*total, at(offset));
                [[fallthrough]];
            case '*': total = combined(*total, *factor, offset, make_multiply); break;
            case '/':
                if (is_zero_by_name(syntax.operands[i], *factor)) return std::nullopt;
                total = combined(*total, *factor, offset, make_divide);
                break;
            default:
                total = combined(*total, *factor, offset, make_mod);
                notes_.add(offset,
                           tr("a % b is mod(a, b), from 0 up to b; for the remainder of C, with "
                              "the sign of a, type fmod(a, b)"));
        }
    }
    return total;
}

/// Whether a divisor is a name whose value is 0; sets the error if so.
bool Elaborator::is_zero_by_name(SyntaxId id, const Value& divisor) {
    if (!divisor.is_single()) return false;
    const Syntax& syntax = tree_[id];
    const bool is_name = syntax.kind == SyntaxKind::Name;
    if (!values_.refuses_undefined() || !is_name || !values_.is_zero(divisor.id)) return false;
    fail(syntax.offset,
         filled(tr("this is not a number: a division by 0, as {0} is 0"), {syntax.text}),
         filled(tr("give {0} another value"), {syntax.text}));
    return true;
}

/// Builds an expression that follows a local value in a function's body.
Elaborator::Built Elaborator::with_local_value(const Syntax& syntax, const Binding* scope) {
    const Built value = build(syntax.operands[0], scope);
    if (!value) return std::nullopt;
    const Binding binding{.name = syntax.text, .value = *value, .outer = scope};
    return build(syntax.operands[1], &binding);
}

/// Builds the values of a list in order, each once, so that a long list needs no deep stack.
Elaborator::Built Elaborator::last_of_list(const Syntax& syntax) {
    Built last;
    for (const SyntaxId id : syntax.operands) {
        last = build(id, nullptr);
        if (!last) return last;
        earlier_.insert_or_assign(id, *last);
    }
    return last;
}

}  // namespace zeroset
