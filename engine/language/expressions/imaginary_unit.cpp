#include "engine/language/expressions/imaginary_unit.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Goes through the expressions of a text, and from names to their definitions.
class ComplexSearch {
public:
    ComplexSearch(const SyntaxTree& tree, DefinitionTable& table) : tree_(tree), table_(table) {}

    bool run() {
        for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
            const StatementSyntax& statement = tree_.statements[i];
            push({.id = statement.relation, .statement = i, .in_modulus = false});
            for (const SyntaxId id : statement.restrictions)
                push({.id = id, .statement = i, .in_modulus = false});
        }
        while (!pending_.empty()) {
            const Visit visit = pending_.back();
            pending_.pop_back();
            if (is_complex(visit)) return true;
        }
        return false;
    }

private:
    struct Visit {
        SyntaxId id;
        std::size_t statement;
        bool in_modulus;
    };

    void push(const Visit& visit) {
        if (seen_.emplace(visit.id, visit.in_modulus).second) pending_.push_back(visit);
    }
    void push_operands(const Visit& visit, bool in_modulus) {
        for (const SyntaxId id : tree_[visit.id].operands)
            push({.id = id, .statement = visit.statement, .in_modulus = in_modulus});
    }
    /// Goes on in a definition, unless an argument of it has the name.
    void push_definition(const Definition* definition) {
        if (definition == nullptr || std::ranges::any_of(definition->arguments, [](const auto& a) {
                return may_be_imaginary_unit(a);
            }))
            return;
        push({.id = definition->body, .statement = definition->statement, .in_modulus = true});
    }

    /// Looks at one expression; what is in it waits its turn.
    bool is_complex(const Visit& visit) {
        const Syntax& syntax = tree_[visit.id];
        const Function* const function = syntax.function;
        if (function != nullptr && function->is_of_complex()) return true;
        if (function != nullptr && function->repeats() && syntax.operands.size() > 1 &&
            may_be_imaginary_unit(tree_[syntax.operands[1]].text))
            return false;
        if (visit.in_modulus) {
            const bool sums = syntax.kind == SyntaxKind::Sum && adds_imaginary(syntax, visit);
            if (sums || turns(syntax, visit)) return true;
            if (syntax.kind == SyntaxKind::Name)
                push_definition(table_.value(syntax.text, visit.statement));
            if (syntax.kind == SyntaxKind::Call && function == nullptr)
                push_definition(table_.function(syntax.text, visit.statement));
        }
        const bool is_modulus = function != nullptr &&
                                (function->op == Op::Abs || function->composed == Composed::Length);
        push_operands(visit, visit.in_modulus || is_modulus);
        return false;
    }
    /// Whether a summand has i as a factor, and another one has not.
    [[nodiscard]] bool adds_imaginary(const Syntax& sum, const Visit& visit) {
        const auto count = std::ranges::count_if(
            sum.operands, [&](SyntaxId id) { return has_factor(tree_[id], visit); });
        return count > 0 && count < std::ssize(sum.operands);
    }
    /// Whether it is e^(i x) or exp(i x).
    [[nodiscard]] bool turns(const Syntax& syntax, const Visit& visit) {
        const bool is_power = syntax.kind == SyntaxKind::Power &&
                              tree_[syntax.operands[0]].kind == SyntaxKind::Name &&
                              tree_[syntax.operands[0]].text == "e";
        if (is_power) return has_factor(tree_[syntax.operands[1]], visit);
        const bool is_exp = syntax.function != nullptr && syntax.function->op == Op::Exp;
        return is_exp && has_factor(tree_[syntax.operands[0]], visit);
    }
    [[nodiscard]] bool has_factor(const Syntax& term, const Visit& visit) {
        const auto is_unit = [&](const Syntax& syntax) {
            return syntax.kind == SyntaxKind::Name && may_be_imaginary_unit(syntax.text) &&
                   table_.value(syntax.text, visit.statement) == nullptr;
        };
        if (term.kind == SyntaxKind::Negate) return has_factor(tree_[term.operands[0]], visit);
        return term.kind == SyntaxKind::Product &&
               std::ranges::any_of(term.operands, [&](SyntaxId id) { return is_unit(tree_[id]); });
    }

    const SyntaxTree& tree_;
    DefinitionTable& table_;
    std::vector<Visit> pending_;
    std::set<std::pair<SyntaxId, bool>> seen_;
};

}  // namespace

bool may_be_imaginary_unit(std::string_view name) { return name == "i" || name == "I"; }

bool has_complex_numbers(const SyntaxTree& tree, DefinitionTable& table) {
    return ComplexSearch(tree, table).run();
}

}  // namespace zeroset
