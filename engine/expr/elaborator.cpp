// From a text's statements to surfaces.

#include "engine/expr/elaborator.hpp"

#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/expr/words.hpp"

#include <algorithm>
#include <set>

namespace zeroset {
namespace {

constexpr std::size_t first_argument =
    ProgramLimits::parameters;                     // numbers of functions' arguments, as parameters
constexpr std::size_t longest_definition = 2'000;  // as a reading

bool is_free(std::string_view name) {
    return !is_built_in_value(name) && find_function(name) == nullptr;
}

}  // namespace

/// `name = ...` or `name(a, b) = ...`, unless a restriction makes it a surface.
std::optional<Elaborator::Definition> Elaborator::definition_in(std::size_t index) const {
    const StatementSyntax& statement = tree_.statements[index];
    const Syntax& relation = tree_[statement.relation];
    if (relation.kind != SyntaxKind::Compare || relation.marks != "=") return std::nullopt;
    if (!statement.restrictions.empty()) return std::nullopt;
    const Syntax& left = tree_[relation.operands[0]];
    Definition definition;
    definition.statement = index;
    definition.body = relation.operands[1];
    if (left.kind == SyntaxKind::Name && is_free(left.text)) return definition;
    if (left.kind != SyntaxKind::Call || left.function != nullptr) return std::nullopt;
    definition.is_function = true;
    for (const SyntaxId argument : left.operands) {
        if (tree_[argument].kind != SyntaxKind::Name) return std::nullopt;
        definition.arguments.push_back(tree_[argument].text);
    }
    return definition;
}

/// The first definition of a name counts; a later `name = ...` is an equation.
bool Elaborator::find_definitions() {
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        const auto definition = definition_in(i);
        if (!definition) continue;
        const Syntax& relation = tree_[tree_.statements[i].relation];
        const Syntax& left = tree_[relation.operands[0]];
        std::set<std::string_view> names;
        for (const SyntaxId argument : left.operands) {
            const Syntax& name = tree_[argument];
            if (names.insert(name.text).second) continue;
            fail(name.offset, "two arguments are called " + quoted(name.text));
            return false;
        }
        definitions_.try_emplace(left.text, *definition);
    }
    return true;
}

std::expected<Program, ParseError> Elaborator::program() {
    if (!find_definitions() || !build_statements()) return std::unexpected(*error_);
    if (surfaces_.empty()) {
        return std::unexpected(
            ParseError{tree_.statements.back().offset, "there is no surface yet, only definitions",
                       "type an equation such as x^2 + y^2 + z^2 = 1 on the next line", true});
    }
    return result();
}

std::expected<Expr, ParseError> Elaborator::formula() {
    if (tree_.statements.size() > 1) {
        fail(tree_.statements[1].offset, "there is a second statement", "type one formula");
        return std::unexpected(*error_);
    }
    refuses_undefined_ = false;
    const Number root = equation(tree_.statements.front());
    if (!root) return std::unexpected(*error_);
    return builder_.finish(*root, parameters_);
}

std::expected<Expr, ParseError> Elaborator::last_value() {
    if (!find_definitions()) return std::unexpected(*error_);
    const StatementSyntax& statement = tree_.statements.back();
    const Syntax& syntax = tree_[statement.relation];
    const bool relates = syntax.kind == SyntaxKind::Compare || syntax.kind == SyntaxKind::And ||
                         syntax.kind == SyntaxKind::Or || syntax.kind == SyntaxKind::Not;
    if (relates || !statement.restrictions.empty()) {
        fail(statement.offset, "an expression is needed here, no equation and no condition",
             "type a value such as x^2 + y^2");
        return std::unexpected(*error_);
    }
    const Number root = number(statement.relation, nullptr);
    if (!root) return std::unexpected(*error_);
    return builder_.finish(*root, parameters_);
}

bool Elaborator::build_statements() {
    std::map<std::size_t, std::pair<const std::string, Definition>*> defining;
    for (auto& entry : definitions_)
        defining.emplace(entry.second.statement, &entry);
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        if (!defining.contains(i) && !build_surface(i)) return false;
    }
    // Functions before values: they tell which values are used.
    for (const bool functions : {true, false}) {
        for (const auto& [statement, entry] : defining) {
            if (entry->second.is_function != functions) continue;
            if (!build_definition(entry->first, entry->second)) return false;
        }
    }
    return true;
}

bool Elaborator::build_surface(std::size_t index) {
    const Number root = equation(tree_.statements[index]);
    return root && add_surface(index, *root);
}

Elaborator::Number Elaborator::equation(const StatementSyntax& statement) {
    const Syntax& relation = tree_[statement.relation];
    Number f;
    if (relation.kind == SyntaxKind::Compare && relation.marks == "=") {
        const Number left = number(relation.operands[0], nullptr);
        const Number right = left ? number(relation.operands[1], nullptr) : std::nullopt;
        if (!right) return std::nullopt;
        f = make_subtract(builder_, *left, *right);
        if (!done(*f, relation.offset)) return std::nullopt;
    } else if (relation.kind == SyntaxKind::Compare && relation.marks.contains('=')) {
        return fail(relation.offset, "an equation and an inequality in one",
                    "put the inequality behind a comma: x^2 + y^2 = 1, z < 1");
    } else if (relation.kind == SyntaxKind::Compare || relation.kind == SyntaxKind::And ||
               relation.kind == SyntaxKind::Or || relation.kind == SyntaxKind::Not) {
        return fail(relation.offset, "a condition alone is no surface",
                    "type = for its boundary, or put it behind a surface and a comma: "
                    "x^2 + y^2 = 1, z < 1");
    } else {
        f = number(statement.relation, nullptr);
    }
    if (!f) return std::nullopt;
    return restricted(*f, statement);
}

