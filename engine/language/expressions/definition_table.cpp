#include "engine/language/expressions/definition_table.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace zeroset {
namespace {

bool is_axis(std::string_view name) { return name == "x" || name == "y" || name == "z"; }
bool is_polar(std::string_view name) { return is_place(name) && !is_axis(name); }

}  // namespace

DefinitionTable::DefinitionTable(const SyntaxTree& tree, std::size_t counted_end, Notes& notes)
    : tree_(tree), of_statement_(tree.statements.size(), none), places_(tree.statements.size()) {
    if (!read_definitions()) return;
    out_.assign(definitions_.size(), false);
    read_uses();
    count_uses(counted_end);
    choose_built_in();
    choose_levels();
    enter();
    note_definitions(notes);
}

/// The definition `name = ...` or `name(a, b) = ...` in a statement; with a restriction the
/// statement is a surface.
std::optional<Definition> DefinitionTable::definition_in(std::size_t index) const {
    const StatementSyntax& statement = tree_.statements[index];
    const Syntax& relation = tree_[statement.relation];
    if (relation.kind != SyntaxKind::Compare || relation.marks != "=") return std::nullopt;
    if (!statement.restrictions.empty()) return std::nullopt;
    const Syntax& left = tree_[relation.operands[0]];
    Definition definition{.name = left.text,
                          .statement = index,
                          .body = relation.operands[1],
                          .arguments = {},
                          .is_certain = statement.is_certain,
                          .called_with = {}};
    if (left.kind == SyntaxKind::Name && !is_axis(left.text)) return definition;
    if (left.kind != SyntaxKind::Call || left.function != nullptr) return std::nullopt;
    definition.is_function = true;
    for (const SyntaxId argument : left.operands) {
        if (tree_[argument].kind != SyntaxKind::Name) return std::nullopt;
        definition.arguments.push_back(tree_[argument].text);
    }
    return definition;
}

bool DefinitionTable::read_definitions() {
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        auto definition = definition_in(i);
        if (!definition || is_level_of_function(*definition)) continue;
        std::set<std::string_view> names;
        const Syntax& left = tree_[tree_[tree_.statements[i].relation].operands[0]];
        for (const SyntaxId argument : left.operands) {
            const Syntax& name = tree_[argument];
            if (names.insert(name.text).second) continue;
            error_ = {.offset = name.offset,
                      .reason = filled(tr("two arguments are called {0}"), {quoted(name.text)}),
                      .hint = {}};
            return false;
        }
        const auto index = static_cast<std::uint32_t>(definitions_.size());
        of_statement_[i] = index;
        if (definition->is_function) functions_[definition->name].push_back(index);
        definitions_.push_back(std::move(*definition));
    }
    return true;
}

/// Whether f(x, y) = 1 is an equation: f is already defined, its arguments are the variables, and
/// the right side does not depend on them.
bool DefinitionTable::is_level_of_function(const Definition& definition) const {
    if (!definition.is_function || definition.is_certain) return false;
    const auto known = functions_.find(definition.name);
    if (known == functions_.end()) return false;
    const bool of_variables = std::ranges::all_of(
        definition.arguments,
        [](const std::string& name) { return is_place(name) || name == "w" || name == "t"; });
    const Definition& last = definitions_[known->second.back()];
    if (!of_variables || definition.arguments.size() != last.arguments.size()) return false;
    return definition.arguments != last.arguments || !mentions_any_of(definition);
}

/// Whether a function's body uses its arguments or calls the function itself.
bool DefinitionTable::mentions_any_of(const Definition& definition) const {
    std::vector<SyntaxId> pending{definition.body};
    while (!pending.empty()) {
        const Syntax& syntax = tree_[pending.back()];
        pending.pop_back();
        const bool is_name = syntax.kind == SyntaxKind::Name || syntax.kind == SyntaxKind::Call;
        if (is_name && syntax.text == definition.name) return true;
        if (is_name &&
            std::ranges::find(definition.arguments, syntax.text) != definition.arguments.end())
            return true;
        pending.insert(pending.end(), syntax.operands.begin(), syntax.operands.end());
    }
    return false;
}

void DefinitionTable::read_uses() {
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        first_use_.push_back(uses_.size());
        const StatementSyntax& statement = tree_.statements[i];
        Bound bound;
        if (of_statement_[i] != none) {
            const Definition& definition = definitions_[of_statement_[i]];
            for (const std::string& argument : definition.arguments)
                ++bound[argument];
            collect_uses(definition.body, bound);
            continue;
        }
        collect_uses(statement.relation, bound);
        for (const SyntaxId restriction : statement.restrictions)
            collect_uses(restriction, bound);
    }
    first_use_.push_back(uses_.size());
}

