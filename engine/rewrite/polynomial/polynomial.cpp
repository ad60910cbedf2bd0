#include "engine/rewrite/polynomial/polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

// Larger polynomials cost more than they may gain.
constexpr std::size_t max_terms = 300;
constexpr std::size_t max_products = 12'000;
constexpr int max_degree = 40;

bool is_zero(const Interval<double>& a) { return a.neg_lo == 0 && a.hi == 0; }

}  // namespace

Polynomial Polynomial::of(std::vector<Term> terms) {
    std::ranges::sort(terms, std::ranges::greater{}, &Term::monomial);
    Polynomial result;
    for (const Term& term : terms) {
        if (!result.terms_.empty() && result.terms_.back().monomial == term.monomial) {
            Interval<double>& sum = result.terms_.back().coefficient;
            sum = sum + term.coefficient;
        } else {
            result.terms_.push_back(term);
        }
    }
    std::erase_if(result.terms_,
                  [](const Term& term) { return zeroset::is_zero(term.coefficient); });
    return result;
}

bool Polynomial::is_constant() const {
    return terms_.empty() || (terms_.size() == 1 && terms_.front().monomial == 0);
}

Interval<double> Polynomial::at_zero() const {
    if (terms_.empty() || terms_.back().monomial != 0) return {.neg_lo = 0.0, .hi = 0.0};
    return terms_.back().coefficient;
}

unsigned Polynomial::atoms() const {
    Monomial all = 0;
    for (const Term& term : terms_)
        all |= term.monomial;
    unsigned mask = 0;
    for (int atom = 0; atom < max_atoms; ++atom)
        mask |= exponent_of(all, atom) != 0 ? 1U << static_cast<unsigned>(atom) : 0U;
    return mask;
}

int Polynomial::degree(int atom) const {
    int degree = 0;
    for (const Term& term : terms_)
        degree = std::max(degree, exponent_of(term.monomial, atom));
    return degree;
}

int Polynomial::degree() const {
    int degree = 0;
    for (const Term& term : terms_) {
        int sum = 0;
        for (int atom = 0; atom < max_atoms; ++atom)
            sum += exponent_of(term.monomial, atom);
        degree = std::max(degree, sum);
    }
    return degree;
}

bool Polynomial::is_finite() const {
    return std::ranges::all_of(terms_, [](const Term& term) {
        return std::isfinite(term.coefficient.neg_lo) && std::isfinite(term.coefficient.hi);
    });
}

bool Polynomial::is_certain() const {
    return is_finite() && std::ranges::none_of(terms_, [](const Term& term) {
               return contains_zero(term.coefficient);
           });
}

std::vector<Coefficient> Polynomial::coefficients(int atom) const {
    std::vector<Coefficient> result;
    for (int exponent = degree(atom); exponent >= 0; --exponent) {
        const Polynomial factor =
            part([=](Monomial m) { return exponent_of(m, atom) == exponent; });
        if (factor.is_zero()) continue;
        result.emplace_back(exponent, shifted(factor, atom, -exponent));
    }
    return result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    std::vector<Term> terms(a.terms().begin(), a.terms().end());
    terms.insert(terms.end(), b.terms().begin(), b.terms().end());
    return Polynomial::of(std::move(terms));
}

Polynomial operator-(const Polynomial& a) {
    std::vector<Term> terms(a.terms().begin(), a.terms().end());
    for (Term& term : terms)
        term.coefficient = -term.coefficient;
    return Polynomial::of(std::move(terms));
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + (-b); }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    std::vector<Term> terms;
    terms.reserve(a.terms().size() * b.terms().size());
    for (const Term& left : a.terms()) {
        for (const Term& right : b.terms()) {
            terms.push_back({.monomial = left.monomial + right.monomial,
                             .coefficient = left.coefficient * right.coefficient});
        }
    }
    return Polynomial::of(std::move(terms));
}

Polynomial scaled(const Polynomial& a, const Interval<double>& factor) {
    return a * Polynomial::constant(factor);
}

Polynomial divided(const Polynomial& a, const Interval<double>& divisor) {
    std::vector<Term> terms(a.terms().begin(), a.terms().end());
    for (Term& term : terms)
        term.coefficient = term.coefficient / divisor;
    return Polynomial::of(std::move(terms));
}

Polynomial shifted(const Polynomial& a, int atom, int exponent) {
    std::vector<Term> terms(a.terms().begin(), a.terms().end());
    const Monomial step = monomial_of(atom, std::abs(exponent));
    for (Term& term : terms)
        term.monomial = exponent < 0 ? term.monomial - step : term.monomial + step;
    return Polynomial::of(std::move(terms));
}

