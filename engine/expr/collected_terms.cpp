#include "engine/expr/collected_terms.hpp"

#include "engine/expr/form_sample.hpp"
#include "engine/expr/polynomial.hpp"
#include "engine/expr/polynomial_candidates.hpp"
#include "engine/expr/tighten.hpp"
#include "engine/num/rounding.hpp"

#include <algorithm>
#include <vector>

namespace zeroset {
namespace {

/// Of shorter ones `tightened` knows better.
constexpr std::size_t least_nodes = 500;
constexpr std::size_t most_nodes = 20'000;
constexpr std::size_t most_new_nodes = 8'000;
/// Those that take the least time are measured.
constexpr std::size_t most_measured = 6;
/// What is estimated to take less than this share of the time surely does.
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
         polynomial_candidates(builder, {expr, facts, expansion}, now, expr.root(), most_new_nodes))
        result.push_back(builder.finish(root, {names.begin(), names.end()}));
    return result;
}

}  // namespace

Expr with_collected_terms(const Expr& expr, const SampleRegion& region) {
    if (expr.nodes().size() < least_nodes || expr.nodes().size() > most_nodes) return expr;
    std::vector<Expr> ways = ways_to_write(expr);
    const double time = time_of_cell(expr);
    std::erase_if(ways, [&](const Expr& way) { return time_of_cell(way) > clearly * time; });
    if (ways.empty()) return expr;
    std::ranges::sort(ways, {}, [](const Expr& way) { return time_of_cell(way); });
    ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(std::min(ways.size(), most_measured)),
               ways.end());
    const FormSample sample(ways.front(), region);
    return *std::ranges::min_element(
        ways, {}, [&](const Expr& way) { return time_of_cell(way) * sample.open(way); });
}

}  // namespace zeroset
