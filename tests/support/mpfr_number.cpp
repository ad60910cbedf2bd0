#include "tests/support/mpfr_number.hpp"

#include "tests/support/sample_field.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace zeroset::test {
namespace {

template <class Function>
MpfrNumber computed(Function function, const MpfrNumber& a) {
    MpfrNumber result;
    function(result.get(), a.get(), MPFR_RNDN);
    return result;
}

template <class Function>
MpfrNumber computed(Function function, const MpfrNumber& a, const MpfrNumber& b) {
    MpfrNumber result;
    function(result.get(), a.get(), b.get(), MPFR_RNDN);
    return result;
}

Reference defined(MpfrNumber value) { return {true, std::move(value)}; }
Reference undefined() { return {}; }
Reference unknown() { return {true, MpfrNumber()}; }  // a new number is NaN

/// Whether `a` is beyond any double, where periodic functions would need gigabytes of pi.
bool out_of_reach(const MpfrNumber& a) {
    constexpr mpfr_exp_t limit = 5000;
    if (mpfr_zero_p(a.get()) != 0) return false;
    const mpfr_exp_t exponent = mpfr_get_exp(a.get());
    return exponent > limit || exponent < -limit;
}

Reference quotient(const MpfrNumber& a, const MpfrNumber& b) {
    return b.sign() == 0 ? undefined() : defined(a / b);
}

Reference exponential(const MpfrNumber& a) {
    MpfrNumber result = computed(mpfr_exp, a);
    if (result.sign() == 0) return unknown();  // the true value is above 0
    return defined(std::move(result));
}

/// Whether `a` is in [-1, 1], or in (-1, 1) for `open`.
bool within_one(const MpfrNumber& a, bool open) {
    if (a < -1.0 || a > 1.0) return false;
    return !open || (a > -1.0 && a < 1.0);
}

Reference logarithm(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const MpfrNumber& a) {
    return a.sign() <= 0 ? undefined() : defined(computed(function, a));
}

/// sin, cos, tan or cot, which need many digits of pi for large operands.
Reference periodic(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const MpfrNumber& a) {
    return out_of_reach(a) ? unknown() : defined(computed(function, a));
}

/// floor(a + 1/2), made of mpfr_rint_round, which takes halves away from zero.
MpfrNumber nearest_integer(const MpfrNumber& a) {
    const MpfrNumber nearest = computed(mpfr_rint_round, a);
    const MpfrNumber rest = a - nearest;
    return mpfr_cmp_d(rest.get(), 0.5) == 0 ? nearest + MpfrNumber(1.0) : nearest;
}

/// a - b floor(a/b), from the exact remainder with the sign of a.
Reference modulo(const MpfrNumber& a, const MpfrNumber& b) {
    if (b.sign() == 0) return undefined();
    if (out_of_reach(a) || out_of_reach(b)) return unknown();
    MpfrNumber rest = computed(mpfr_fmod, a, b);
    if (rest.sign() * b.sign() < 0) rest = rest + b;
    return defined(std::move(rest));
}

Reference odd_root(const MpfrNumber& a, int n) {
    MpfrNumber result;
    mpfr_rootn_ui(result.get(), a.get(), static_cast<unsigned long>(n), MPFR_RNDN);
    return defined(std::move(result));
}

Reference truth(bool holds) { return defined(MpfrNumber(holds ? 1.0 : 0.0)); }

Reference angle(const MpfrNumber& y, const MpfrNumber& x) {
    if (y.sign() == 0 && x.sign() == 0) return undefined();
    if (out_of_reach(y) || out_of_reach(x)) return unknown();
    return defined(computed(mpfr_atan2, y, x));
}

/// A sine or cosine of n times the angle.
Reference wave(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), int n, const MpfrNumber& y,
               const MpfrNumber& x) {
    const Reference turn = angle(y, x);
    if (!turn.defined || turn.is_unknown()) return turn;
    return periodic(function, MpfrNumber(n) * turn.value);
}

/// function(a) / a, which is 1 at 0.
Reference by_itself(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const MpfrNumber& a) {
    if (a.sign() == 0) return defined(MpfrNumber(1.0));
    if (out_of_reach(a)) return unknown();
    const MpfrNumber dividend = computed(function, a);
    return dividend.is_finite() ? defined(dividend / a) : unknown();
}

