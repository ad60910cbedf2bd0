#include "engine/rewrite/polynomial/polynomial_form.hpp"

#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <optional>

namespace zeroset {
namespace {

bool is_exactly(const Interval<double>& a, double value) {
    return a.neg_lo == -value && a.hi == value;
}

class FormWriter {
public:
    FormWriter(ExprBuilder& builder, std::span<const NodeId> atoms, const PolynomialForm& form)
        : builder_(builder), atoms_(atoms), form_(form) {}

    NodeId write(const Polynomial& p) {
        if (p.is_constant()) return write_constant(builder_, p.at_zero());
        if (form_.style == PolynomialForm::Style::Terms || p.terms().size() == 1) {
            return write_terms(p);
        }
        if (form_.split) {
            if (const auto sum = write_split(p)) return *sum;
        }
        return write_nested(p);
    }

private:
    NodeId write_terms(const Polynomial& p) {
        std::optional<NodeId> sum;
        for (const Term& term : p.terms())
            sum = added(sum, Polynomial::of({term}), &FormWriter::write_term);
        return *sum;
    }

    NodeId write_term(const Polynomial& p) {
        const Term term = p.terms().front();
        if (term.monomial == 0) return write_constant(builder_, term.coefficient);
        std::optional<NodeId> product;
        for (const int atom : form_.order) {
            const int exponent = exponent_of(term.monomial, atom);
            if (exponent == 0) continue;
            const NodeId power = write_power(builder_, node_of(atom), exponent);
            product = product ? make_multiply(builder_, *product, power) : power;
        }
        return write_scaled(builder_, *product, term.coefficient);
    }

    /// The parts in one atom each, what is mixed, the constant; unless p is but one part.
    std::optional<NodeId> write_split(const Polynomial& p) {
        const unsigned all = p.atoms();
        Polynomial mixed = p.part([](Monomial m) { return m != 0; });
        std::optional<NodeId> sum;
        for (const int atom : form_.order) {
            const unsigned bit = 1U << static_cast<unsigned>(atom);
            if (all == bit) return std::nullopt;
            if ((all & bit) == 0) continue;
            const Polynomial alone = mixed.part(
                [=](Monomial m) { return m == monomial_of(atom, exponent_of(m, atom)); });
            if (alone.is_zero()) continue;
            mixed = mixed - alone;
            sum = added(sum, alone, &FormWriter::write_nested);
        }
        if (!sum) return std::nullopt;
        sum = added(sum, mixed, &FormWriter::write_nested);
        return added(sum, Polynomial::constant(p.at_zero()), &FormWriter::write_nested);
    }

    NodeId write_nested(const Polynomial& p) {
        if (p.is_constant() || p.terms().size() == 1) return write_term(p);
        const unsigned all = p.atoms();
        const int atom = *std::ranges::find_if(form_.order, [all](int candidate) {
            return ((all >> static_cast<unsigned>(candidate)) & 1U) != 0;
        });
        if (form_.style == PolynomialForm::Style::Squares) {
            if (const auto sum = write_square(p, atom)) return *sum;
        }
        return write_horner(p, atom);
    }

    std::optional<NodeId> write_square(const Polynomial& p, int atom) {
        const auto square = complete_square(p, atom);
        if (!square || square->root.terms().size() == 1) return std::nullopt;
        const NodeId root = write_nested(square->root);
        const NodeId squared =
            write_scaled(builder_, make_multiply(builder_, root, root), square->factor);
        return added(squared, square->rest, &FormWriter::write_nested);
    }

    NodeId write_horner(const Polynomial& p, int atom) {
        const auto coefficients = p.coefficients(atom);
        const auto& [exponent, lowest] = coefficients.back();
        if (exponent != 0) {
            const NodeId rest = write_nested(shifted(p, atom, -exponent));
            return make_multiply(builder_, write_power(builder_, node_of(atom), exponent), rest);
        }
        const Polynomial rest = p.part([=](Monomial m) { return exponent_of(m, atom) != 0; });
        return *added(write_nested(rest), lowest, &FormWriter::write_nested);
    }

    /// sum + p, p written by `writer`; p with a negative leading coefficient is subtracted.
    std::optional<NodeId> added(std::optional<NodeId> sum, const Polynomial& p,
                                NodeId (FormWriter::*writer)(const Polynomial&)) {
        if (p.is_zero()) return sum;
        if (!sum) return (this->*writer)(p);
        const bool negative = p.terms().front().coefficient.hi < 0;
        return add_term(builder_, *sum, (this->*writer)(negative ? -p : p), negative);
    }

    [[nodiscard]] NodeId node_of(int atom) const { return atoms_[static_cast<std::size_t>(atom)]; }

    ExprBuilder& builder_;
    std::span<const NodeId> atoms_;
    const PolynomialForm& form_;
};

}  // namespace

NodeId write_polynomial(ExprBuilder& builder, std::span<const NodeId> atoms, const Polynomial& p,
                        const PolynomialForm& form) {
    return FormWriter(builder, atoms, form).write(p);
}

NodeId add_term(ExprBuilder& builder, NodeId sum, NodeId term, bool negative) {
    return negative ? make_subtract(builder, sum, term) : make_add(builder, sum, term);
}

NodeId write_power(ExprBuilder& builder, NodeId node, int exponent) {
    return make_power(builder, node, builder.constant(exponent));
}

NodeId write_scaled(ExprBuilder& builder, NodeId node, const Interval<double>& factor) {
    if (is_exactly(factor, 1.0)) return node;
    if (is_exactly(factor, -1.0)) return make_negate(builder, node);
    return make_multiply(builder, write_constant(builder, factor), node);
}

NodeId write_constant(ExprBuilder& builder, const Interval<double>& value) {
    return builder.constant(-value.neg_lo, value.hi);
}

}  // namespace zeroset
