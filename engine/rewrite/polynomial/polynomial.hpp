#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/expr.hpp"
#include "engine/num/interval.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace zeroset {

/// Polynomials are in up to this many atoms: variables and subexpressions that are no polynomials.
inline constexpr int max_atoms = 8;

/// The exponents of a product of atoms, eight bits each, atom 0 in the lowest.
using Monomial = std::uint64_t;

constexpr Monomial monomial_of(int atom, int exponent) {
    return static_cast<Monomial>(exponent) << (8 * atom);
}
constexpr int exponent_of(Monomial monomial, int atom) {
    return static_cast<int>((monomial >> (8 * atom)) & 0xFFU);
}

struct Term {
    Monomial monomial = 0;
    Interval<double> coefficient{};  ///< encloses the real coefficient; exact where it is a double
};

class Polynomial;
/// A power of an atom with what it is multiplied by.
using Coefficient = std::pair<int, Polynomial>;

/// A sum of terms with real coefficients, known by enclosures. Like all of Interval, it must be
/// computed with in upward rounding.
class Polynomial {
public:
    Polynomial() = default;
    static Polynomial constant(const Interval<double>& value) {
        return of({{.monomial = 0, .coefficient = value}});
    }
    static Polynomial atom(int index) {
        return of(
            {{.monomial = monomial_of(index, 1), .coefficient = {.neg_lo = -1.0, .hi = 1.0}}});
    }
    /// Sums up equal monomials.
    static Polynomial of(std::vector<Term> terms);

    /// Distinct monomials, the highest first. A term of which it is known that it is 0 is not
    /// there.
    [[nodiscard]] std::span<const Term> terms() const { return terms_; }
    [[nodiscard]] bool is_zero() const { return terms_.empty(); }
    [[nodiscard]] bool is_constant() const;
    /// The constant term.
    [[nodiscard]] Interval<double> at_zero() const;
    /// Bit k is set if atom k occurs.
    [[nodiscard]] unsigned atoms() const;
    /// The largest exponent of one atom.
    [[nodiscard]] int degree(int atom) const;
    [[nodiscard]] int degree() const;
    [[nodiscard]] bool is_finite() const;
    /// Whether all coefficients are finite and of known sign.
    [[nodiscard]] bool is_certain() const;
    /// The coefficients as a polynomial in one atom, falling exponents; none of them is zero.
    [[nodiscard]] std::vector<Coefficient> coefficients(int atom) const;
    /// The terms for which `keep(monomial)` holds.
    template <class Keep>
    [[nodiscard]] Polynomial part(Keep keep) const {
        Polynomial result;
        for (const Term& term : terms_) {
            if (keep(term.monomial)) result.terms_.push_back(term);
        }
        return result;
    }

private:
    std::vector<Term> terms_;
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
Polynomial scaled(const Polynomial& a, const Interval<double>& factor);
/// `divisor` is not 0.
Polynomial divided(const Polynomial& a, const Interval<double>& divisor);
/// The product with atom^exponent; a negative exponent must divide every term.
Polynomial shifted(const Polynomial& a, int atom, int exponent);

/// p = factor * root^2 + rest with a lower degree of rest in the atom than of root.
struct CompletedSquare {
    Interval<double> factor;
    Polynomial root;
    Polynomial rest;
};

/// For p of even degree in the atom whose leading coefficient is a number.
std::optional<CompletedSquare> complete_square(const Polynomial& p, int atom);

/// A graph's nodes, expanded.
struct Expansion {
    std::vector<NodeId> atoms;                  ///< nodes that the polynomials are made of
    std::vector<std::optional<Polynomial>> of;  ///< of each node, unless it is too large
    std::vector<unsigned> atoms_below;          ///< the atoms that a polynomial node is made of
};

/// `facts` are those of `expr`. In upward rounding.
Expansion expand(const Expr& expr, std::span<const Facts> facts);

/// Whether a node is made of its operands by ring operations, a constant divisor being one.
bool is_polynomial_operator(const Expr& expr, std::span<const Facts> facts, NodeId id);

}  // namespace zeroset