/// The distance from the nearest even number.
MpfrNumber fold(const MpfrNumber& a) {
    const MpfrNumber turns = a * MpfrNumber(0.5);
    return MpfrNumber(2) * computed(mpfr_abs, turns - nearest_integer(turns));
}

/// ln(e^a + e^b), without overflow.
Reference log_sum(const MpfrNumber& a, const MpfrNumber& b) {
    const MpfrNumber distance = computed(mpfr_abs, a - b);
    const MpfrNumber rest = computed(mpfr_log1p, computed(mpfr_exp, -distance));
    if (rest.sign() == 0) return unknown();  // the true value is above 0
    return defined(computed(mpfr_max, a, b) + rest);
}

/// The quadratic blend min(a, b) - h^2/4 with h = max(1 - |a - b|, 0).
MpfrNumber smooth_min(const MpfrNumber& a, const MpfrNumber& b) {
    const MpfrNumber height = MpfrNumber(1.0) - computed(mpfr_abs, a - b);
    const MpfrNumber lesser = computed(mpfr_min, a, b);
    return height.sign() > 0 ? lesser - height * height / MpfrNumber(4.0) : lesser;
}

Reference integer_power(const MpfrNumber& a, int n) {
    MpfrNumber result;
    mpfr_pow_si(result.get(), a.get(), n, MPFR_RNDN);
    return defined(std::move(result));
}

}  // namespace

std::string MpfrNumber::text() const {
    char* text = nullptr;
    mpfr_asprintf(&text, "%.30Rg", value_);
    std::string result(text);
    mpfr_free_str(text);
    return result;
}

MpfrNumber operator+(const MpfrNumber& a, const MpfrNumber& b) { return computed(mpfr_add, a, b); }
MpfrNumber operator-(const MpfrNumber& a, const MpfrNumber& b) { return computed(mpfr_sub, a, b); }
MpfrNumber operator*(const MpfrNumber& a, const MpfrNumber& b) { return computed(mpfr_mul, a, b); }
MpfrNumber operator/(const MpfrNumber& a, const MpfrNumber& b) { return computed(mpfr_div, a, b); }
MpfrNumber operator-(const MpfrNumber& a) { return computed(mpfr_neg, a); }
bool operator<(const MpfrNumber& a, double b) { return mpfr_cmp_d(a.get(), b) < 0; }
bool operator>(const MpfrNumber& a, double b) { return mpfr_cmp_d(a.get(), b) > 0; }

MpfrNumber pi() {
    MpfrNumber result;
    mpfr_const_pi(result.get(), MPFR_RNDN);
    return result;
}

