#include "tests/support/oracle/polynomial_oracle.hpp"

#include "engine/expr/exact.hpp"
#include "tests/support/oracle/flint_polynomial.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace zeroset::test {

FlintRational::FlintRational(double exact) : FlintRational() {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(exact, &exponent), 53);
    fmpq_set_si(value_, static_cast<slong>(mantissa), 1);
    exponent -= 53;
    const auto shift = static_cast<flint_bitcnt_t>(std::abs(exponent));
    if (exponent >= 0) {
        fmpq_mul_2exp(value_, value_, shift);
    } else {
        fmpq_div_2exp(value_, value_, shift);
    }
}

RationalPolynomial RationalPolynomial::linear(const FlintRational& first,
                                              const FlintRational& second) {
    RationalPolynomial result;
    fmpq_poly_set_coeff_fmpq(result.get(), 0, first.get());
    fmpq_poly_set_coeff_fmpq(result.get(), 1, second.get());
    return result;
}

namespace {

std::optional<RationalPolynomial> constant(const Node& node) {
    ExprBuilder builder;
    const auto value = exact_fraction(builder, builder.constant(node.lo, node.hi));
    RationalPolynomial result;
    if (node.lo == node.hi) {
        fmpq_poly_set_fmpq(result.get(), FlintRational(node.lo).get());
    } else if (value) {
        FlintRational fraction;
        fmpq_set_si(fraction.get(), value->p, static_cast<ulong>(value->q));
        fmpq_poly_set_fmpq(result.get(), fraction.get());
    } else {
        return std::nullopt;
    }
    return result;
}

/// The operator's polynomial; nullopt where the operator does not make one.
std::optional<RationalPolynomial> applied(const Node& node, const RationalPolynomial& a,
                                          const RationalPolynomial& b) {
    RationalPolynomial result;
    if (node.op == Op::Negate) {
        fmpq_poly_neg(result.get(), a.get());
    } else if (node.op == Op::Add) {
        fmpq_poly_add(result.get(), a.get(), b.get());
    } else if (node.op == Op::Subtract) {
        fmpq_poly_sub(result.get(), a.get(), b.get());
    } else if (node.op == Op::Multiply) {
        fmpq_poly_mul(result.get(), a.get(), b.get());
    } else if (node.op == Op::IntPower && node.number >= 0) {
        fmpq_poly_pow(result.get(), a.get(), static_cast<ulong>(node.number));
    } else if (node.op == Op::Divide && b.is_number() && !b.is_zero()) {
        FlintRational divisor;
        fmpq_poly_get_coeff_fmpq(divisor.get(), b.get(), 0);
        fmpq_poly_scalar_div_fmpq(result.get(), a.get(), divisor.get());
    } else {
        return std::nullopt;
    }
    return result;
}

/// The polynomial of f with a polynomial for each variable; nullopt where there is none.
std::optional<RationalPolynomial> composed(const Expr& expr,
                                           std::span<const RationalPolynomial> variables) {
    std::vector<RationalPolynomial> values;
    for (const Node& node : expr.nodes()) {
        std::optional<RationalPolynomial> value;
        if (node.op == Op::Constant) {
            value = constant(node);
        } else if (node.op == Op::Variable) {
            value = variables[static_cast<std::size_t>(node.number)];
        } else {
            value = applied(node, values[node.a], values[node.b]);
        }
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values.back();
}

std::vector<RationalPolynomial> with_uniforms(std::vector<RationalPolynomial> variables,
                                              std::span<const double> uniforms) {
    for (const double value : uniforms)
        variables.push_back(RationalPolynomial::linear(FlintRational(value), FlintRational()));
    return variables;
}

/// Isolates the roots in (0, 1) of a polynomial without multiple roots, in intervals of 2^-depth.
class Isolation {
public:
    struct Root {
        double from, to;
    };

    explicit Isolation(std::size_t most) : most_(most) {}

    /// Searches a part of (0, 1): `p` over (0, 1) is the polynomial over (place, place + 1)
    /// 2^-depth.
    void search(const IntegerPolynomial& p, double place, int depth) {
        const int changes = sign_changes(p);
        if (changes == 0 || roots_.size() >= most_) return;
        if (changes == 1 && depth >= finest) {
            roots_.push_back({std::ldexp(place, -depth), std::ldexp(place + 1, -depth)});
            return;
        }
        IntegerPolynomial half = lower_half(p);
        search(half, 2 * place, depth + 1);
        fmpz_poly_taylor_shift(half.get(), half.get(), FlintOne().get());
        if (fmpz_is_zero(half.get()->coeffs) != 0) {
            const double middle = std::ldexp(2 * place + 1, -depth - 1);
            if (roots_.size() < most_) roots_.push_back({middle, middle});
            fmpz_poly_shift_right(half.get(), half.get(), 1);
        }
        search(half, 2 * place + 1, depth + 1);
    }

    [[nodiscard]] std::span<const Root> roots() const { return roots_; }

private:
    static constexpr int finest = 32;

    struct FlintOne : FlintInteger {
        FlintOne() { fmpz_one(get()); }
    };

    /// Number of sign changes in the coefficients of (1 + t)^n p(1 / (1 + t)): at least the number
    /// of roots in (0, 1), and equal to it where it is 0 or 1.
    static int sign_changes(const IntegerPolynomial& p) {
        IntegerPolynomial q;
        fmpz_poly_reverse(q.get(), p.get(), p.degree() + 1);
        fmpz_poly_taylor_shift(q.get(), q.get(), FlintOne().get());
        int changes = 0;
        int last = 0;
        for (long i = 0; i <= q.degree(); ++i) {
            const int sign = fmpz_sgn(q.get()->coeffs + i);
            if (sign * last < 0) ++changes;
            if (sign != 0) last = sign;
        }
        return changes;
    }
    /// The polynomial 2^n p(t / 2).
    static IntegerPolynomial lower_half(const IntegerPolynomial& p) {
        IntegerPolynomial half = p;
        const long degree = p.degree();
        for (long i = 0; i < degree; ++i) {
            fmpz* const coefficient = half.get()->coeffs + i;
            fmpz_mul_2exp(coefficient, coefficient, static_cast<flint_bitcnt_t>(degree - i));
        }
        return half;
    }

    std::size_t most_;
    std::vector<Root> roots_;
};

/// A polynomial with the roots of f, each a single one.
IntegerPolynomial without_multiple_roots(const RationalPolynomial& f) {
    IntegerPolynomial p;
    fmpq_poly_get_numerator(p.get(), f.get());
    IntegerPolynomial slope;
    fmpz_poly_derivative(slope.get(), p.get());
    IntegerPolynomial common;
    fmpz_poly_gcd(common.get(), p.get(), slope.get());
    if (common.degree() > 0) fmpz_poly_div(p.get(), p.get(), common.get());
    return p;
}

/// The sign of f at a number.
int sign_at(const RationalPolynomial& f, double at) {
    FlintRational value;
    fmpq_poly_evaluate_fmpq(value.get(), f.get(), FlintRational(at).get());
    return fmpq_sgn(value.get());
}

}  // namespace

std::optional<PolynomialOracle> PolynomialOracle::of(const Expr& expr,
                                                     std::span<const double> uniforms) {
    // Take a line on which no coordinate, and no polynomial of them, is constant by chance.
    const RationalPolynomial t =
        RationalPolynomial::linear(FlintRational(0.6180339887), FlintRational(0.7320508));
    const RationalPolynomial u =
        RationalPolynomial::linear(FlintRational(0.4142135623), FlintRational(-1.2360679));
    const RationalPolynomial v =
        RationalPolynomial::linear(FlintRational(-0.302775637), FlintRational(1.6457513));
    if (!composed(expr, with_uniforms({t, u, v}, uniforms))) return std::nullopt;
    return PolynomialOracle(expr, uniforms);
}

std::optional<std::vector<RayRoot>> PolynomialOracle::roots(const RayQuestion& ray,
                                                            std::size_t most) const {
    // Substitute x(s) = eye + direction (outer_from + s (outer_to - outer_from)), s from 0 to 1.
    const FlintRational from(ray.outer_from);
    FlintRational length(ray.outer_to);
    fmpq_sub(length.get(), length.get(), from.get());
    std::vector<RationalPolynomial> variables;
    for (std::size_t i = 0; i < 3; ++i) {
        const FlintRational step(ray.direction.at(i));
        FlintRational start(ray.eye.at(i));
        fmpq_addmul(start.get(), step.get(), from.get());
        FlintRational whole;
        fmpq_mul(whole.get(), step.get(), length.get());
        variables.push_back(RationalPolynomial::linear(start, whole));
    }
    const auto f = composed(expr_, with_uniforms(std::move(variables), uniforms_));
    if (!f || f->is_zero()) return std::nullopt;
    const IntegerPolynomial p = without_multiple_roots(*f);
    Isolation isolation(most);
    isolation.search(p, 0.0, 0);
    std::vector<RayRoot> result;
    for (const auto& [lo, hi] : isolation.roots()) {
        const double span = ray.outer_to - ray.outer_from;
        const double rounding = 0x1p-50 * (std::abs(ray.outer_from) + span);
        const bool crosses = lo != hi && sign_at(*f, lo) * sign_at(*f, hi) < 0;
        result.push_back({ray.outer_from + lo * span - rounding,
                          ray.outer_from + hi * span + rounding, crosses});
    }
    return result;
}

RayAnswer PolynomialOracle::answer(const RayQuestion& ray) const {
    const auto found = roots(ray, 1);
    if (!found) return {};
    if (found->empty()) return {RayTruth::Empty, 0.0, 0.0, false};
    return hit_between(ray, found->front().from, found->front().to, found->front().crosses);
}

}  // namespace zeroset::test
