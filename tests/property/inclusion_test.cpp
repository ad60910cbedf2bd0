#include "engine/language/parse.hpp"
#include "tests/property/expression_inclusion.hpp"
#include "tests/property/helper_inclusion.hpp"
#include "tests/property/operator_inclusion.hpp"
#include "tests/support/op_names.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

// Every operator of op.def, the functions that the operators are made of, and whole formulas
// enclose the real function: on random boxes, at random real points of them, against a reference of
// 256 bits. `inclusion_checks` makes many more of these checks.

namespace zeroset::test::inclusion_test {
namespace {

/// Counts the points that a suite checks and prints the sum at its end.
class CountingTest : public ::testing::Test {
protected:
    static void TearDownTestSuite() {
        std::printf("checked %llu points\n", static_cast<unsigned long long>(checks));
        checks = 0;
    }
    static void expect_none(const InclusionTally& tally) {
        checks += tally.checks;
        EXPECT_EQ(tally.failures, 0U) << tally.first;
    }

private:
    static inline std::uint64_t checks = 0;
};

class InclusionOfOperators : public CountingTest, public ::testing::WithParamInterface<OpInfo> {
protected:
    template <class Real>
    static void enclose_real_values(OperatorRange<Real> range, int boxes, std::uint64_t seed) {
        RandomNumbers random(seed + static_cast<std::uint64_t>(GetParam().op));
        InclusionTally tally;
        for (int i = 0; i < boxes && tally.failures == 0; ++i) {
            const Node node = random_operator_node(GetParam(), random);
            check_operator(range, node, Inputs<Real>(GetParam(), random), random, tally);
        }
        expect_none(tally);
    }
};

TEST_P(InclusionOfOperators, OfFloatsEnclosesRealValues) {
    enclose_real_values<float>(scalar_range<float>, 4000, 1);
}
TEST_P(InclusionOfOperators, OfDoublesEnclosesRealValues) {
    enclose_real_values<double>(block_range, 3200, 2);
}
TEST_P(InclusionOfOperators, OfConstantsEnclosesRealValues) {
    enclose_real_values<double>(scalar_range<double>, 1000, 6);
}

INSTANTIATE_TEST_SUITE_P(Inclusion, InclusionOfOperators, ::testing::ValuesIn(operators()),
                         [](const auto& row) { return op_name(row); });

class InclusionOfHelpers : public CountingTest {
protected:
    template <class Real>
    static void enclose_real_values(int boxes) {
        for (const Helper<Real>& helper : helpers<Real>()) {
            RandomNumbers random(3);
            InclusionTally tally;
            for (int i = 0; i < boxes && tally.failures == 0; ++i)
                check_helper(helper, random, tally);
            expect_none(tally);
        }
    }
};

TEST_F(InclusionOfHelpers, OfFloatsHolds) { enclose_real_values<float>(6000); }
TEST_F(InclusionOfHelpers, OfDoublesHolds) { enclose_real_values<double>(2000); }

/// Checks quotients over every divisor that contains 0: inside, at an end, as one point, of either
/// sign.
TEST_F(InclusionOfHelpers, QuotientsByZeroHold) {
    const std::vector<float> ends{-1e30F, -3.0F, -1e-45F, -0.0F, 0.0F, 1e-45F, 2.0F, 1e30F};
    RandomNumbers random(4);
    InclusionTally tally;
    const Node node{.op = Op::Divide};
    for (std::size_t low = 0; low < ends.size(); ++low) {
        for (std::size_t high = low; high < ends.size(); ++high) {
            for (int i = 0; i < 40; ++i) {
                Inputs<float> in(op_info(node.op), random);
                in.of[0] = {random.interval<float>(), {}};
                in.of[1] = {{-ends[low], ends[high]}, {}};
                check_operator(scalar_range<float>, node, in, random, tally);
            }
        }
    }
    expect_none(tally);
}

class InclusionOfExpressions : public CountingTest {
protected:
    template <class Real>
    static void enclose_random_graphs(int formulas, std::uint64_t seed) {
        RandomNumbers random(seed);
        InclusionTally tally;
        for (int formula = 0; formula < formulas && tally.failures == 0; ++formula)
            check_random_expression<Real>(1 + formula % 6, random, tally);
        expect_none(tally);
    }
    template <class Real>
    static void enclose_graph(const std::string& text, int batches, std::uint64_t seed) {
        RandomNumbers random(seed);
        InclusionTally tally;
        const Expr expr = parse(text).value();
        for (int batch = 0; batch < batches && tally.failures == 0; ++batch)
            check_expression<Real>(expr, random, tally);
        EXPECT_EQ(tally.failures, 0U) << text;
        expect_none(tally);
    }
};

TEST_F(InclusionOfExpressions, OfRandomGraphsInFloatHolds) {
    enclose_random_graphs<float>(2000, 5);
}
TEST_F(InclusionOfExpressions, OfRandomGraphsInDoubleHolds) {
    enclose_random_graphs<double>(2000, 7);
}

/// Iterations and their estimates of distances, whose values grow beyond the floats: with nothing
/// far, with some steps that are, with steps that are no polynomials.
TEST_F(InclusionOfExpressions, OfIterationsHolds) {
    const std::string square = "quaternion_square(q) + (-0.2, 0.8, w/4, 0)";
    for (const std::string& text : std::vector<std::string>{
             "length(iterate(q, 4, (x, y, z, 0), " + square + ")) - 2",
             "distance_estimate(q, 0, (x, y, z), q)",
             "distance_estimate(q, 1, (x, y, z, 0), " + square + ")",
             "distance_estimate(q, 3, (x, y, z, 0), " + square + ")",
             "distance_estimate(q, 7, (x, y, z, 0), " + square + ")",
             "distance_estimate(u, 5, x + y/3, u^3 - w)",
             "distance_estimate(q, 3, (x, y, z), bulb_power(q, 8) + (x, y, z))",
             "distance_estimate(q, 2, (x - 1, 2y, z), (exp(q.x), q.y q.z, abs(q.x) - q.z))"}) {
        enclose_graph<float>(text, 12, 9);
        enclose_graph<double>(text, 12, 10);
    }
}

}  // namespace
}  // namespace zeroset::test::inclusion_test