// NOLINTNEXTLINE(readability-function-size): one switch over all operators
Reference reference(Op op, int n, const MpfrNumber& a, const MpfrNumber& b, const MpfrNumber& c) {
    if (!a.is_finite() || !b.is_finite() || !c.is_finite()) return unknown();
    switch (op) {
        case Op::Constant:
        case Op::Variable: break;
        case Op::Negate: return defined(-a);
        case Op::Add: return defined(a + b);
        case Op::Subtract: return defined(a - b);
        case Op::Multiply: return defined(a * b);
        case Op::Divide: return quotient(a, b);
        case Op::IntPower: return integer_power(a, n);
        case Op::OddRoot: return odd_root(a, n);
        case Op::Sqrt: return a.sign() < 0 ? undefined() : defined(computed(mpfr_sqrt, a));
        case Op::Abs: return defined(computed(mpfr_abs, a));
        case Op::Sign: return defined(MpfrNumber((a.sign() > 0) - (a.sign() < 0)));
        case Op::Floor: return defined(computed(mpfr_rint_floor, a));
        case Op::Ceil: return defined(computed(mpfr_rint_ceil, a));
        case Op::Round: return defined(nearest_integer(a));
        case Op::Mod: return modulo(a, b);
        case Op::Min:
        case Op::And: return defined(computed(mpfr_min, a, b));
        case Op::Max:
        case Op::Or: return defined(computed(mpfr_max, a, b));
        case Op::Not: return defined(MpfrNumber(1.0) - a);
        case Op::Exp: return exponential(a);
        case Op::Log: return logarithm(mpfr_log, a);
        case Op::Log10: return logarithm(mpfr_log10, a);
        case Op::Log2: return logarithm(mpfr_log2, a);
        case Op::Sin: return periodic(mpfr_sin, a);
        case Op::Cos: return periodic(mpfr_cos, a);
        case Op::Tan: return periodic(mpfr_tan, a);
        case Op::Cot: return a.sign() == 0 ? undefined() : periodic(mpfr_cot, a);
        case Op::Asin: return within_one(a, false) ? defined(computed(mpfr_asin, a)) : undefined();
        case Op::Acos: return within_one(a, false) ? defined(computed(mpfr_acos, a)) : undefined();
        case Op::Atan: return defined(computed(mpfr_atan, a));
        case Op::Atan2:
        case Op::Angle: return angle(a, b);
        case Op::AngleSin: return wave(mpfr_sin, n, a, b);
        case Op::AngleCos: return wave(mpfr_cos, n, a, b);
        case Op::Length: return defined(computed(mpfr_hypot, a, b));
        case Op::Sinc: return by_itself(mpfr_sin, a);
        case Op::Sinhc: return by_itself(mpfr_sinh, a);
        case Op::Atanc: return by_itself(mpfr_atan, a);
        case Op::Fold: return defined(fold(a));
        case Op::LogSum: return log_sum(a, b);
        case Op::SmoothMin: return defined(smooth_min(a, b));
        case Op::Oriented:
            if (b.sign() == 0) return undefined();
            return defined(b.sign() < 0 ? -a : a);
        case Op::Sinh: return defined(computed(mpfr_sinh, a));
        case Op::Cosh: return defined(computed(mpfr_cosh, a));
        case Op::Tanh: return defined(computed(mpfr_tanh, a));
        case Op::Asinh: return defined(computed(mpfr_asinh, a));
        case Op::Acosh: return a < 1.0 ? undefined() : defined(computed(mpfr_acosh, a));
        case Op::Atanh: return within_one(a, true) ? defined(computed(mpfr_atanh, a)) : undefined();
        case Op::Less: return truth(mpfr_less_p(a.get(), b.get()) != 0);
        case Op::LessEqual: return truth(mpfr_lessequal_p(a.get(), b.get()) != 0);
        case Op::If: return defined(a.sign() > 0 ? b : c);
        case Op::Where: return b.sign() > 0 ? defined(a) : undefined();
        case Op::Field: return field_reference(*sample_field(), a, b, c);
    }
    ADD_FAILURE() << "the reference does not know operator " << static_cast<int>(op);
    return undefined();
}

namespace {

Reference of_operator(const Node& node, const std::vector<Reference>& values) {
    const Reference& a = values[node.a];
    const Reference& b = arity(node.op) < 2 ? a : values[node.b];
    const Reference& c = arity(node.op) < 3 ? a : values[node.c];
    if (node.op == Op::If) {
        if (!a.defined || a.is_unknown()) return a;
        return a.value.sign() > 0 ? b : c;
    }
    if (!a.defined || !b.defined || !c.defined) return undefined();
    if (node.field) return field_reference(*node.field, a.value, b.value, c.value);
    return reference(node.op, node.number, a.value, b.value, c.value);
}

}  // namespace

Reference reference(const Expr& expr, const std::array<double, 4>& at) {
    return reference(expr, std::array{MpfrNumber(at[0]), MpfrNumber(at[1]), MpfrNumber(at[2]),
                                      MpfrNumber(at[3])});
}

Reference reference(const Expr& expr, const std::array<MpfrNumber, 4>& at) {
    std::vector<Reference> values;
    values.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes()) {
        if (node.op == Op::Constant) {
            const MpfrNumber sum = MpfrNumber(node.lo) + MpfrNumber(node.hi);
            values.push_back(defined(sum / MpfrNumber(2.0)));
            continue;
        }
        if (node.op == Op::Variable) {
            values.push_back(defined(at.at(static_cast<std::size_t>(node.number))));
            continue;
        }
        values.push_back(of_operator(node, values));
    }
    return std::move(values.back());
}

}  // namespace zeroset::test
