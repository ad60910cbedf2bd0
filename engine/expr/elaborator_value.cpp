// From a tree's expressions to nodes.

#include "engine/expr/constants.hpp"
#include "engine/expr/elaborator.hpp"
#include "engine/expr/number.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/expr/words.hpp"

#include <cassert>
#include <cmath>
#include <functional>

namespace zeroset {
namespace {

constexpr double largest_number = 1e300;
constexpr int max_depth = 5000;               // of trees within calls within trees
constexpr std::size_t max_steps = 3'000'000;  // takes below half a second
constexpr double max_terms = 10'000;
constexpr double largest_bound = 1e15;  // i + 1 is another number

std::string why_undefined(const Node& node) {
    if (node.op == Op::Divide) return "a division by 0";
    if (node.op == Op::Mod) return "mod(a, 0)";
    if (node.op == Op::Where) return "its condition never holds";
    return std::string(op_info(node.op).spelling) + " outside its domain";
}

}  // namespace

bool Elaborator::divides_by_zero(const Node& node) const {
    if (node.op != Op::Divide && node.op != Op::Mod) return false;
    const auto& divisor = facts_[node.b].constant;
    return divisor && divisor->neg_lo == 0 && divisor->hi == 0;
}

std::nullopt_t Elaborator::fail(std::size_t offset, std::string reason, std::string hint) {
    if (!error_) error_ = ParseError{offset, std::move(reason), std::move(hint)};
    return std::nullopt;
}

Elaborator::Built Elaborator::done(NodeId id, std::size_t offset, bool condition) {
    if (builder_.size() > ProgramLimits::nodes) {
        return fail(offset, "the formula has more than " + std::to_string(ProgramLimits::nodes) +
                                " operations");
    }
    for (auto next = static_cast<NodeId>(facts_.size()); next < builder_.size(); ++next) {
        facts_.push_back(facts_of_node(builder_.node(next), facts_));
        const Node& node = builder_.node(next);
        if (refuses_undefined_ && (facts_.back().undefined || divides_by_zero(node))) {
            return fail(offset, "this is not a number: " + why_undefined(node));
        }
    }
    return Value{id, condition};
}

Elaborator::Built Elaborator::build(SyntaxId id, const Binding* scope) {
    struct Level {
        int& depth;
        explicit Level(int& d) : depth(d) { ++depth; }
        ~Level() { --depth; }
    };
    const Level level(depth_);
    const Syntax& syntax = tree_[id];
    if (depth_ > max_depth) return fail(syntax.offset, "the definitions are nested too deep");
    if (++steps_ > max_steps) {
        return fail(syntax.offset, "the sums and functions here ask for too many operations",
                    "use fewer terms");
    }
    switch (syntax.kind) {
        case SyntaxKind::Number: return literal(syntax);
        case SyntaxKind::Name: return name(syntax, scope);
        case SyntaxKind::Sum: return sum(syntax, scope);
        case SyntaxKind::Product: return product(syntax, scope);
        case SyntaxKind::Compare: return compare(syntax, scope);
        case SyntaxKind::And: return connected(syntax, Op::And, scope);
        case SyntaxKind::Or: return connected(syntax, Op::Or, scope);
        case SyntaxKind::Cases: return cases(syntax, scope);
        case SyntaxKind::Call: return call(syntax, scope);
        case SyntaxKind::Negate: {
            const Number a = number(syntax.operands[0], scope);
            return a ? done(make_negate(builder_, *a), syntax.offset) : std::nullopt;
        }
        case SyntaxKind::Not: {
            const Number a = condition(syntax.operands[0], scope);
            return a ? done(make_call(builder_, Op::Not, *a, 0), syntax.offset, true)
                     : std::nullopt;
        }
        case SyntaxKind::Power: {
            const Number a = number(syntax.operands[0], scope);
            const Number b = a ? number(syntax.operands[1], scope) : std::nullopt;
            return b ? done(make_power(builder_, *a, *b), syntax.offset) : std::nullopt;
        }
    }
    return std::nullopt;
}

Elaborator::Number Elaborator::number(SyntaxId id, const Binding* scope) {
    const Built value = build(id, scope);
    if (!value) return std::nullopt;
    if (!value->condition) return value->id;
    return fail(tree_[id].offset, "a comparison is no number", "use if(condition, a, b)");
}

Elaborator::Number Elaborator::condition(SyntaxId id, const Binding* scope) {
    const Built value = build(id, scope);
    if (!value) return std::nullopt;
    if (value->condition) return value->id;
    return fail(tree_[id].offset, "a condition is wanted here", "compare, for example z < 1");
}

Elaborator::Built Elaborator::literal(const Syntax& syntax) {
    const NumberEnclosure number = enclose_number(syntax.text);
    if (number.hi > largest_number) {
        return fail(syntax.offset, "the number " + quoted(syntax.text) + " is too large",
                    "stay below 1e300");
    }
    return done(builder_.constant(number.lo, number.hi), syntax.offset);
}

Elaborator::Built Elaborator::name(const Syntax& syntax, const Binding* scope) {
    for (const Binding* binding = scope; binding != nullptr; binding = binding->outer) {
        ++steps_;
        if (binding->name == syntax.text) return Value{binding->value, false};
    }
    if (const auto defined = definitions_.find(syntax.text); defined != definitions_.end()) {
        return defined_value(defined->second, syntax);
    }
    if (is_built_in_value(syntax.text)) return done(built_in(syntax.text)->id, syntax.offset);
    if (is_parameter_name(syntax.text)) return parameter(syntax.text, syntax.offset);
    return fail(syntax.offset, quoted(syntax.text) + " is not known",
                hint_for_unknown(syntax.text));
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
    return Value{value(), false};
}

Elaborator::Built Elaborator::parameter(const std::string& name, std::size_t offset) {
    const auto [entry, is_new] = parameter_index_.try_emplace(name, parameters_.size());
    if (is_new) {
        if (parameters_.size() == ProgramLimits::parameters) {
            return fail(offset, "there are more than " + std::to_string(ProgramLimits::parameters) +
                                    " parameters");
        }
        parameters_.push_back(name);
    }
    return done(builder_.variable(variable_w + 1 + static_cast<int>(entry->second)), offset);
}

Elaborator::Built Elaborator::defined_value(Definition& definition, const Syntax& syntax) {
    definition.used = true;
    if (definition.is_function) {
        std::string call = syntax.text + "(";
        for (const std::string& argument : definition.arguments)
            call += (call.ends_with('(') ? "" : ", ") + argument;
        return fail(syntax.offset, quoted(syntax.text) + " is a function", "type " + call + ")");
    }
    if (definition.value) return Value{*definition.value, false};
    if (definition.in_progress) {
        return fail(syntax.offset, quoted(syntax.text) + " is defined by itself");
    }
    definition.in_progress = true;
    definition.value = number(definition.body, nullptr);
    definition.in_progress = false;
    if (!definition.value) return std::nullopt;
    return Value{*definition.value, false};
}

Elaborator::Built Elaborator::sum(const Syntax& syntax, const Binding* scope) {
    Number total = number(syntax.operands[0], scope);
    for (std::size_t i = 1; total && i < syntax.operands.size(); ++i) {
        const Number term = number(syntax.operands[i], scope);
        if (!term) return std::nullopt;
        total = syntax.marks[i - 1] == '+' ? make_add(builder_, *total, *term)
                                           : make_subtract(builder_, *total, *term);
        if (!done(*total, tree_[syntax.operands[i]].offset)) return std::nullopt;
    }
    if (!total) return std::nullopt;
    return Value{*total, false};
}

Elaborator::Built Elaborator::product(const Syntax& syntax, const Binding* scope) {
    Number total = number(syntax.operands[0], scope);
    for (std::size_t i = 1; total && i < syntax.operands.size(); ++i) {
        const Number factor = number(syntax.operands[i], scope);
        if (!factor) return std::nullopt;
        total = syntax.marks[i - 1] == '*' ? make_multiply(builder_, *total, *factor)
                                           : make_divide(builder_, *total, *factor);
        if (!done(*total, tree_[syntax.operands[i]].offset)) return std::nullopt;
    }
    if (!total) return std::nullopt;
    return Value{*total, false};
}

/// a < b < c is a < b and b < c.
Elaborator::Built Elaborator::compare(const Syntax& syntax, const Binding* scope) {
    if (syntax.marks.contains('=')) {
        return fail(syntax.offset, "an equation stands alone, not inside a formula",
                    "compare with < <= > >=");
    }
    Number left = number(syntax.operands[0], scope);
    Number all;
    for (std::size_t i = 1; left && i < syntax.operands.size(); ++i) {
        const Number right = number(syntax.operands[i], scope);
        if (!right) return std::nullopt;
        const char mark = syntax.marks[i - 1];
        const Op op = mark == '<' || mark == '>' ? Op::Less : Op::LessEqual;
        const bool ascending = mark == '<' || mark == 'l';
        const NodeId one = ascending ? make_call(builder_, op, *left, *right)
                                     : make_call(builder_, op, *right, *left);
        all = all ? make_call(builder_, Op::And, *all, one) : one;
        if (!done(*all, syntax.offset)) return std::nullopt;
        left = right;
    }
    if (!left) return std::nullopt;
    return Value{*all, true};
}

Elaborator::Built Elaborator::connected(const Syntax& syntax, Op op, const Binding* scope) {
    Number all = condition(syntax.operands[0], scope);
    for (std::size_t i = 1; all && i < syntax.operands.size(); ++i) {
        const Number further = condition(syntax.operands[i], scope);
        if (!further) return std::nullopt;
        all = make_call(builder_, op, *all, *further);
        if (!done(*all, syntax.offset)) return std::nullopt;
    }
    if (!all) return std::nullopt;
    return Value{*all, true};
}

Elaborator::Built Elaborator::cases(const Syntax& syntax, const Binding* scope) {
    Number value;
    std::size_t i = syntax.operands.size();
    if (i % 2 == 1) {
        value = number(syntax.operands[--i], scope);
        if (!value) return std::nullopt;
    }
    for (; i >= 2; i -= 2) {
        const Number where = condition(syntax.operands[i - 2], scope);
        const Number there = where ? number(syntax.operands[i - 1], scope) : std::nullopt;
        if (!there) return std::nullopt;
        value = value ? make_call(builder_, Op::If, *where, *there, *value)
                      : make_call(builder_, Op::Where, *there, *where);
        if (!done(*value, syntax.offset)) return std::nullopt;
    }
    if (!value) return std::nullopt;
    return Value{*value, false};
}

Elaborator::Built Elaborator::call(const Syntax& syntax, const Binding* scope) {
    if (syntax.function == nullptr) return defined_call(syntax, scope);
    if (syntax.function->repeats()) return repeated(syntax, scope);
    const std::optional<Op> op = syntax.function->op;
    std::vector<NodeId> arguments;
    for (const SyntaxId id : syntax.operands) {
        const std::size_t place = arguments.size();
        const bool is_condition = (op == Op::If && place == 0) || (op == Op::Where && place == 1);
        const Number argument = is_condition ? condition(id, scope) : number(id, scope);
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
        const Binding binding{index.text, builder_.constant(i), scope};
        if (!done(binding.value, index.offset)) return std::nullopt;
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
    const auto defined = definitions_.find(syntax.text);
    if (defined == definitions_.end() || !defined->second.is_function) {
        return fail(syntax.offset, quoted(syntax.text) + " is not a function",
                    "define it, as in " + syntax.text + "(u, v) = u^2 + v^2");
    }
    Definition& definition = defined->second;
    definition.used = true;
    const std::size_t wanted = definition.arguments.size();
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
    if (definition.in_progress) {
        return fail(syntax.offset, quoted(syntax.text) + " is defined by itself",
                    "write the terms out, or use sum or prod");
    }
    const Number value = function_value(definition, arguments);
    if (!value) return std::nullopt;
    return Value{*value, false};
}

std::size_t Elaborator::CallHash::operator()(const Call& call) const {
    std::size_t hash = std::hash<const Definition*>()(call.first);
    for (const NodeId argument : call.second) {
        hash = (hash ^ argument) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

Elaborator::Number Elaborator::function_value(Definition& definition,
                                              const std::vector<NodeId>& arguments) {
    const auto [known, is_new] = calls_.try_emplace(Call{&definition, arguments}, 0);
    if (!is_new) return known->second;
    std::vector<Binding> scope;
    scope.reserve(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        scope.push_back({definition.arguments[i], arguments[i], i == 0 ? nullptr : &scope[i - 1]});
    }
    definition.in_progress = true;
    const Number value = number(definition.body, scope.empty() ? nullptr : &scope.back());
    definition.in_progress = false;
    if (value) known->second = *value;
    return value;
}

}  // namespace zeroset
