#pragma once

#include "engine/expr/expr.hpp"
#include "engine/rewrite/polynomial/polynomial.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// A way to write a polynomial.
struct PolynomialForm {
    enum class Style : std::uint8_t {
        Terms,    ///< a sum of terms
        Horner,   ///< c + v^k (c + v^m (...)), the powers of v as far apart as they are
        Squares,  ///< a (v^k + ...)^2 + rest where the leading coefficient a is a number
    };
    Style style = Style::Terms;
    bool split = false;      ///< what depends on one atom only is written apart
    std::vector<int> order;  ///< of the atoms, the outermost first; all that occur
};

/// The node that computes p in this form; `atoms` are nodes of `builder`. In upward rounding.
NodeId write_polynomial(ExprBuilder& builder, std::span<const NodeId> atoms, const Polynomial& p,
                        const PolynomialForm& form);

/// sum + term, by a subtraction if `negative`.
NodeId add_term(ExprBuilder& builder, NodeId sum, NodeId term, bool negative);

/// node^exponent; 1 or more.
NodeId write_power(ExprBuilder& builder, NodeId node, int exponent);

/// The node times the number, which is not 0.
NodeId write_scaled(ExprBuilder& builder, NodeId node, const Interval<double>& factor);

NodeId write_constant(ExprBuilder& builder, const Interval<double>& value);

}  // namespace zeroset
