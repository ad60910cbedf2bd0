#include "engine/tape/shape_memory.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/kernel_batch.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zeroset::test::shape_memory_test {
namespace {

std::vector<Expr> parsed(const std::vector<std::string>& texts) {
    std::vector<Expr> result;
    for (const std::string& text : texts) {
        const auto expr = parse(text);
        EXPECT_TRUE(expr) << text;
        if (expr) result.push_back(*expr);
    }
    return result;
}

/// The shape of the only text, as text; empty where it has none.
std::string shape_of(ShapeMemory& memory, const std::string& text) {
    const auto shapes = memory.shape(parsed({text}));
    if (shapes.size() != 1 || !shapes[0]) return "";
    return shapes[0]->shape.expr.key();
}

TEST(ShapeMemory, HasNoShapeForWhatIsNew) {
    ShapeMemory memory;
    EXPECT_EQ(shape_of(memory, "x^2 + y^2 - 3"), "");
    EXPECT_EQ(shape_of(memory, "x^2 + y^2 - 3"), "") << "equal to what is known";
    EXPECT_EQ(shape_of(memory, "x^2 + y^3 - 3"), "") << "a power is no constant";
}

TEST(ShapeMemory, ANumberThatChangesAgainChangesNothing) {
    ShapeMemory memory;
    shape_of(memory, "2x^2 + 5y^2 - 3");
    const std::string shape = shape_of(memory, "2x^2 + 5y^2 - 4");
    EXPECT_NE(shape, "");
    EXPECT_EQ(shape_of(memory, "2x^2 + 5y^2 - 4.5"), shape);
    EXPECT_EQ(shape_of(memory, "2x^2 + 5y^2 - 3"), shape) << "back again";
    const std::string two = shape_of(memory, "2x^2 + 7y^2 - 3");
    EXPECT_NE(two, shape);
    EXPECT_EQ(shape_of(memory, "2x^2 + 8y^2 - 9"), two);
}

TEST(ShapeMemory, GraphsOfOneTextShareTheirShape) {
    ShapeMemory memory;
    const auto shapes = memory.shape(parsed({"x^2 + y - 3", "sin(x) - 3", "x^2 + y - 4"}));
    ASSERT_EQ(shapes.size(), 3U);
    ASSERT_TRUE(shapes[0] && shapes[2]);
    EXPECT_FALSE(shapes[1]);
    EXPECT_EQ(shapes[0]->shape.expr.key(), shapes[2]->shape.expr.key());
}

TEST(ShapeMemory, ForgetsWhatIsOld) {
    ShapeMemory memory;
    shape_of(memory, "x^2 + y - 3");
    std::string other = "sin(z)";
    for (int i = 0; i < 100; ++i)
        shape_of(memory, other = "sin(" + other + ")");
    EXPECT_EQ(shape_of(memory, "x^2 + y - 4"), "");
}

TEST(ShapeMemory, ShapesHaveTheGraphsBits) {
    RandomNumbers random(17);
    for (const char* const text :
         {"3x^2 - y/7 + sin(2.5z) - 0.1", "if(x < 0.3, y - 0.2, a z - 3) w",
          "max((x - 0.5)^2, abs(y - 0.3)) - mod(z, 0.4)", "a/(x + 0.7) - 3atan2(y, 2z)"}) {
        std::string other = text;
        for (char& c : other) {
            if (c == '3') c = '5';
        }
        ShapeMemory memory;
        auto shapes = memory.shape(parsed({other, text}));
        ASSERT_EQ(shapes.size(), 2U);
        ASSERT_TRUE(shapes[1]) << text;
        shapes[1]->shape.kernel = interpret(shapes[1]->shape.expr);
        const Expr expr = parsed({text}).front();
        const Kernel kernel = kernel_of_shape(interpret(expr), std::move(*shapes[1]));
        EXPECT_FALSE(kernel.interpreted);
        EXPECT_EQ(kernel.parameters, interpret(expr).parameters);
        KernelBatch batch(random, 64);
        batch.uniforms.set(1, 0.75);
        const Bits shaped = batch.run(kernel);
        const Bits own = batch.run(interpret(expr));
        EXPECT_EQ(shaped.value, own.value) << text;
        EXPECT_EQ(shaped.range, own.range) << text;
        EXPECT_EQ(batch.run(kernel.without_waiting()).value, own.value) << text;
    }
}

}  // namespace
}  // namespace zeroset::test::shape_memory_test
