#include "pipeline/formula.hpp"

#include "engine/real/rounding.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

// Tests of making machine code of a text, and of the messages about a wrong text.

namespace zeroset::test::formula_test {
namespace {

/// Returns the value for w = 0.
float value_at(const Kernel& kernel, float x, float y, float z) {
    const UpwardRounding upward;
    Uniforms uniforms;
    uniforms.set(0, 0.0);
    std::array<std::array<float, batch_multiple>, 7> columns{};
    columns[0].fill(x);
    columns[1].fill(y);
    columns[2].fill(z);
    kernel.in_float.value({batch_multiple,
                           {columns[0].data(), columns[1].data(), columns[2].data()},
                           uniforms.middle.data(),
                           columns[3].data(),
                           {columns[4].data(), columns[5].data(), columns[6].data()}});
    return columns[3][0];
}

TEST(CompileFormula, MakesCodeThatRuns) {
    const auto formula = compile_formula("x^2 + y^2 = z + w");
    ASSERT_TRUE(formula) << formula.error().reason;
    ASSERT_EQ(formula->kernels.size(), 1);
    EXPECT_TRUE(formula->uses_w());
    EXPECT_EQ(formula->code, CodeState::Machine);
    EXPECT_EQ(formula->text, "x^2 + y^2 = z + w");
    EXPECT_GT(formula->compile_ms, 0.0);

    Uniforms uniforms;
    uniforms.set(0, 4.0);
    float x[batch_multiple];
    float y[batch_multiple];
    float z[batch_multiple];
    float f[batch_multiple];
    float slope[3][batch_multiple];
    for (std::size_t i = 0; i < batch_multiple; ++i) {
        x[i] = static_cast<float>(i);
        y[i] = 2.0F;
        z[i] = -1.0F;
    }
    const UpwardRounding upward;
    formula->kernels[0].in_float.value(
        {batch_multiple, {x, y, z}, uniforms.middle.data(), f, {slope[0], slope[1], slope[2]}});
    for (std::size_t i = 0; i < batch_multiple; ++i) {
        EXPECT_EQ(f[i], x[i] * x[i] + 1.0F);
        EXPECT_EQ(slope[0][i], 2.0F * x[i]);
        EXPECT_EQ(slope[1][i], 4.0F);
        EXPECT_EQ(slope[2][i], -1.0F);
    }
}

TEST(CompileFormula, KnowsWhetherWMatters) {
    EXPECT_FALSE(compile_formula("x + y").value().uses_w());
    EXPECT_TRUE(compile_formula("x*w").value().uses_w());
}

TEST(CompileFormula, MakesCodeInDoubleOnDemand) {
    const auto formula = compile_formula("x^2 + y = z; z = 2");
    ASSERT_TRUE(formula);
    EXPECT_TRUE(formula->has_code(Precision::Float));
    EXPECT_FALSE(formula->has_code(Precision::Double));
    const Formula deep = with_double(*formula);
    EXPECT_TRUE(deep.has_code(Precision::Double));
    EXPECT_EQ(deep.code, CodeState::Machine);
    ASSERT_EQ(deep.kernels.size(), 2);
    EXPECT_EQ(deep.kernels[1].in_float.range, formula->kernels[1].in_float.range);
    const auto at_once = compile_formula("x^2 + y = z; z = 2", {}, Precision::Double);
    EXPECT_TRUE(at_once.value().has_code(Precision::Double));
}

std::string union_of(int count) {
    std::string text = "min(";
    for (int i = 1; i <= count; ++i)
        text += (i == 1 ? "" : ", ") + ("x + y*z - " + std::to_string(i) + "z/50");
    return text + ")";
}

TEST(CompileFormula, SpecializesWhereManyChoicesMakeItPay) {
    const Formula few = compile_formula(union_of(20)).value();
    EXPECT_EQ(few.code, CodeState::Machine);
    EXPECT_EQ(few.kernels[0].specializer, nullptr);
    EXPECT_FALSE(few.kernels[0].interpreted);
    for (const int count : {45, 100, 2000}) {
        const Formula many = compile_formula(union_of(count)).value();
        EXPECT_EQ(many.code, CodeState::Machine);
        EXPECT_NE(many.kernels[0].specializer, nullptr);
        EXPECT_TRUE(many.kernels[0].interpreted);
        EXPECT_FALSE(many.has_code(Precision::Double));
    }
}

TEST(CompileFormula, MakesCodeOfPartsBesideThatOfAll) {
    const Formula two =
        compile_formula(union_of(100) + " = 0; z = x", {}, Precision::Double).value();
    EXPECT_EQ(two.code, CodeState::Machine);
    EXPECT_TRUE(two.has_code(Precision::Double));
    EXPECT_TRUE(two.kernels[0].interpreted);
    EXPECT_FALSE(two.kernels[1].interpreted);
}

/// Returns how the formula is drawn at first; checks that machine code can be made of it.
CodeState first_code(const std::string& text) {
    const Formula formula = prepared_formula(text, Box::cube(2.0)).value();
    EXPECT_TRUE(with_machine_code(formula).has_value());
    return formula.code;
}

TEST(CompileFormula, CompilesNothingWhereANumberChangesAgain) {
    EXPECT_EQ(first_code("x^3 y + 2y^2 z = 3"), CodeState::InterpretedFirst);
    EXPECT_EQ(first_code("x^3 y + 2y^2 z = 3.5"), CodeState::InterpretedFirst);
    EXPECT_EQ(first_code("x^3 y + 2y^2 z = 3.55"), CodeState::Machine);
    EXPECT_EQ(first_code("x^3 y + 2y^2 z = 3.6"), CodeState::Machine);
    EXPECT_EQ(first_code("x^3 y + 2y^2 z = 3"), CodeState::Machine);
    EXPECT_EQ(first_code("x^3 y + 4y^2 z = 3"), CodeState::InterpretedFirst) << "another number";
    EXPECT_EQ(first_code("x^3 y + 7y^2 z = 5"), CodeState::Machine) << "both have changed before";
    EXPECT_EQ(first_code("x^4 y + 7y^2 z = 5"), CodeState::InterpretedFirst) << "another shape";
}

TEST(CompileFormula, CodeOfAShapeHasTheNumbersOfEachFormula) {
    const Formula one = compile_formula("x - 3z + y; x - 5z + y; x - 7z + y", {}).value();
    ASSERT_EQ(one.kernels.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(value_at(one.kernels[i], 0.5F, 0.25F, 1.0F),
                  0.75F - (3.0F + 2.0F * static_cast<float>(i)));
    }
}

TEST(CompileFormula, CompilesAllOfWhatLeavesLittleOut) {
    std::string text = "x + y*z";
    for (int k = 1; k <= 30; ++k) {
        const std::string factor = std::to_string(k);
        text += " + max(sin(" + factor + "x), cos(" + factor + "y z))/" + factor;
    }
    const Formula formula = compile_formula(text).value();
    EXPECT_FALSE(formula.kernels[0].interpreted);
    EXPECT_EQ(formula.kernels[0].specializer, nullptr);
}

TEST(CompileFormula, RefusesWhatIsNoSurface) {
    for (const char* text : {"", "  ", "1 = 2", "w^2 = 1", "sqrt(2)"}) {
        const auto formula = compile_formula(text);
        ASSERT_FALSE(formula) << text;
        EXPECT_FALSE(formula.error().reason.empty());
    }
}

TEST(ReadFormula, SaysWhere) {
    const auto expr = read_formula("x +\n  y ) + z");
    ASSERT_FALSE(expr);
    EXPECT_EQ(expr.error().column, 5U);
    EXPECT_EQ(expr.error().line, "  y ) + z");
    EXPECT_EQ(expr.error().reason.find('\n'), std::string::npos);
}

TEST(Describe, IsOneLineWithoutAPlace) {
    EXPECT_EQ(describe({"no such file", std::nullopt, {}}), "error: no such file\n");
}

TEST(Describe, PutsACaretUnderThePlace) {
    EXPECT_EQ(describe({"bad", 3, "x + y"}), "error: bad\n  x + y\n    ^\n");
    EXPECT_EQ(describe({"bad", 6, "x + y"}), "error: bad\n  x + y\n       ^\n");
}

TEST(Describe, CountsCharactersNotBytes) {
    EXPECT_EQ(describe({"bad", 3, "\u00e9\u2212)"}), "error: bad\n  \u00e9\u2212)\n    ^\n");
}

TEST(Describe, ShortensALongLine) {
    const std::string text = describe({"bad", 5000, std::string(10'000, 'x')});
    EXPECT_LT(text.size(), 300U);
    EXPECT_NE(text.find("^\n"), std::string::npos);
}

}  // namespace
}  // namespace zeroset::test::formula_test
