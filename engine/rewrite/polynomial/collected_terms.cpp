#include "engine/algebra/graph_facts.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/polynomial/polynomial.hpp"
#include "engine/rewrite/polynomial/polynomial_candidates.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"
#include "engine/rewrite/sample/form_sample.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Shorter formulas are left to `tightened`.
constexpr std::size_t least_nodes = 500;
constexpr std::size_t most_nodes_collected = 20'000;
constexpr std::size_t most_new_nodes = 8'000;
/// Ways that are measured, at most: those that are estimated to take the least time.
constexpr std::size_t most_measured = 6;
/// A way pays if it is estimated to take less than this share of the time.
constexpr double clearly = 0.7;

/// The ways to write the whole formula as a polynomial in its variables.
std::vector<Expr> ways_to_write(const Expr& expr) {
    const UpwardRounding upward;
    const std::vector<Facts> facts = facts_of(expr);
    const Expansion expansion = expand(expr, facts);
    const auto is_variable = [&](NodeId id) { return expr.node(id).op == Op::Variable; };
    if (!expansion.of[expr.root()] || !std::ranges::all_of(expansion.atoms, is_variable)) return {};
    ExprBuilder builder;
    std::vector<NodeId> now(expr.nodes().size(), 0);
    for (const NodeId atom : expansion.atoms)
        now[atom] = builder.variable(expr.node(atom).number);
    const auto names = expr.parameters();
    std::vector<Expr> result;
    for (const NodeId root :
         polynomial_candidates(builder, {.expr = expr, .facts = facts, .expansion = expansion}, now,
                               expr.root(), most_new_nodes))
        result.push_back(builder.finish(root, {names.begin(), names.end()}));
    return result;
}

}  // namespace

Expr with_collected_terms(const Expr& expr, const SampleRegion& region) {
    if (expr.nodes().size() < least_nodes || expr.nodes().size() > most_nodes_collected)
        return expr;
    const double most = clearly * time_of_cell(expr);
    struct Way {
        Expr form;
        double time;
    };
    std::vector<Way> ways;
    for (Expr& form : ways_to_write(expr)) {
        const double time = time_of_cell(form);
        if (time <= most) ways.push_back({.form = std::move(form), .time = time});
    }
    if (ways.empty()) return expr;
    std::ranges::sort(ways, {}, &Way::time);
    ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(std::min(ways.size(), most_measured)),
               ways.end());
    const FormSample sample(ways.front().form, region);
    const auto measured = [&](const Way& way) { return way.time * sample.open(way.form); };
    return std::ranges::min_element(ways, {}, measured)->form;
}

}  // namespace zeroset