void DefinitionTable::collect_uses(SyntaxId id, Bound& bound) {
    const Syntax& syntax = tree_[id];
    if (syntax.kind == SyntaxKind::Earlier) return;
    const bool calls = syntax.kind == SyntaxKind::Call && syntax.function == nullptr;
    const auto is_bound = [&] {
        const auto count = bound.find(syntax.text);
        return count != bound.end() && count->second > 0;
    };
    if (calls || (syntax.kind == SyntaxKind::Name && !is_bound()))
        uses_.push_back({.at = id, .calls = calls});
    if (syntax.kind == SyntaxKind::Let) {
        collect_uses(syntax.operands[0], bound);
        ++bound[syntax.text];
        collect_uses(syntax.operands[1], bound);
        --bound[syntax.text];
        return;
    }
    const bool iterates = syntax.function != nullptr && syntax.function->iterates();
    if (iterates && tree_[syntax.operands[0]].kind == SyntaxKind::Name) {
        const std::string_view name = tree_[syntax.operands[0]].text;
        collect_uses(syntax.operands[1], bound);
        collect_uses(syntax.operands[2], bound);
        ++bound[name];
        collect_uses(syntax.operands[3], bound);
        --bound[name];
        return;
    }
    const bool repeats = syntax.function != nullptr && syntax.function->repeats() &&
                         syntax.operands.size() > 1 &&
                         tree_[syntax.operands[1]].kind == SyntaxKind::Name;
    const std::string_view index = repeats ? tree_[syntax.operands[1]].text : std::string_view();
    if (repeats) ++bound[index];
    for (const SyntaxId operand : syntax.operands)
        collect_uses(operand, bound);
    if (repeats) --bound[index];
}

/// Counts the uses of each defined name in statements that do not define it.
void DefinitionTable::count_uses(std::size_t counted_end) {
    for (const Definition& definition : definitions_)
        counts_.try_emplace(definition.name, 0);
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        if (tree_.statements[i].offset >= counted_end) break;
        const std::string_view own =
            of_statement_[i] == none ? std::string_view() : definitions_[of_statement_[i]].name;
        for (const NameUse& use : uses(i)) {
            const std::string_view name = tree_[use.at].text;
            if (use.calls || name == own) continue;
            if (const auto count = counts_.find(name); count != counts_.end()) ++count->second;
        }
    }
}

bool DefinitionTable::is_used(std::string_view name) const {
    const auto count = counts_.find(name);
    return count != counts_.end() && count->second > 0;
}

/// Keeps the definition of a built-in name only where another statement uses the name and the value
/// does not depend on r, rho, theta or phi; else the statement is an equation.
void DefinitionTable::choose_built_in() {
    for (std::size_t i = 0; i < definitions_.size(); ++i) {
        const Definition& definition = definitions_[i];
        out_[i] = !definition.is_function && is_built_in_value(definition.name) &&
                  !definition.is_certain && !is_used(definition.name);
    }
    for (bool changes = true; std::exchange(changes, false);) {
        enter();
        find_places();
        for (std::size_t i = 0; i < definitions_.size(); ++i) {
            const Definition& definition = definitions_[i];
            const bool chosen = !out_[i] && !definition.is_function && !definition.is_certain &&
                                is_built_in_value(definition.name);
            if (!chosen || !places_[definition.statement].polar) continue;
            out_[i] = true;
            changes = true;
        }
    }
}

/// Makes an equation of a letter's unused value that depends on the point: c = x^2 + y^2.
void DefinitionTable::choose_levels() {
    for (std::size_t i = 0; i < definitions_.size(); ++i) {
        const Definition& definition = definitions_[i];
        if (out_[i] || definition.is_function || definition.is_certain) continue;
        const SyntaxKind kind = tree_[definition.body].kind;
        const Places& places = places_[definition.statement];
        out_[i] = is_parameter_name(definition.name) && !is_built_in_value(definition.name) &&
                  !is_used(definition.name) && !is_condition(kind) &&
                  (places.axes || places.polar) && !is_bundle(definition.body);
    }
}

/// Whether an expression is seen to be a vector or a list: one that is written out, a definition of
/// such, or a sum or product of it.
bool DefinitionTable::is_bundle(SyntaxId root) {
    constexpr int most_looked_at = 1000;
    std::vector<SyntaxId> pending{root};
    for (int looked_at = 0; !pending.empty() && looked_at < most_looked_at; ++looked_at) {
        const Syntax& syntax = tree_[pending.back()];
        pending.pop_back();
        if (syntax.kind == SyntaxKind::Vector || syntax.kind == SyntaxKind::Items) return true;
        const bool is_joined = syntax.kind == SyntaxKind::Sum ||
                               syntax.kind == SyntaxKind::Product ||
                               syntax.kind == SyntaxKind::Negate;
        if (is_joined)
            pending.insert(pending.end(), syntax.operands.begin(), syntax.operands.end());
        const bool calls = syntax.kind == SyntaxKind::Call && syntax.function == nullptr;
        if (!calls && syntax.kind != SyntaxKind::Name) continue;
        const Lists& lists = calls ? functions_ : values_;
        if (const auto known = lists.find(syntax.text); known != lists.end())
            pending.push_back(definitions_[known->second.back()].body);
    }
    return false;
}

/// Fills the tables of definitions by name.
void DefinitionTable::enter() {
    values_.clear();
    functions_.clear();
    for (std::uint32_t i = 0; i < definitions_.size(); ++i) {
        const Definition& definition = definitions_[i];
        if (out_[i]) continue;
        (definition.is_function ? functions_ : values_)[definition.name].push_back(i);
    }
}

