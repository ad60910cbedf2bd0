#include "tests/support/inclusion.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/op.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

// Every operator of op.def and the functions that they are made of enclose the real function: on
// random boxes, at random real points of them, against a reference of 256 bits.

namespace zeroset::test {
namespace {

constexpr int points_a_box = 8;

/// A box with what the formula's structure could tell of it.
template <class Real>
struct Input {
    Interval<Real> box;
    Facts facts;

    [[nodiscard]] double point(RandomNumbers& random) const {
        return facts.constant ? random.point_in(*facts.constant) : random.point_in(box);
    }
};

float enclosing(float /*kind*/, double value) { return float_above(value); }
double enclosing(double /*kind*/, double value) { return value; }

template <class Real>
Input<Real> constant_input(RandomNumbers& random) {
    const double lo =
        random.one_in(2) ? random.number<double>() : static_cast<double>(random.number<float>());
    const double hi = random.one_in(2) ? lo : std::nextafter(lo, infinity);
    Facts facts{.nonnegative = lo >= 0, .uniform = true, .constant = Interval<double>{-lo, hi}};
    return {{enclosing(Real{}, -lo), enclosing(Real{}, hi)}, facts};
}

template <class Real>
Input<Real> nonnegative_input(RandomNumbers& random) {
    Facts facts;
    facts.nonnegative = true;
    return {absolute(random.interval<Real>()), facts};
}

template <class Real>
Input<Real> any_input(RandomNumbers& random) {
    switch (random.below(6)) {
        case 0: return constant_input<Real>(random);
        case 1: return nonnegative_input<Real>(random);
        default: return {random.interval<Real>(), {}};
    }
}

template <class Real>
Outcome<Real> range_of(const Node& node, const Input<Real>& a, const Input<Real>& b) {
    IntervalAlgebra<Real> algebra;
    const Interval<Real> value = apply(algebra, node, Operand<Interval<Real>>{a.box, a.facts},
                                       Operand<Interval<Real>>{b.box, b.facts});
    return {value, algebra.defined.value_or(true), algebra.continuous.value_or(true)};
}

template <class Real>
std::string described(const Input<Real>& input) {
    std::string text = hex(input.box);
    if (input.facts.constant) text += " (constant " + hex(*input.facts.constant) + ")";
    if (input.facts.nonnegative) text += " (known not to be negative)";
    return text;
}

/// A whole turn lies between the values of atan2 at two neighbours.
bool jumps(Op op, double y, double y_beyond, double x) {
    if (op != Op::Atan2) return false;
    const MpfrNumber at_x(x);
    const Reference here = reference(op, 0, MpfrNumber(y), at_x);
    const Reference there = reference(op, 0, MpfrNumber(y_beyond), at_x);
    if (!here.defined || !there.defined) return false;
    const MpfrNumber step = here.value - there.value;
    return step > 6.0 || step < -6.0;
}

class OperatorRange : public CountingTest, public ::testing::WithParamInterface<OpInfo> {
protected:
    template <class Real>
    static void enclose_real_values(int boxes, std::uint64_t seed) {
        RandomNumbers random(seed + static_cast<std::uint64_t>(GetParam().op));
        for (int i = 0; i < boxes && !HasFailure(); ++i) {
            Node node{.op = GetParam().op};
            if (GetParam().notation == Notation::Power) {
                node.number = random.one_in(9) ? 16 : random.between(2, 9);
            }
            enclose_on_a_box<Real>(node, random);
        }
    }

private:
    template <class Real>
    static void enclose_on_a_box(const Node& node, RandomNumbers& random) {
        const auto a = any_input<Real>(random);
        const auto b = op_info(node.op).arity == 2 ? any_input<Real>(random) : a;
        const Outcome<Real> outcome = in_tested_mode(range_of<Real>, node, a, b);
        for (int i = 0; i < points_a_box && !HasFailure(); ++i) {
            const double x = a.point(random);
            const double y = b.point(random);
            const Reference truth = reference(node.op, node.number, MpfrNumber(x), MpfrNumber(y));
            ASSERT_TRUE(holds(outcome, truth, node.op == Op::Angle))
                << "operator " << op_info(node.op).name << ", exponent " << node.number << "\n  a "
                << described(a) << "\n  b " << described(b) << "\n  at (" << hex(x) << ", "
                << hex(y) << ")";
            const double beyond = std::max(std::nextafter(x, -infinity), -double(a.box.neg_lo));
            ASSERT_FALSE(outcome.continuous && jumps(node.op, x, beyond, y))
                << "claimed continuous over a jump: " << op_info(node.op).name << "\n  a "
                << described(a) << "\n  b " << described(b);
        }
    }
};

TEST_P(OperatorRange, OfFloatsEnclosesRealValues) { enclose_real_values<float>(20000, 1); }
TEST_P(OperatorRange, OfDoublesEnclosesRealValues) { enclose_real_values<double>(8000, 2); }

INSTANTIATE_TEST_SUITE_P(Inclusion, OperatorRange, ::testing::ValuesIn(operators()),
                         [](const auto& row) { return op_name(row); });

enum class Domain : std::uint8_t { Any, FirstNonnegative, Nonnegative };

constexpr double factors[] = {1,    -1,    2,        -3,        0.5,     -0.375,      0x1.99999ap-4,
                              1e10, -1e10, 0x1p-100, -0x1p-140, 0x1p120, 0x1.fffffep0};

/// A function of interval.hpp that is more than a row of op.def. `n` is an exponent, or the place
/// of a factor.
template <class Real>
struct Helper {
    const char* name;
    Domain domain;
    Outcome<Real> (*range)(const Interval<Real>& a, const Interval<Real>& b, const int& n);
    Reference (*truth)(const MpfrNumber& a, const MpfrNumber& b, int n);
};

Reference power_at(const MpfrNumber& a, const MpfrNumber& b, int n) {
    return reference(Op::IntPower, n, a, b);
}
Reference product_at(const MpfrNumber& a, const MpfrNumber& b, int n) {
    return reference(Op::Multiply, n, a, b);
}

template <class Real>
std::vector<Helper<Real>> helpers() {
    using Box = Interval<Real>;
    using Range = Outcome<Real>;
    using Number = MpfrNumber;
    return {
        {"a * b", Domain::Any, [](const Box& a, const Box& b, const int&) { return Range{a * b}; },
         product_at},
        {"multiply_nonnegative_by", Domain::FirstNonnegative,
         [](const Box& a, const Box& b, const int&) {
             return Range{multiply_nonnegative_by(a, b)};
         },
         product_at},
        {"multiply_nonnegative", Domain::Nonnegative,
         [](const Box& a, const Box& b, const int&) { return Range{multiply_nonnegative(a, b)}; },
         product_at},
        {"scale", Domain::Any,
         [](const Box& a, const Box&, const int& n) { return Range{scale(a, factors[n])}; },
         [](const Number& a, const Number&, int n) {
             return product_at(a, Number(factors[n]), 0);
         }},
        {"square_nonnegative", Domain::Nonnegative,
         [](const Box& a, const Box&, const int&) { return Range{square_nonnegative(a)}; },
         [](const Number& a, const Number& b, int) { return power_at(a, b, 2); }},
        {"power_nonnegative", Domain::Nonnegative,
         [](const Box& a, const Box&, const int& n) { return Range{power_nonnegative(a, n + 1)}; },
         [](const Number& a, const Number& b, int n) { return power_at(a, b, n + 1); }},
        {"power", Domain::Any,
         [](const Box& a, const Box&, const int& n) { return Range{power(a, n + 1, false)}; },
         [](const Number& a, const Number& b, int n) { return power_at(a, b, n + 1); }},
        {"power of 16", Domain::Any,
         [](const Box& a, const Box&, const int&) { return Range{power(a, 16, false)}; },
         [](const Number& a, const Number& b, int) { return power_at(a, b, 16); }},
        {"absolute", Domain::Any,
         [](const Box& a, const Box&, const int&) { return Range{absolute(a)}; },
         [](const Number& a, const Number& b, int n) { return reference(Op::Abs, n, a, b); }},
        {"square_root", Domain::Nonnegative,
         [](const Box& a, const Box&, const int&) { return Range{square_root(a)}; },
         [](const Number& a, const Number& b, int n) { return reference(Op::Sqrt, n, a, b); }},
    };
}

class InclusionOfHelpers : public CountingTest {
protected:
    template <class Real>
    static void enclose_real_values(const Helper<Real>& helper, int boxes) {
        RandomNumbers random(3);
        for (int i = 0; i < boxes && !HasFailure(); ++i) {
            auto a = random.interval<Real>();
            auto b = random.interval<Real>();
            if (helper.domain != Domain::Any) a = absolute(a);
            if (helper.domain == Domain::Nonnegative) b = absolute(b);
            const int n = random.between(0, static_cast<int>(std::size(factors)) - 1);
            const Outcome<Real> outcome = in_tested_mode(helper.range, a, b, n);
            for (int k = 0; k < points_a_box && !HasFailure(); ++k) {
                const double x = random.point_in(a);
                const double y = random.point_in(b);
                ASSERT_TRUE(holds(outcome, helper.truth(MpfrNumber(x), MpfrNumber(y), n)))
                    << "function " << helper.name << ", n " << n << "\n  a " << hex(a) << "\n  b "
                    << hex(b) << "\n  at (" << hex(x) << ", " << hex(y) << ")";
            }
        }
    }
};

TEST_F(InclusionOfHelpers, OfFloatsHolds) {
    for (const auto& helper : helpers<float>())
        enclose_real_values(helper, 30000);
}

TEST_F(InclusionOfHelpers, OfDoublesHolds) {
    for (const auto& helper : helpers<double>())
        enclose_real_values(helper, 10000);
}

/// Quotients over every divisor that has a zero: inside, at an end, as one point, of either sign.
TEST_F(InclusionOfHelpers, QuotientsByZeroHold) {
    const std::vector<float> ends{-1e30F, -3.0F, -1e-45F, -0.0F, 0.0F, 1e-45F, 2.0F, 1e30F};
    RandomNumbers random(4);
    const Node node{.op = Op::Divide};
    for (std::size_t low = 0; low < ends.size(); ++low) {
        for (std::size_t high = low; high < ends.size(); ++high) {
            const Input<float> b{{-ends[low], ends[high]}, {}};
            for (int i = 0; i < 300 && !HasFailure(); ++i) {
                const Input<float> a{random.interval<float>(), {}};
                const auto outcome = in_tested_mode(range_of<float>, node, a, b);
                const double x = a.point(random);
                const double y = b.point(random);
                ASSERT_TRUE(holds(outcome, reference(node.op, 0, MpfrNumber(x), MpfrNumber(y))))
                    << "operator Divide\n  a " << hex(a.box) << "\n  b " << hex(b.box) << "\n  at ("
                    << hex(x) << ", " << hex(y) << ")";
            }
        }
    }
}

}  // namespace
}  // namespace zeroset::test
