#include "engine/algebra/algebra.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/real_types.hpp"
#include "tests/support/sample_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

// The contract of engine/num/interval.hpp for every operator of op.def: proper operands, however
// unbounded, give a proper range and consistent masks; with an unknown operand (NaN), the range
// rejects only what no operand could give.

namespace zeroset::test::special_intervals_test {
namespace {

template <class Real>
using Operands = std::array<Enclosure<Real>, 3>;

template <class Real>
bool is_proper(const Interval<Real>& a) {
    const Real lowest = -std::numeric_limits<Real>::infinity();
    return a.neg_lo > lowest && a.hi > lowest && -a.neg_lo <= a.hi;
}

template <class Real>
std::string text(const Enclosure<Real>& a) {
    return "[" + std::to_string(-a.range.neg_lo) + ", " + std::to_string(a.range.hi) + "]" +
           (a.somewhere.value_or(true) ? "" : " nowhere");
}

std::string described(const Node& node) {
    return std::string(op_info(node.op).name) + " " + std::to_string(node.number);
}

template <class Real>
class SpecialIntervals : public ::testing::Test {
protected:
    using Box = Interval<Real>;

    static std::vector<Box> conditions() { return {{0, 0}, {-1, 1}, {0, 1}}; }
    /// All proper pairs of ends among zeros, ordinary, tiny and huge numbers and infinities.
    static std::vector<Box> boxes() {
        using Limits = std::numeric_limits<Real>;
        std::vector<Real> ends{Limits::infinity(),
                               Limits::max(),
                               Limits::min(),
                               Limits::denorm_min(),
                               Real(0),
                               Real(1),
                               Real(2.5)};
        for (std::size_t i = ends.size(); i-- > 0;)
            ends.push_back(-ends[i]);
        std::vector<Box> all;
        for (const Real lo : ends) {
            for (const Real hi : ends) {
                if (is_proper(Box{-lo, hi})) all.push_back({-lo, hi});
            }
        }
        return all;
    }

    /// Nodes of all operators; those with a number have several.
    static std::vector<Node> nodes() {
        std::vector<Node> all;
        for (const OpInfo& info : operators()) {
            std::vector<int> numbers{0};
            if (info.notation == Notation::Power) numbers = {2, 3, 4, 7};
            if (info.notation == Notation::Wave) numbers = {1, 2, 7};
            if (info.notation == Notation::Root) numbers = {3, 5};
            for (const int number : numbers)
                all.push_back(node_of(info.op, number));
        }
        return all;
    }

    static Enclosure<Real> result(const Node& node, const Operands<Real>& in, bool nonnegative) {
        Facts facts;
        facts.nonnegative = nonnegative;
        IntervalAlgebra<Real> algebra;
        const auto operand = [&](std::size_t i) { return Operand<Enclosure<Real>>{in[i], facts}; };
        const UpwardRounding upward;
        return apply(algebra, node, operand(0), operand(1), operand(2));
    }

    /// Calls visit_operands(operands, known to be nonnegative) for all choices of special operands.
    static void visit(const Node& node,
                      const std::function<void(const Operands<Real>&, bool)>& visit_operands) {
        const OpInfo& info = op_info(node.op);
        const auto choices = [&](int k) {
            if (k >= info.arity) return std::vector<Box>{{0, 0}};
            return takes_condition(info, k) ? conditions() : boxes();
        };
        for (const Box& a : choices(0)) {
            for (const Box& b : choices(1)) {
                for (const Box& c : choices(2)) {
                    const bool nonnegative = a.neg_lo <= 0 && b.neg_lo <= 0 && c.neg_lo <= 0;
                    visit_operands({Enclosure<Real>{a}, {b}, {c}}, false);
                    if (nonnegative) visit_operands({Enclosure<Real>{a}, {b}, {c}}, true);
                }
            }
        }
    }
};
TYPED_TEST_SUITE(SpecialIntervals, RealTypes, RealTypeNames);

TYPED_TEST(SpecialIntervals, GiveProperRanges) {
    for (const Node& node : TestFixture::nodes()) {
        int wrong = 0;
        TestFixture::visit(node, [&](const Operands<TypeParam>& in, bool nonnegative) {
            const auto found = TestFixture::result(node, in, nonnegative);
            const bool somewhere = found.somewhere.value_or(true);
            const bool consistent = somewhere || !found.everywhere.value_or(true);
            if ((!somewhere || is_proper(found.range)) && consistent) return;
            if (++wrong > 3) return;
            ADD_FAILURE() << described(node) << " of " << text(in[0]) << " " << text(in[1]) << " "
                          << text(in[2]) << (nonnegative ? " (not negative)" : "") << ": "
                          << text(found) << " everywhere " << found.everywhere.value_or(true);
        });
    }
}

/// Whether `found` is unknown, or as wide as `expected`.
template <class Real>
bool is_as_wide(const Interval<Real>& found, const Interval<Real>& expected) {
    const auto open = [](Real member) { return std::isnan(member) || std::isinf(member); };
    if (std::isnan(found.neg_lo) || std::isnan(found.hi))
        return open(found.neg_lo) && open(found.hi);
    return found.neg_lo >= expected.neg_lo && found.hi >= expected.hi;
}

template <class Real>
bool claims_no_more(const Enclosure<Real>& found, const Enclosure<Real>& expected) {
    const auto implies = [](bool a, bool b) { return !a || b; };
    return implies(expected.somewhere.value_or(true), found.somewhere.value_or(true)) &&
           implies(found.everywhere.value_or(true), expected.everywhere.value_or(true)) &&
           implies(found.continuous.value_or(true), expected.continuous.value_or(true));
}

TYPED_TEST(SpecialIntervals, OfUnknownOperandsAreAsOfTheWholeLine) {
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    for (const Node& node : TestFixture::nodes()) {
        int wrong = 0;
        const OpInfo& info = op_info(node.op);
        const auto compare = [&](const Operands<TypeParam>& known, bool nonnegative) {
            for (std::size_t k = 0; k < static_cast<std::size_t>(info.arity); ++k) {
                if (takes_condition(info, static_cast<int>(k))) continue;
                Operands<TypeParam> whole = known;
                Operands<TypeParam> unknown = known;
                whole.at(k).range = whole_line(nan);
                if (nonnegative) whole.at(k).range.neg_lo = 0;
                unknown.at(k).range = {nan, nan};
                const auto expected = TestFixture::result(node, whole, nonnegative);
                const auto found = TestFixture::result(node, unknown, nonnegative);
                if (is_as_wide(found.range, expected.range) && claims_no_more(found, expected))
                    continue;
                if (++wrong > 3) continue;
                ADD_FAILURE() << described(node) << ", operand " << k << " of " << text(unknown[0])
                              << " " << text(unknown[1]) << " " << text(unknown[2])
                              << (nonnegative ? " (not negative)" : "") << ": " << text(found)
                              << ", expected " << text(expected);
            }
        };
        TestFixture::visit(node, compare);
    }
}

}  // namespace
}  // namespace zeroset::test::special_intervals_test
