#include "engine/language/parse.hpp"
#include "engine/rewrite/passes.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zeroset::log_sums_test {
namespace {

bool has_log_sum(const Expr& f) {
    return std::ranges::any_of(f.nodes(), [](const Node& node) { return node.op == Op::LogSum; });
}

TEST(WithLogSums, SmoothMaximaHaveNoExponentials) {
    for (const char* text :
         {"ln(exp(x) + exp(y))", "ln(2 exp(9x - z) + 3 + exp(y)/4)", "log2(exp(x) exp(y) + 1)",
          "log10(exp(x) + exp(x + y) + exp(z) + exp(w))", "-1/8 ln(exp(-8x) + exp(-8(y - 1)))"}) {
        const Expr f = *parse(text);
        const Expr sums = with_log_sums(f);
        EXPECT_TRUE(has_log_sum(sums)) << text;
        for (const double x : {-1.5, 0.0, 0.25, 3.0}) {
            const std::array<double, 4> at{x, 0.5 - x, 0.75 * x, 1.0};
            const test::MpfrNumber error =
                test::reference(f, at).value - test::reference(sums, at).value;
            EXPECT_LT(std::abs(error.nearest()), 1e-50) << text << " " << sums.canonical();
        }
    }
}

TEST(WithLogSums, OtherLogarithmsStay) {
    for (const char* text : {"ln(exp(x) - exp(y))", "ln(x + exp(y))", "ln(exp(x) exp(y))",
                             "ln(exp(x) - 2)", "exp(x) + exp(y)"})
        EXPECT_FALSE(has_log_sum(with_log_sums(*parse(text)))) << text;
}

/// However far the exponentials are beyond the numbers' range.
TEST(WithLogSums, KnowTheValueWhereExponentialsOverflow) {
    const Expr f = with_log_sums(*parse("ln(exp(x) + exp(y))"));
    for (const double x : {-1e6, -2000.0, 0.0, 2000.0, 1e6}) {
        EXPECT_EQ(test::reference(f, {x, 1e5, 0, 0}).value.nearest(), std::max(x, 1e5));
    }
}

}  // namespace
}  // namespace zeroset::log_sums_test
