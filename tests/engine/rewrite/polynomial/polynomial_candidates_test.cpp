#include "engine/rewrite/polynomial/polynomial_candidates.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset::polynomial_candidates_test {
namespace {

/// All forms of the whole formula.
std::vector<Expr> candidates(const Expr& expr) {
    const auto facts = facts_of(expr);
    const UpwardRounding upward;
    const Expansion expansion = expand(expr, facts);
    ExprBuilder builder;
    const std::vector<NodeId> now = copy_nodes(builder, expr);
    std::vector<Expr> result;
    for (const NodeId id :
         polynomial_candidates(builder, {expr, facts, expansion}, now, expr.root(), 2000))
        result.push_back(builder.finish(id));
    return result;
}

TEST(PolynomialCandidates, AllHaveTheSameValues) {
    constexpr std::array at{0.7, -1.3, 1.9, 0.4};
    for (const char* text :
         {"x^2 + x + x^4 - y", "sin(x)^2 + 3*sin(x) + sin(x)^4 - sqrt(z)",
          "x^8 - x^6 + 0.3*x^3 - y*x",
          "4*(x^4 + (y^2+z^2)^2) + 17*x^2*(y^2+z^2) - 20*(x^2+y^2+z^2) + 17",
          "-(x^2 + y^2)^2*z + 3*(x^2 + y^2)*w - x/7", "(x + y - 0.1)^3*(z - 2*x)^2 - (z - w)^5"}) {
        const auto expr = parse(text);
        ASSERT_TRUE(expr);
        const double value = test::reference(*expr, at).value.nearest();
        const std::vector<Expr> forms = candidates(*expr);
        EXPECT_GE(forms.size(), 9U) << text;
        for (const Expr& form : forms) {
            EXPECT_NEAR(test::reference(form, at).value.nearest(), value,
                        1e-12 * (1 + std::abs(value)))
                << text << "\n"
                << form.canonical();
        }
    }
}

TEST(PolynomialCandidates, AreNoneWhereSignsOfCoefficientsAreUnknown) {
    EXPECT_TRUE(candidates(*parse("0.1*x*3 + y - 0.3*x")).empty());
    EXPECT_FALSE(candidates(*parse("0.1*x*3 + y - 0.2*x")).empty());
}

TEST(PolynomialCandidates, DoNotGrowWithSharedSums) {
    ExprBuilder builder;
    NodeId node = builder.apply(Op::Sin, builder.variable(0));
    for (int i = 0; i < 100; ++i)
        node = builder.apply(Op::Add, node, node);
    EXPECT_LT(candidates(builder.finish(node)).size(), 100U);
}

}  // namespace
}  // namespace zeroset::polynomial_candidates_test
