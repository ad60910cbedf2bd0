#include "tests/support/inclusion.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/op.hpp"
#include "engine/num/block.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
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
    bool condition = false;
    std::optional<Interval<Real>> apart{};

    [[nodiscard]] double point(RandomNumbers& random) const {
        if (condition) return random.one_in(2) ? static_cast<double>(box.hi) : -double(box.neg_lo);
        if (facts.constant) return random.point_in(*facts.constant);
        const double inside = random.point_in(box);
        if (!apart) return inside;
        const auto lower = static_cast<double>(apart->hi);
        const double upper = -static_cast<double>(apart->neg_lo);
        if (!(inside > lower && inside < upper)) return inside;
        return random.one_in(2) ? lower : upper;
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

/// A box with a hole in it.
template <class Real>
Input<Real> divided_input(RandomNumbers& random) {
    Input<Real> input{random.interval<Real>(), {}};
    const double a = random.point_in(input.box);
    const double b = random.point_in(input.box);
    input.apart = {enclosing(Real{}, -std::max(a, b)), enclosing(Real{}, std::min(a, b))};
    return input;
}

template <class Real>
Input<Real> any_input(RandomNumbers& random) {
    switch (random.below(6)) {
        case 0: return constant_input<Real>(random);
        case 1: return nonnegative_input<Real>(random);
        case 2: return divided_input<Real>(random);
        default: return {random.interval<Real>(), {}};
    }
}

template <class Real>
Input<Real> condition_input(RandomNumbers& random) {
    const int lo = random.between(0, 1);
    const int hi = random.between(lo, 1);
    Facts facts;
    facts.nonnegative = true;
    return {{-Real(lo), Real(hi)}, facts, true};
}

/// The operands of one operator.
template <class Real>
struct Inputs {
    std::array<Input<Real>, 3> of;

    Inputs(const OpInfo& info, RandomNumbers& random) {
        for (int k = 0; k < 3; ++k) {
            of.at(static_cast<std::size_t>(k)) =
                takes_condition(info, k) ? condition_input<Real>(random) : any_input<Real>(random);
        }
    }

    /// Points of the box, 0 in what is no operand; those drawn twice only once. -0 is not 0.
    std::vector<std::array<double, 3>> points(const OpInfo& info, RandomNumbers& random) const {
        using Point = std::array<double, 3>;
        std::vector<Point> result;
        for (int i = 0; i < points_a_box; ++i) {
            Point point{};
            for (std::size_t k = 0; k < static_cast<std::size_t>(info.arity); ++k)
                point.at(k) = of.at(k).point(random);
            const auto is_same = [&](const Point& other) {
                return std::memcmp(&point, &other, sizeof point) == 0;
            };
            if (std::ranges::none_of(result, is_same)) result.push_back(point);
        }
        return result;
    }
};

template <class Real>
Outcome<Real> range_of(const Node& node, const Inputs<Real>& in) {
    const auto& [a, b, c] = in.of;
    const Enclosure<Real> x{a.box, {}, {}, {}, a.apart};
    const Enclosure<Real> y{b.box, {}, {}, {}, b.apart};
    const Enclosure<Real> z{c.box, {}, {}, {}, c.apart};
    IntervalAlgebra<Real> algebra;
    const Enclosure<Real> f =
        apply(algebra, node, Operand<Enclosure<Real>>{x, a.facts},
              Operand<Enclosure<Real>>{y, b.facts}, Operand<Enclosure<Real>>{z, c.facts});
    return {f.range, f.somewhere.value_or(true), f.everywhere.value_or(true),
            f.continuous.value_or(true), f.apart};
}

double first_lane(const Block<double>& block) {
    std::array<double, Block<double>::lanes> lanes{};
    std::memcpy(lanes.data(), &block, sizeof block);
    return lanes[0];
}

/// As `range_of`, by the carrier of kernels in double.
Outcome<double> range_in_block(const Node& node, const Inputs<double>& in) {
    using Lanes = Block<double>;
    const auto enclosure = [](const Input<double>& input) {
        const auto splat = [](const Interval<double>& box) {
            return Interval<Lanes>{Lanes::splat(box.neg_lo), Lanes::splat(box.hi)};
        };
        Enclosure<Lanes> result{splat(input.box)};
        if (input.apart) result.apart = splat(*input.apart);
        return result;
    };
    const auto& [a, b, c] = in.of;
    const auto x = enclosure(a);
    const auto y = enclosure(b);
    const auto z = enclosure(c);
    IntervalAlgebra<Lanes> algebra;
    const Enclosure<Lanes> f =
        apply(algebra, node, Operand<Enclosure<Lanes>>{x, a.facts},
              Operand<Enclosure<Lanes>>{y, b.facts}, Operand<Enclosure<Lanes>>{z, c.facts});
    const auto holds = [](const std::optional<BlockMask>& mask) {
        return !mask || (mask->bits & 1U) != 0;
    };
    const auto first = [](const Interval<Lanes>& box) {
        return Interval<double>{first_lane(box.neg_lo), first_lane(box.hi)};
    };
    Outcome<double> outcome{first(f.range), holds(f.somewhere), holds(f.everywhere),
                            holds(f.continuous)};
    if (f.apart) outcome.apart = first(*f.apart);
    return outcome;
}

template <class Real>
std::string described(const Input<Real>& input) {
    std::string text = hex(input.box);
    if (input.facts.constant) text += " (constant " + hex(*input.facts.constant) + ")";
    if (input.facts.nonnegative) text += " (known not to be negative)";
    if (input.apart) text += " (with sides " + hex(*input.apart) + ")";
    return text;
}

/// A whole turn lies between the value of atan2 at a point and at its neighbour (x, y_beyond).
bool turns(Op op, const Reference& here, double y, double y_beyond, double x) {
    if (op != Op::Atan2 || y == y_beyond) return false;
    const Reference there = reference(op, 0, MpfrNumber(y_beyond), MpfrNumber(x));
    if (!here.defined || !there.defined) return false;
    const MpfrNumber step = here.value - there.value;
    return step > 6.0 || step < -6.0;
}

bool is_step(const OpInfo& info) {
    return is_condition(info) || info.op == Op::Sign || info.op == Op::Floor ||
           info.op == Op::Ceil || info.op == Op::Round;
}

/// Which continuous piece of a function with steps the point (a, b) is on: the value of such a
/// function, floor(a/b) for mod; 0 for others.
double piece(const OpInfo& info, const Reference& truth, double a, double b) {
    if (!truth.defined || truth.is_unknown()) return 0;
    if (is_step(info)) return truth.value.nearest();
    if (info.op != Op::Mod) return 0;
    const MpfrNumber quotient = (MpfrNumber(a) - truth.value) / MpfrNumber(b);
    return std::nearbyint(quotient.nearest());
}

class OperatorRange : public CountingTest, public ::testing::WithParamInterface<OpInfo> {
protected:
    template <class Real>
    using Range = Outcome<Real> (*)(const Node&, const Inputs<Real>&);

    template <class Real>
    static void enclose_real_values(Range<Real> range, int boxes, std::uint64_t seed) {
        RandomNumbers random(seed + static_cast<std::uint64_t>(GetParam().op));
        for (int i = 0; i < boxes && !HasFailure(); ++i) {
            Node node{.op = GetParam().op};
            if (GetParam().notation == Notation::Power) {
                node.number = random.one_in(9) ? 16 : random.between(2, 9);
            }
            if (GetParam().notation == Notation::Root) {
                node.number = random.one_in(9) ? 101 : 2 * random.between(1, 4) + 1;
            }
            enclose_on_a_box<Real>(range, node, random);
        }
    }

private:
    template <class Real>
    static void enclose_on_a_box(Range<Real> range, const Node& node, RandomNumbers& random) {
        const Inputs<Real> in(GetParam(), random);
        const auto& [a, b, c] = in.of;
        const Outcome<Real> outcome = in_tested_mode(range, node, in);
        std::optional<double> first_piece;
        for (const auto& [x, y, z] : in.points(GetParam(), random)) {
            const Reference truth =
                reference(node.op, node.number, MpfrNumber(x), MpfrNumber(y), MpfrNumber(z));
            const auto place = [&] {
                return "operator " + std::string(GetParam().name) + ", number " +
                       std::to_string(node.number) + "\n  a " + described(a) + "\n  b " +
                       described(b) + "\n  c " + described(c) + "\n  at (" + hex(x) + ", " +
                       hex(y) + ", " + hex(z) + ")";
            };
            ASSERT_TRUE(holds(outcome, truth, node.op == Op::Angle)) << place();
            if (!outcome.continuous || !truth.defined) continue;
            const double beyond = std::max(std::nextafter(x, -infinity), -double(a.box.neg_lo));
            const double here = piece(GetParam(), truth, x, y);
            if (!first_piece) first_piece = here;
            ASSERT_TRUE(!turns(node.op, truth, x, beyond, y) && here == *first_piece)
                << "claimed continuous over a jump: " << place();
        }
    }
};

TEST_P(OperatorRange, OfFloatsEnclosesRealValues) {
    enclose_real_values<float>(range_of<float>, 20000, 1);
}
TEST_P(OperatorRange, OfDoublesEnclosesRealValues) {
    enclose_real_values<double>(range_in_block, 16000, 2);
}
TEST_P(OperatorRange, OfConstantsEnclosesRealValues) {
    enclose_real_values<double>(range_of<double>, 4000, 6);
}

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
            for (int i = 0; i < 300 && !HasFailure(); ++i) {
                Inputs<float> in(op_info(node.op), random);
                auto& [a, b, c] = in.of;
                a = {random.interval<float>(), {}};
                b = {{-ends[low], ends[high]}, {}};
                const auto outcome = in_tested_mode(range_of<float>, node, in);
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
