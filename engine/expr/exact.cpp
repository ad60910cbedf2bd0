#include "engine/expr/exact.hpp"

#include "engine/expr/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>

namespace zeroset {
namespace {

constexpr long long largest =
    1LL << 53U;  // p, q and so p / q are exact doubles or correctly rounded

std::optional<long long> product(long long a, long long b) {
    long long result = 0;
    if (__builtin_mul_overflow(a, b, &result) || std::abs(result) > largest) return std::nullopt;
    return result;
}

std::optional<Fraction> fraction(std::optional<long long> p, std::optional<long long> q) {
    if (!p || !q || *q == 0) return std::nullopt;
    const long long divisor = std::gcd(*p, *q) * (*q < 0 ? -1 : 1);
    return Fraction{.p = *p / divisor, .q = *q / divisor};
}

std::optional<Fraction> sum(const Fraction& a, const Fraction& b) {
    const auto left = product(a.p, b.q);
    const auto right = product(b.p, a.q);
    if (!left || !right || std::abs(*left + *right) > largest) return std::nullopt;
    return fraction(*left + *right, product(a.q, b.q));
}

std::optional<Fraction> power(const Fraction& a, int n) {
    std::optional<long long> p = 1;
    std::optional<long long> q = 1;
    for (int i = 0; i < n && p && q && std::abs(n) < 64; ++i) {
        p = product(*p, a.p);
        q = product(*q, a.q);
    }
    if (n >= 64) return std::nullopt;
    return fraction(p, q);
}

/// A whole number or a decimal number of at most 15 digits.
std::optional<Fraction> literal(const Node& node) {
    if (node.lo == node.hi && node.lo == std::floor(node.lo)) {
        if (std::abs(node.lo) > static_cast<double>(largest)) return std::nullopt;
        return Fraction{.p = static_cast<long long>(node.lo), .q = 1};
    }
    const std::string text = number_text({.lo = node.lo, .hi = node.hi});
    const std::size_t end = std::min(text.find('e'), text.size());
    const std::size_t point = std::min(text.find('.'), end);
    const std::string decimals = text.substr(point, end - point);
    const std::string digits = text.substr(0, point) + decimals.substr(decimals.empty() ? 0 : 1);
    constexpr std::size_t sign_and_digits = 16;
    if (digits.size() > sign_and_digits) return std::nullopt;
    const int exponent = end < text.size() ? std::atoi(text.c_str() + end + 1) : 0;
    const int places = static_cast<int>(digits.size() - point) - exponent;
    const auto scale = power({.p = 10, .q = 1}, std::abs(places));
    if (!scale) return std::nullopt;
    const Fraction number{.p = std::strtoll(digits.c_str(), nullptr, 10), .q = 1};
    if (places < 0) return fraction(product(number.p, scale->p), 1);
    return fraction(number.p, scale->p);
}

/// The fraction of a node; `visits` is how many more operators it may look at.
std::optional<Fraction> exact_fraction(const ExprBuilder& builder, NodeId id, int& visits) {
    const Node& node = builder.node(id);
    if (--visits < 0) return std::nullopt;
    if (node.op == Op::Constant) return literal(node);
    const bool arithmetic = node.op == Op::Negate || node.op == Op::Add ||
                            node.op == Op::Subtract || node.op == Op::Multiply ||
                            node.op == Op::Divide || node.op == Op::IntPower;
    if (!arithmetic) return std::nullopt;
    const std::optional<Fraction> a = exact_fraction(builder, node.a, visits);
    if (!a) return std::nullopt;
    if (node.op == Op::IntPower) return power(*a, node.number);
    if (node.op == Op::Negate) return Fraction{.p = -a->p, .q = a->q};
    const std::optional<Fraction> b = exact_fraction(builder, node.b, visits);
    if (!b) return std::nullopt;
    if (node.op == Op::Add) return sum(*a, *b);
    if (node.op == Op::Subtract) return sum(*a, {.p = -b->p, .q = b->q});
    if (node.op == Op::Multiply) return fraction(product(a->p, b->p), product(a->q, b->q));
    return fraction(product(a->p, b->q), product(a->q, b->p));
}

}  // namespace

std::optional<Fraction> exact_fraction(const ExprBuilder& builder, NodeId id) {
    // Shared operands are looked at again each time they are used.
    int visits = 128;
    return exact_fraction(builder, id, visits);
}

std::optional<double> exact_value(const ExprBuilder& builder, NodeId id) {
    const Node& node = builder.node(id);
    if (node.op == Op::Constant && node.lo == node.hi) return node.lo;
    const std::optional<Fraction> value = exact_fraction(builder, id);
    const bool exact = value && (value->q & (value->q - 1)) == 0;
    if (!exact) return std::nullopt;
    return static_cast<double>(value->p) / static_cast<double>(value->q);
}

}  // namespace zeroset