std::optional<CompletedSquare> complete_square(const Polynomial& p, int atom) {
    const int degree = p.degree(atom);
    if (degree == 0 || degree % 2 != 0) return std::nullopt;
    const auto half = static_cast<std::size_t>(degree / 2);
    std::vector<Polynomial> in(2 * half + 1);
    for (Coefficient& coefficient : p.coefficients(atom))
        in[static_cast<std::size_t>(coefficient.first)] = std::move(coefficient.second);
    if (!in.back().is_constant() || !in.back().is_certain()) return std::nullopt;

    const Interval<double> factor = in.back().at_zero();
    std::vector<Polynomial> root(half + 1);
    root[half] = Polynomial::constant(point(1.0));
    // The coefficient of root^2 at `exponent`, of what is known of root.
    const auto squared = [&](std::size_t exponent) {
        Polynomial sum;
        for (std::size_t i = exponent > half ? exponent - half : 0; i <= std::min(exponent, half);
             ++i)
            sum = sum + root[i] * root[exponent - i];
        return sum;
    };
    for (std::size_t j = half; j-- > 0;) {
        const Polynomial missing = divided(in[half + j], factor) - squared(half + j);
        root[j] = scaled(missing, point(0.5));
    }
    CompletedSquare result{.factor = factor, .root = {}, .rest = {}};
    for (std::size_t j = 0; j <= half; ++j) {
        const int exponent = static_cast<int>(j);
        result.root = result.root + shifted(root[j], atom, exponent);
        // At `half` and above, both sides agree in the reals.
        if (j == half) continue;
        const Polynomial left = in[j] - scaled(squared(j), factor);
        result.rest = result.rest + shifted(left, atom, exponent);
    }
    if (!result.root.is_certain() || !result.rest.is_certain()) return std::nullopt;
    return result;
}

bool is_polynomial_operator(const Expr& expr, std::span<const Facts> facts, NodeId id) {
    const Node& node = expr.node(id);
    if (facts[id].constant) return false;
    if (node.op == Op::Divide) {
        return facts[node.b].constant && !contains_zero(*facts[node.b].constant);
    }
    return node.op == Op::Negate || node.op == Op::Add || node.op == Op::Subtract ||
           node.op == Op::Multiply || (node.op == Op::IntPower && node.number > 0);
}

namespace {

using Expanded = std::optional<Polynomial>;

Expanded limited(Polynomial p) {
    if (p.terms().size() > max_terms || p.degree() > max_degree || !p.is_finite())
        return std::nullopt;
    return p;
}

class Expander {
public:
    Expanded expanded(const Node& node, const Expanded& a, const Expanded& b) {
        if (!a || !b) return std::nullopt;
        if (node.op == Op::Negate) return -*a;
        if (node.op == Op::Add) return limited(*a + *b);
        if (node.op == Op::Subtract) return limited(*a - *b);
        if (node.op == Op::Multiply) return product_of(*a, *b);
        if (node.op == Op::IntPower) return power_of(*a, node.number);
        return limited(divided(*a, b->at_zero()));
    }

private:
    Expanded product_of(const Polynomial& a, const Polynomial& b) {
        const std::size_t products = a.terms().size() * b.terms().size();
        if (products > products_left_ || a.degree() + b.degree() > max_degree) return std::nullopt;
        products_left_ -= products;
        return limited(a * b);
    }

    Expanded power_of(const Polynomial& a, int n) {
        if (n > max_degree) return std::nullopt;
        Expanded result = a;
        for (int i = 1; result && i < n; ++i)
            result = product_of(*result, a);
        return result;
    }

    std::size_t products_left_ = max_products;
};

/// Nodes that polynomials are made of, constants aside.
std::vector<bool> polynomial_operands(const Expr& expr, std::span<const Facts> facts) {
    std::vector<bool> result(expr.nodes().size());
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (!is_polynomial_operator(expr, facts, id)) continue;
        const Node& node = expr.node(id);
        result[node.a] = true;
        if (op_info(node.op).arity == 2) result[node.b] = true;
    }
    return result;
}

}  // namespace

Expansion expand(const Expr& expr, std::span<const Facts> facts) {
    const std::size_t size = expr.nodes().size();
    Expansion result{
        .atoms = {}, .of = std::vector<Expanded>(size), .atoms_below = std::vector<unsigned>(size)};
    const std::vector<bool> operand = polynomial_operands(expr, facts);
    Expander expander;
    for (NodeId id = 0; id < size; ++id) {
        const Node& node = expr.node(id);
        if (facts[id].constant) {
            result.of[id] = Polynomial::constant(*facts[id].constant);
        } else if (is_polynomial_operator(expr, facts, id)) {
            const NodeId b = op_info(node.op).arity == 2 ? node.b : node.a;
            result.of[id] = expander.expanded(node, result.of[node.a], result.of[b]);
            result.atoms_below[id] = result.atoms_below[node.a] | result.atoms_below[b];
        } else if (operand[id] && result.atoms.size() < max_atoms) {
            const auto index = static_cast<int>(result.atoms.size());
            result.atoms.push_back(id);
            result.of[id] = Polynomial::atom(index);
            result.atoms_below[id] = 1U << static_cast<unsigned>(index);
        }
    }
    return result;
}

}  // namespace zeroset
