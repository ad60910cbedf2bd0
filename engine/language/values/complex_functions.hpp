#pragma once

#include "engine/expr/expr.hpp"

#include <optional>

namespace zeroset {

/// A complex number: re + i im. Where im is the constant 0 it is real.
struct ComplexNodes {
    NodeId re;
    NodeId im;
};

/// Functions of complex numbers as pairs of real formulas; of several values the principal one.
class ComplexFunctions {
public:
    explicit ComplexFunctions(ExprBuilder& builder) : builder_(builder) {}

    [[nodiscard]] bool is_real(const ComplexNodes& a) const { return is_zero(a.im); }
    NodeId modulus(const ComplexNodes& a);
    /// From -pi to pi.
    NodeId argument(const ComplexNodes& a);

    ComplexNodes negative(const ComplexNodes& a);
    ComplexNodes sum(const ComplexNodes& a, const ComplexNodes& b);
    ComplexNodes difference(const ComplexNodes& a, const ComplexNodes& b);
    ComplexNodes product(const ComplexNodes& a, const ComplexNodes& b);
    ComplexNodes quotient(const ComplexNodes& a, const ComplexNodes& b);
    ComplexNodes power(const ComplexNodes& a, const ComplexNodes& b);
    ComplexNodes logarithm(const ComplexNodes& a);
    /// A function of op.def; nothing of one that is none of complex numbers.
    std::optional<ComplexNodes> call(Op function, const ComplexNodes& a);

private:
    [[nodiscard]] bool is_zero(NodeId id) const;
    NodeId number(double value) { return builder_.constant(value); }
    NodeId times(NodeId a, NodeId b);
    /// The length of length (cos t + i sin t), where a is so written.
    std::optional<NodeId> polar_length(const ComplexNodes& a);
    NodeId squares(const ComplexNodes& a);
    /// i a and -i a.
    ComplexNodes turned(const ComplexNodes& a) { return {.re = minus(a.im), .im = a.re}; }
    ComplexNodes turned_back(const ComplexNodes& a) { return {.re = a.im, .im = minus(a.re)}; }
    NodeId minus(NodeId a);
    ComplexNodes real(double value) { return {.re = number(value), .im = number(0.0)}; }
    ComplexNodes whole_power(const ComplexNodes& a, int n);
    ComplexNodes by_binomials(const ComplexNodes& a, int n);
    ComplexNodes polar(NodeId length, NodeId angle);
    ComplexNodes exponential(const ComplexNodes& a);
    ComplexNodes square_root(const ComplexNodes& a);
    ComplexNodes sine(const ComplexNodes& a);
    ComplexNodes cosine(const ComplexNodes& a);
    ComplexNodes tangent(const ComplexNodes& a);
    ComplexNodes cotangent(const ComplexNodes& a) { return quotient(real(1.0), tangent(a)); }
    ComplexNodes hyperbolic_sine(const ComplexNodes& a) { return turned_back(sine(turned(a))); }
    ComplexNodes hyperbolic_cosine(const ComplexNodes& a) { return cosine(turned(a)); }
    ComplexNodes hyperbolic_tangent(const ComplexNodes& a) {
        return turned_back(tangent(turned(a)));
    }
    ComplexNodes arc_sine(const ComplexNodes& a);
    ComplexNodes arc_cosine(const ComplexNodes& a);
    ComplexNodes arc_tangent(const ComplexNodes& a) { return turned_back(area_tangent(turned(a))); }
    ComplexNodes area_sine(const ComplexNodes& a);
    ComplexNodes area_cosine(const ComplexNodes& a);
    ComplexNodes area_tangent(const ComplexNodes& a);

    ExprBuilder& builder_;
};

}  // namespace zeroset
