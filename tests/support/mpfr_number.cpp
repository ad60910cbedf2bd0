#include "tests/support/mpfr_number.hpp"

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

/// Beyond any double, where periodic functions would need gigabytes of pi.
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
    if (result.sign() == 0) return unknown();  // it is above 0 in truth
    return defined(std::move(result));
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

Reference reference(Op op, int n, const MpfrNumber& a, const MpfrNumber& b) {
    if (!a.is_finite() || !b.is_finite()) return unknown();
    switch (op) {
        case Op::Constant:
        case Op::Variable: break;
        case Op::Negate: return defined(-a);
        case Op::Add: return defined(a + b);
        case Op::Subtract: return defined(a - b);
        case Op::Multiply: return defined(a * b);
        case Op::Divide: return quotient(a, b);
        case Op::IntPower: return integer_power(a, n);
        case Op::Sqrt: return a.sign() < 0 ? undefined() : defined(computed(mpfr_sqrt, a));
        case Op::Abs: return defined(computed(mpfr_abs, a));
        case Op::Sin: return out_of_reach(a) ? unknown() : defined(computed(mpfr_sin, a));
        case Op::Cos: return out_of_reach(a) ? unknown() : defined(computed(mpfr_cos, a));
        case Op::Acos: return a < -1.0 || a > 1.0 ? undefined() : defined(computed(mpfr_acos, a));
        case Op::Atan2:
        case Op::Angle:
            if (a.sign() == 0 && b.sign() == 0) return undefined();
            if (out_of_reach(a) || out_of_reach(b)) return unknown();
            return defined(computed(mpfr_atan2, a, b));
        case Op::Exp: return exponential(a);
        case Op::Log: return a.sign() <= 0 ? undefined() : defined(computed(mpfr_log, a));
        case Op::Min: return defined(computed(mpfr_min, a, b));
        case Op::Max: return defined(computed(mpfr_max, a, b));
    }
    ADD_FAILURE() << "the reference does not know operator " << static_cast<int>(op);
    return undefined();
}

Reference reference(const Expr& expr, const std::array<double, 4>& at) {
    std::vector<Reference> values;
    values.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes()) {
        if (node.op == Op::Constant) {
            const MpfrNumber sum = MpfrNumber(node.lo) + MpfrNumber(node.hi);
            values.push_back(defined(sum / MpfrNumber(2.0)));
            continue;
        }
        if (node.op == Op::Variable) {
            values.push_back(defined(MpfrNumber(at.at(static_cast<std::size_t>(node.number)))));
            continue;
        }
        const Reference& a = values[node.a];
        const Reference& b = op_info(node.op).arity == 2 ? values[node.b] : a;
        values.push_back(a.defined && b.defined ? reference(node.op, node.number, a.value, b.value)
                                                : undefined());
    }
    return std::move(values.back());
}

}  // namespace zeroset::test
