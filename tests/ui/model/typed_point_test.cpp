// Tests of reading a point as people type it.

#include "ui/model/typed_point.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace zeroset::ui::typed_point_test {
namespace {

TEST(TypedPoint, IsReadAsPeopleTypeIt) {
    for (const char* typed : {"1.5,-2,3e-1", "1.5, -2, 0.3", "(1.5, -2, 0.3)", "[1.5 -2 0.3]",
                              "1,5; -2; 0,3", " 1,5  -2   0,3 ",
                              "+1.5; \xE2\x88\x92"
                              "2; .3",
                              "{ 1.5 ; -2 ; 0.3 }", "1,5 -2,0 0.3"}) {
        const auto point = point_typed(typed);
        ASSERT_TRUE(point) << typed;
        EXPECT_EQ(*point, glm::dvec3(1.5, -2.0, 0.3)) << typed;
    }
}

TEST(TypedPoint, IsNothingElse) {
    for (const char* typed :
         {"",          " ",      "()",    "1",       "1,2",     "1 2",     "1,2,3,4", "1 2 3 4",
          "1;2;3;4",   "1,2,",   "1,,2",  "1,2,x",   "x,y,z",   "1,2,nan", "1,2,inf", "1,2,1e31",
          "1,2,1e999", "1,2,3)", "1.2.3", "1,2,3 4", "--1,2,3", "1,2,0x3"}) {
        EXPECT_EQ(point_typed(typed), std::nullopt) << typed;
    }
}

}  // namespace
}  // namespace zeroset::ui::typed_point_test