/// Finds which statements depend on the point, directly or by the names they use.
void DefinitionTable::find_places() {
    std::vector<std::vector<std::uint32_t>> users(
        definitions_.size());  // statements that use each definition
    std::vector<std::size_t> changed;
    std::ranges::fill(places_, Places{});
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        for (const NameUse& use : uses(i)) {
            const std::string_view name = tree_[use.at].text;
            if (const Definition* const definition = meant(use, i)) {
                const auto index = static_cast<std::size_t>(definition - definitions_.data());
                users[index].push_back(static_cast<std::uint32_t>(i));
            } else if (!use.calls) {
                places_[i].axes = places_[i].axes || is_axis(name);
                places_[i].polar = places_[i].polar || is_polar(name);
            }
        }
        if (places_[i] != Places{}) changed.push_back(i);
    }
    while (!changed.empty()) {
        const std::size_t statement = changed.back();
        changed.pop_back();
        const std::uint32_t index = of_statement_[statement];
        if (index == none) continue;
        for (const std::uint32_t user : users[index]) {
            const Places before = places_[user];
            places_[user].axes = before.axes || places_[statement].axes;
            places_[user].polar = before.polar || places_[statement].polar;
            if (places_[user] != before) changed.push_back(user);
        }
    }
}

std::set<const Definition*> DefinitionTable::going_by(std::span<const std::string> names) {
    std::vector<std::vector<std::size_t>> users(
        definitions_.size());  // statements that use each definition
    std::vector<std::size_t> pending;
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        if (of_statement(i) == nullptr) continue;
        for (const NameUse& use : uses(i)) {
            if (const Definition* const used = meant(use, i)) {
                users[static_cast<std::size_t>(used - definitions_.data())].push_back(i);
            } else if (!use.calls && std::ranges::find(names, tree_[use.at].text) != names.end()) {
                pending.push_back(i);
            }
        }
    }
    std::set<const Definition*> found;
    while (!pending.empty()) {
        const Definition* const user = of_statement(pending.back());
        pending.pop_back();
        if (!found.insert(user).second) continue;
        const auto& further = users[static_cast<std::size_t>(user - definitions_.data())];
        pending.insert(pending.end(), further.begin(), further.end());
    }
    return found;
}

void DefinitionTable::note_definitions(Notes& notes) const {
    note_repetitions(values_, notes);
    note_repetitions(functions_, notes);
    if (tree_.statements.size() < 2) return;
    for (std::uint32_t i = 0; i < definitions_.size(); ++i) {
        const std::string& name = definitions_[i].name;
        if (!out_[i] || is_built_in_value(name)) continue;
        notes.add(
            offset_of(i),
            filled(tr("nothing else uses {0}, so this is a surface; to define it alone type {1}"),
                   {name, name + " := ..."}));
    }
}

/// Notes names that are defined twice or are those of a built-in function.
void DefinitionTable::note_repetitions(const Lists& lists, Notes& notes) const {
    for (const auto& [name, indices] : lists) {
        for (std::size_t k = 1; k < indices.size(); ++k) {
            notes.add(
                offset_of(indices[k]),
                filled(tr("{0} is defined again: it means this from here on and in all surfaces"),
                       {quoted(name)}));
        }
        const Function* const function = find_function(name);
        const bool is_value = &lists == &values_;
        if (function == nullptr || (is_value && (function->is_of_library() || function->is_word())))
            continue;
        if (function->is_special() && function->name != name) continue;  // letters, as W
        notes.add(offset_of(indices[0]),
                  filled(tr("{0} is what this line defines, not the built-in function"), {name}));
    }
}

Definition* DefinitionTable::of_statement(std::size_t statement) {
    const std::uint32_t index = of_statement_[statement];
    return index == none || out_[index] ? nullptr : &definitions_[index];
}

std::span<const NameUse> DefinitionTable::uses(std::size_t statement) const {
    const std::size_t begin = first_use_[statement];
    return std::span(uses_).subspan(begin, first_use_[statement + 1] - begin);
}

Definition* DefinitionTable::meant(const NameUse& use, std::size_t statement) {
    return found(use.calls ? functions_ : values_, tree_[use.at].text, statement);
}

Definition* DefinitionTable::found(Lists& lists, std::string_view name, std::size_t statement) {
    const auto list = lists.find(name);
    if (list == lists.end()) return nullptr;
    const std::vector<std::uint32_t>& indices = list->second;
    Definition& last = definitions_[indices.back()];
    if (of_statement(statement) == nullptr) return &last;
    const auto from = std::ranges::lower_bound(
        indices, statement, {}, [&](std::uint32_t index) { return definitions_[index].statement; });
    if (from != indices.begin()) return &definitions_[*std::prev(from)];
    // In its own first definition a built-in name keeps its meaning.
    const bool is_own = last.statement == statement && is_built_in_value(name);
    return is_own ? nullptr : &last;
}

}  // namespace zeroset
