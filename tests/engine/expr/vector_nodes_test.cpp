// Vectors of nodes: their products, and that known zeros and ones leave nothing behind.

#include "engine/expr/vector_nodes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::vector_nodes_test {
namespace {

class VectorNodesTest : public testing::Test {
protected:
    VectorNodes vector(double x, double y, double z) {
        return {builder_.constant(x), builder_.constant(y), builder_.constant(z)};
    }
    std::string text(NodeId id) { return builder_.text(id, {}, longest_text); }

    ExprBuilder builder_;
};

TEST_F(VectorNodesTest, CrossIsAtRightAngles) {
    const VectorNodes product = make_cross(builder_, vector(1, 0, 0), make_place(builder_));
    EXPECT_EQ(text(product[0]), "0");
    EXPECT_EQ(text(product[1]), "-z");
    EXPECT_EQ(text(product[2]), "y");
}

TEST_F(VectorNodesTest, DotLeavesOutZeros) {
    EXPECT_EQ(text(make_dot(builder_, vector(0, 1, 2), make_place(builder_))), "y + 2*z");
    EXPECT_EQ(text(make_dot(builder_, vector(0, 0, 0), make_place(builder_))), "0");
}

TEST_F(VectorNodesTest, LengthIsOfSquares) {
    const VectorNodes place = make_place(builder_);
    EXPECT_EQ(text(make_length(builder_, place)), "sqrt(x^2 + y^2 + z^2)");
    EXPECT_EQ(text(make_unit(builder_, place)[1]), "y/sqrt(x^2 + y^2 + z^2)");
}

TEST_F(VectorNodesTest, SumsAndMultiplesGoPartByPart) {
    const VectorNodes place = make_place(builder_);
    EXPECT_EQ(text(make_sum(builder_, place, vector(0, 1, 2))[1]), "y + 1");
    EXPECT_EQ(text(make_difference(builder_, vector(0, 1, 2), place)[0]), "-x");
    EXPECT_EQ(text(make_scaled(builder_, builder_.constant(3.0), place)[2]), "3*z");
}

}  // namespace
}  // namespace zeroset::vector_nodes_test
