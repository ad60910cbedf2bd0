#include "engine/rewrite/differences/differences.hpp"

#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset::differences_test {
namespace {

std::string written(const char* text) {
    return without_small_differences(*parse(text)).canonical();
}
std::string as_typed(const char* text) { return parse(text)->canonical(); }

TEST(WithoutSmallDifferences, WritesWhatIsCommonOnce) {
    EXPECT_EQ(written("((x + 0.001)^2 - x^2)/0.001 - z"), "x + 0.001 + x - z");
    EXPECT_EQ(written("(x^2*y - (x + 0.001)^2*y)/0.001"), "-((x + (x + 0.001))*y)");
    EXPECT_EQ(written("(sqrt((x + 1/1000)^2 + y^2) - sqrt(x^2 + y^2))*1000"),
              "1/1000*((x + 1/1000 + x)/(sqrt((x + 1/1000)^2 + y^2) + sqrt(x^2 + y^2)))*1000");
    EXPECT_EQ(written("(exp(x + 0.0001) - exp(x - 0.0001))/0.0002"),
              "exp(x - 1e-04 + 0.5*(1/5000))*(sinh(0.5*(1/5000))/(0.5*(1/5000)))");
    EXPECT_EQ(written("(if(x + 0.001 > y, (x + 0.001)^2, z) - if(x > y, x^2, z))/0.001"),
              "if(y < x + 0.001 and y < x, x + 0.001 + x, if(not (y < x + 0.001 or y < x), 0, "
              "(if(y < x + 0.001, (x + 0.001)^2, z) - if(y < x, x^2, z))/(1/1000)))");
}

TEST(WithoutSmallDifferences, KnowsASumByAnySigns) {
    for (const char* text : {"((5 - z)^2 - (5 + (-z + 0.001))^2)/0.001 - x",
                             "(sin(2 - x) - sin(-(x - 2.001)))/0.001 - y",
                             "(exp(-(-x - 1)) - exp(0.999 + x))/0.001 - y"}) {
        EXPECT_NE(written(text), as_typed(text)) << text;
    }
    for (const char* text :
         {"((5 - z)^2 - (5.001 + z)^2)/0.001 - x", "(sin(2 - x) - sin(x - 2.001))/0.001 - y"}) {
        EXPECT_EQ(written(text), as_typed(text)) << text << ": of the other sign";
    }
}

TEST(WithoutSmallDifferences, LeavesOthersAlone) {
    for (const char* text :
         {"(x + 1)^2 - x^2", "(x + 0.001)^2 - y^2", "(x + 0.001)^3 - x^2", "x + 0.001 - x",
          "log(x + 0.001) - log(x)", "floor(x + 0.001) - floor(x)", "x^2 - 0.001"}) {
        EXPECT_EQ(written(text), as_typed(text)) << text;
    }
}

/// f(x + step[0], y + step[1], z + step[2], w).
NodeId shifted(ExprBuilder& builder, const Expr& f, const std::array<double, 3>& step) {
    std::vector<NodeId> now;
    for (const Node& node : f.nodes()) {
        now.push_back(copy_node(builder, node, now));
        if (node.op != Op::Variable) continue;
        const auto axis = static_cast<std::size_t>(node.number);
        const double by = axis < step.size() ? step.at(axis) : 0.0;
        now.back() = make_add(builder, now.back(), builder.constant(by));
    }
    return now.back();
}

struct Difference {
    Expr plain, written;
};

Difference difference_of(const Expr& f, const std::array<double, 3>& step) {
    ExprBuilder builder;
    const NodeId to = shifted(builder, f, step);
    const NodeId from = shifted(builder, f, {});
    const NodeId divisor = builder.constant(*std::ranges::max_element(step));
    const NodeId quotient =
        builder.apply(Op::Divide, builder.apply(Op::Subtract, to, from), divisor);
    const Expr plain = builder.finish(quotient);
    return {plain, without_small_differences(plain)};
}

/// Both in 256 bits, of which cancellation takes 20 and what is added to 1e30 another 100.
void expect_same_function(const Difference& f, const std::array<double, 4>& at) {
    const test::Reference plain = test::reference(f.plain, at);
    const test::Reference written = test::reference(f.written, at);
    if (plain.is_unknown() || written.is_unknown()) return;
    ASSERT_EQ(plain.defined, written.defined) << f.plain.canonical() << "\n"
                                              << f.written.canonical();
    if (!plain.defined) return;
    const test::MpfrNumber error = plain.value - written.value;
    const double most = 1e-36 * (1 + std::abs(plain.value.nearest()));
    EXPECT_TRUE(error < most && error > -most) << f.plain.canonical() << "\n"
                                               << f.written.canonical() << "\n"
                                               << plain.value.text() << " " << written.value.text();
}

TEST(WithoutSmallDifferences, AreTheSameFunctionWhateverTheFormula) {
    test::RandomNumbers random(71);
    int changed = 0;
    for (int i = 0; i < test::formulas_to_try(3000) && !testing::Test::HasFailure(); ++i) {
        const Expr f = test::random_expression(random, 1 + i % 5);
        std::array<double, 3> step{0x1p-7, 0.0, 0.0};
        if (i % 3 == 1) step = {0.0, 0x1p-14, 0.0};
        if (i % 3 == 2) step = {0x1p-10, -0x1p-11, 0x1p-12};
        const Difference difference = difference_of(f, step);
        changed += difference.plain.key() != difference.written.key() ? 1 : 0;
        for (int point = 0; point < 8; ++point) {
            std::array<double, 4> at{};
            for (double& coordinate : at)
                coordinate = point < 4 ? random.uniform(-2, 2) : random.between(-2, 2);
            expect_same_function(difference, at);
        }
    }
    EXPECT_GT(changed, 200);
}

TEST(WithoutSmallDifferences, AreAccurate) {
    const Expr difference = *parse(
        "(sin(5*x + 0.000001)*sqrt(1 + (x + 0.000001)^2)"
        " - sin(5*x)*sqrt(1 + x^2))/0.000001");
    const std::array at{0.3, 0.0, 0.0, 0.0};
    const double exact = test::reference(difference, at).value.nearest();
    const double plain = value_at(difference, at).value;
    const double written = value_at(without_small_differences(difference), at).value;
    EXPECT_GT(std::abs(plain - exact), 1e-12);
    EXPECT_LT(std::abs(written - exact), 1e-15);
}

}  // namespace
}  // namespace zeroset::differences_test
