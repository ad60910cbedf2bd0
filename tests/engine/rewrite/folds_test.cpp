#include "engine/language/parse.hpp"
#include "engine/rewrite/passes.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zeroset::folds_test {
namespace {

bool has_fold(const Expr& f) {
    return std::ranges::any_of(f.nodes(), [](const Node& node) { return node.op == Op::Fold; });
}

TEST(WithFolds, CentredRemaindersAreContinuous) {
    for (const char* text : {"abs(mod(x, 2) - 1)", "abs(mod(x + 1, 2) - 1)", "(mod(x, 1) - 0.5)^2",
                             "(0.125 - mod(3x - y, 0.25))^4", "abs(-1/2 + mod(y^2 - 3, 1))"}) {
        const Expr f = *parse(text);
        const Expr folded = with_folds(f);
        EXPECT_TRUE(has_fold(folded)) << text;
        EXPECT_TRUE(has_fold(with_folds(*parse(folded.canonical())))) << folded.canonical();
        for (double x = -3.5; x < 4; x += 0.11) {
            const std::array<double, 4> at{x, 0.7 - 2 * x, 0, 0};
            const test::MpfrNumber error =
                test::reference(f, at).value - test::reference(folded, at).value;
            EXPECT_LT(std::abs(error.nearest()), 1e-60) << text << " at " << x;
        }
    }
}

TEST(WithFolds, OtherRemaindersStay) {
    for (const char* text : {"abs(mod(x, 2) - 0.9)", "(mod(x, 1) - 0.5)^3", "mod(x, 2) - 1",
                             "abs(mod(x, -2) + 1)", "abs(mod(x, y) - y/2)"})
        EXPECT_FALSE(has_fold(with_folds(*parse(text)))) << text;
}

}  // namespace
}  // namespace zeroset::folds_test
