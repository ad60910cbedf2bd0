#include "engine/rewrite/polynomial/polynomial_candidates.hpp"

#include "engine/expr/simplify.hpp"
#include "engine/rewrite/polynomial/polynomial_form.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

// Where the forms come from: the expanded polynomial, the same in x^2 + y^2 instead of x, and the
// sum as typed with its squares completed.

namespace zeroset {
namespace {

// Shared subexpressions may make exponentially many summands.
constexpr std::size_t most_in_sum = 64;

/// factor * base^exponent.
struct Summand {
    Interval<double> factor;
    NodeId base;
    int exponent;
};

/// The summands of a sum as typed, its constants added up.
struct Sum {
    std::vector<Summand> summands;
    Interval<double> constant{.neg_lo = 0.0, .hi = 0.0};
};

void collect_summands(const AnalysedExpr& graph, NodeId id, const Interval<double>& factor,
                      Sum& sum) {
    if (sum.summands.size() > most_in_sum) return;
    const Node& node = graph.expr.node(id);
    const auto constant = [&](NodeId operand) { return graph.facts[operand].constant; };
    if (constant(id)) {
        sum.constant = sum.constant + factor * *constant(id);
    } else if (node.op == Op::Add || node.op == Op::Subtract) {
        collect_summands(graph, node.a, factor, sum);
        collect_summands(graph, node.b, node.op == Op::Add ? factor : -factor, sum);
    } else if (node.op == Op::Negate) {
        collect_summands(graph, node.a, -factor, sum);
    } else if (node.op == Op::Multiply && constant(node.a)) {
        collect_summands(graph, node.b, factor * *constant(node.a), sum);
    } else if (node.op == Op::Multiply && constant(node.b)) {
        collect_summands(graph, node.a, factor * *constant(node.b), sum);
    } else if (node.op == Op::IntPower && node.number > 0) {
        sum.summands.push_back({.factor = factor, .base = node.a, .exponent = node.number});
    } else {
        sum.summands.push_back({.factor = factor, .base = id, .exponent = 1});
    }
}

bool is_usable(const Interval<double>& factor) {
    return Polynomial::constant(factor).is_certain() && !contains_zero(factor);
}

NodeId write_summand(ExprBuilder& builder, std::span<const NodeId> now, const Summand& summand,
                     bool negated) {
    const NodeId power = write_power(builder, now[summand.base], summand.exponent);
    return write_scaled(builder, power, negated ? -summand.factor : summand.factor);
}

/// k (u^m + c / (2k))^2 for k u^(2m) + c u^m; takes c^2 / (4k) from the constant.
NodeId write_completed(ExprBuilder& builder, std::span<const NodeId> now, const Summand& square,
                       const Summand& linear, bool negated, Interval<double>& constant) {
    const Interval<double> shift = scale(linear.factor / square.factor, 0.5);
    constant = constant - power(shift, 2, false) * square.factor;
    const NodeId power_node = write_power(builder, now[linear.base], linear.exponent);
    const bool negative = shift.hi < 0;
    const NodeId root =
        add_term(builder, power_node, write_constant(builder, negative ? -shift : shift), negative);
    return write_scaled(builder, make_multiply(builder, root, root),
                        negated ? -square.factor : square.factor);
}

/// The place of a summand that is not taken and makes, with `summand`, a square and its linear
/// term.
std::optional<std::size_t> partner_of(const Summand& summand, const std::vector<Summand>& summands,
                                      const std::vector<bool>& taken) {
    for (std::size_t i = 0; i < summands.size(); ++i) {
        const Summand& other = summands[i];
        if (taken[i] || other.base != summand.base) continue;
        if (other.exponent == 2 * summand.exponent || 2 * other.exponent == summand.exponent)
            return i;
    }
    return std::nullopt;
}

NodeId with_constant(ExprBuilder& builder, NodeId sum, const Interval<double>& constant) {
    if (constant.neg_lo == 0 && constant.hi == 0) return sum;
    const bool negative = constant.hi < 0;
    return add_term(builder, sum, write_constant(builder, negative ? -constant : constant),
                    negative);
}

std::optional<NodeId> with_completed_squares(ExprBuilder& builder, const AnalysedExpr& graph,
                                             std::span<const NodeId> now, NodeId id) {
    Sum sum;
    collect_summands(graph, id, point(1.0), sum);
    if (sum.summands.size() > most_in_sum) return std::nullopt;
    std::vector<bool> taken(sum.summands.size());
    std::optional<NodeId> result;
    bool completed = false;
    for (std::size_t i = 0; i < sum.summands.size(); ++i) {
        const Summand& summand = sum.summands[i];
        if (!is_usable(summand.factor)) return std::nullopt;
        if (taken[i]) continue;
        taken[i] = true;
        const auto partner = partner_of(summand, sum.summands, taken);
        const Summand& other = partner ? sum.summands[*partner] : summand;
        if (!is_usable(other.factor)) return std::nullopt;
        const bool is_square = !partner || summand.exponent > other.exponent;
        const Summand& leading = is_square ? summand : other;
        const bool subtracted = result && leading.factor.hi < 0;
        NodeId term{};
        if (!partner) {
            term = write_summand(builder, now, summand, subtracted);
        } else {
            const Summand& linear = is_square ? other : summand;
            taken[*partner] = true;
            term = write_completed(builder, now, leading, linear, subtracted, sum.constant);
            completed = true;
        }
        result = result ? add_term(builder, *result, term, subtracted) : term;
    }
    if (!completed) return std::nullopt;
    return with_constant(builder, *result, sum.constant);
}

/// A polynomial with the nodes of its atoms.
struct Substituted {
    Polynomial p;
    std::vector<NodeId> atoms;
};

/// p in s = a^2 + b^2 + ... (the atoms of `group`, of which p is even in the first) and all atoms
/// but the first; unless it has not fewer terms than before.
std::optional<Substituted> in_sum_of_squares(ExprBuilder& builder, const Polynomial& p,
                                             std::span<const NodeId> atoms,
                                             std::span<const int> group) {
    if (atoms.size() >= max_atoms) return std::nullopt;
    const int first = group.front();
    Polynomial square = Polynomial::atom(static_cast<int>(atoms.size()));  // of the first
    for (const int other : group.subspan(1)) {
        const Polynomial atom = Polynomial::atom(other);
        square = square - atom * atom;
    }
    Polynomial result;
    for (const auto& [exponent, factor] : p.coefficients(first)) {
        if (exponent % 2 != 0 || exponent > 12) return std::nullopt;
        Polynomial product = factor;
        for (int i = 0; i < exponent; i += 2)
            product = product * square;
        result = result + product;
    }
    if (result.terms().size() >= p.terms().size() || !result.is_certain()) return std::nullopt;
    std::optional<NodeId> sum;
    for (const int atom : group) {
        const NodeId power = write_power(builder, atoms[static_cast<std::size_t>(atom)], 2);
        sum = sum ? make_add(builder, *sum, power) : power;
    }
    Substituted substituted{.p = std::move(result), .atoms = {atoms.begin(), atoms.end()}};
    substituted.atoms.push_back(*sum);
    return substituted;
}

std::vector<int> atoms_of(const Polynomial& p) {
    std::vector<int> result;
    for (int atom = 0; atom < max_atoms; ++atom) {
        if (((p.atoms() >> static_cast<unsigned>(atom)) & 1U) != 0) result.push_back(atom);
    }
    return result;
}

/// p, and p in sums of two or three squares.
std::vector<Substituted> substitutions(ExprBuilder& builder, const Polynomial& p,
                                       std::span<const NodeId> atoms) {
    std::vector<Substituted> result{{.p = p, .atoms = {atoms.begin(), atoms.end()}}};
    const std::vector<int> occurring = atoms_of(p);
    const auto try_group = [&](std::initializer_list<int> group) {
        const std::span<const int> members(group.begin(), group.size());
        if (auto found = in_sum_of_squares(builder, p, atoms, members)) {
            result.push_back(std::move(*found));
        }
    };
    for (std::size_t i = 0; i < occurring.size(); ++i) {
        for (std::size_t j = i + 1; j < occurring.size(); ++j) {
            try_group({occurring[i], occurring[j]});
            for (std::size_t k = j + 1; k < occurring.size(); ++k)
                try_group({occurring[i], occurring[j], occurring[k]});
        }
    }
    return result;
}

/// All orders of few atoms, the rotations of many; the last one, if it stands for a sum, first.
std::vector<std::vector<int>> orders_of(std::vector<int> atoms) {
    std::vector<std::vector<int>> orders;
    const std::size_t count = atoms.size();
    if (count <= 3) {
        do {
            orders.push_back(atoms);
        } while (std::ranges::next_permutation(atoms).found);
        return orders;
    }
    for (std::size_t i = 0; i < count; ++i) {
        orders.push_back(atoms);
        std::ranges::rotate(atoms, atoms.begin() + 1);
    }
    return orders;
}

}  // namespace

std::vector<NodeId> polynomial_candidates(ExprBuilder& builder, const AnalysedExpr& graph,
                                          std::span<const NodeId> now, NodeId id,
                                          std::size_t max_new_nodes) {
    std::vector<NodeId> result;
    const std::size_t size_limit = builder.size() + max_new_nodes;
    if (const auto node = with_completed_squares(builder, graph, now, id)) result.push_back(*node);
    const std::optional<Polynomial>& p = graph.expansion.of[id];
    if (!p || !p->is_certain() || p->atoms() != graph.expansion.atoms_below[id]) return result;
    if (p->terms().size() > max_new_nodes) return result;

    std::vector<NodeId> atoms;
    atoms.reserve(graph.expansion.atoms.size());
    for (const NodeId atom : graph.expansion.atoms)
        atoms.push_back(now[atom]);
    const std::vector<Substituted> forms = substitutions(builder, *p, atoms);
    using Style = PolynomialForm::Style;
    constexpr std::array<std::pair<Style, bool>, 5> ways{{{Style::Squares, true},
                                                          {Style::Squares, false},
                                                          {Style::Horner, true},
                                                          {Style::Horner, false},
                                                          {Style::Terms, false}}};
    for (const auto& [style, split] : ways) {
        for (const Substituted& form : forms) {
            for (std::vector<int>& order : orders_of(atoms_of(form.p))) {
                if (builder.size() > size_limit) return result;
                result.push_back(
                    write_polynomial(builder, form.atoms, form.p,
                                     {.style = style, .split = split, .order = std::move(order)}));
                if (style == Style::Terms) break;
            }
        }
    }
    return result;
}

}  // namespace zeroset