Elaborator::Number Elaborator::restricted(NodeId f, const StatementSyntax& statement) {
    Number all;
    for (const SyntaxId id : statement.restrictions) {
        const Syntax& syntax = tree_[id];
        if (syntax.kind == SyntaxKind::Compare && syntax.marks.contains('=')) {
            return fail(syntax.offset, "behind a comma stands an inequality, not an equation",
                        "for a second surface type ';' instead of the comma");
        }
        const Number one = condition(id, nullptr);
        if (!one) return std::nullopt;
        all = all ? make_call(builder_, Op::And, *all, *one) : *one;
        if (!done(*all, syntax.offset)) return std::nullopt;
    }
    if (!all) return f;
    const Facts& facts = facts_[*all];
    if (refuses_undefined_ && facts.constant && facts.constant->hi <= 0) {
        return fail(tree_[statement.restrictions.front()].offset, "this never holds");
    }
    return make_call(builder_, Op::Where, f, *all);
}

bool Elaborator::uses_space(NodeId root) const { return !facts_[root].uniform; }

bool Elaborator::add_surface(std::size_t statement, NodeId root) {
    const std::size_t offset = tree_.statements[statement].offset;
    const Node& top = builder_.node(root);
    if (!uses_space(top.op == Op::Where ? top.a : root)) {
        const bool capital = parameter_index_.contains("X") || parameter_index_.contains("Y") ||
                             parameter_index_.contains("Z");
        fail(offset, "there is no x, y or z in it, so it is no surface",
             capital ? "write them as small letters"
                     : "type an equation such as x^2 + y^2 + z^2 = 1");
        return false;
    }
    if (surfaces_.size() == ProgramLimits::surfaces) {
        fail(offset,
             "there are more than " + std::to_string(ProgramLimits::surfaces) + " surfaces");
        return false;
    }
    surfaces_.push_back({statement, root});
    return true;
}

/// A value that has x, y or z in it and is not used is the equation of a surface: c = x^2 + y^2.
bool Elaborator::build_definition(const std::string& name, Definition& definition) {
    const std::size_t offset = tree_.statements[definition.statement].offset;
    if (definition.is_function) {
        const auto text = function_text(name, definition);
        if (text) readings_[definition.statement] = {StatementKind::Function, offset, *text};
        return text.has_value();
    }
    const bool used = definition.used;
    const Syntax& relation = tree_[tree_.statements[definition.statement].relation];
    if (!defined_value(definition, tree_[relation.operands[0]])) return false;
    if (!used && is_parameter_name(name) && uses_space(*definition.value)) {
        const Built letter = parameter(name, offset);
        if (!letter) return false;
        const NodeId f = make_subtract(builder_, letter->id, *definition.value);
        return done(f, offset) && add_surface(definition.statement, f);
    }
    const std::string value = builder_.text(*definition.value, parameters_, longest_definition);
    readings_[definition.statement] = {StatementKind::Value, offset, name + " = " + value};
    return true;
}

/// The function's reading, its arguments taken as parameters of their own.
std::optional<std::string> Elaborator::function_text(const std::string& name,
                                                     Definition& definition) {
    std::vector<NodeId> arguments;
    std::string text = name + "(";
    for (const std::string& argument : definition.arguments) {
        const std::size_t number = first_argument + arguments.size();
        arguments.push_back(builder_.variable(variable_w + 1 + static_cast<int>(number)));
        text += (text.ends_with('(') ? "" : ", ") + argument;
    }
    const std::size_t offset = tree_.statements[definition.statement].offset;
    if (!arguments.empty() && !done(arguments.back(), offset)) return std::nullopt;
    const Number value = function_value(definition, arguments);
    if (!value) return std::nullopt;
    std::vector<std::string> names = parameters_;
    names.resize(first_argument);
    names.insert(names.end(), definition.arguments.begin(), definition.arguments.end());
    return text + ") = " + builder_.text(*value, names, longest_definition);
}

std::expected<Program, ParseError> Elaborator::result() {
    std::ranges::sort(surfaces_, {}, &Surface::statement);
    Program program;
    std::size_t nodes = 0;
    // A text of many surfaces shares the time for the readings.
    const std::size_t longest = std::min<std::size_t>(longest_text, 1'000'000 / surfaces_.size());
    for (const Surface& surface : surfaces_) {
        Expr expr = builder_.finish(surface.root, parameters_);
        nodes += expr.nodes().size();
        if (nodes > ProgramLimits::nodes) {
            fail(tree_.statements[surface.statement].offset,
                 "the surfaces up to here have more than " + std::to_string(ProgramLimits::nodes) +
                     " operations");
            return std::unexpected(*error_);
        }
        readings_[surface.statement] = {StatementKind::Surface,
                                        tree_.statements[surface.statement].offset,
                                        equation_text(expr, longest)};
        program.surfaces.push_back(std::move(expr));
    }
    for (auto& [statement, reading] : readings_)
        program.readings.push_back(std::move(reading));
    program.parameters = std::move(parameters_);
    return program;
}

}  // namespace zeroset
