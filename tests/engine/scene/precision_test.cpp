#include "engine/scene/precision.hpp"

#include "engine/view/camera.hpp"

#include <gtest/gtest.h>

#include <string>

// Which type a view is traced in, and how finely.

namespace zeroset::test::precision_test {
namespace {

constexpr StopCriterion finest{StopRule::DStop, 22.0};
constexpr StopCriterion interactive{StopRule::DStop, 14.0};

ViewFrame view_from(double distance, const glm::dvec3& look_at = glm::dvec3(0.0)) {
    return ViewFrame({look_at + glm::dvec3(0, distance, 0), look_at, {0, 0, 1}, 0.7});
}

Box box_at(const glm::dvec3& centre, double half) { return {centre - half, centre + half}; }

TEST(SearchDepth, IsDStopWhereTheWholeBoxIsSeen) {
    const Box box = Box::cube(2);
    for (const double distance : {4.0, 3.0, 2.1, 16.0, 1e6}) {
        const SearchDepth depth = search_depth(box, view_from(distance), interactive);
        EXPECT_EQ(depth.wanted, 14) << distance;
        EXPECT_EQ(depth.deeper, 0) << distance;
    }
}

TEST(SearchDepth, FollowsTheView) {
    const Box box = Box::cube(2);
    EXPECT_EQ(search_depth(box, view_from(2.0), interactive).wanted, 15);
    EXPECT_EQ(search_depth(box, view_from(0.5), interactive).wanted, 17);
    EXPECT_EQ(search_depth(box, view_from(4.0 * 0x1p-30), interactive).deeper, 30);
    EXPECT_EQ(search_depth(box, view_from(4.0 * 0x1p-30), {StopRule::Delta, 1e-3}).wanted, 52);
}

TEST(DeepestHalving, LeavesCellsOfAFewUlp) {
    EXPECT_EQ(deepest_halving(Box::cube(2), 2.0, 24), 22);
    EXPECT_EQ(deepest_halving(Box::cube(1.9), 1.9, 24), 22);
    EXPECT_EQ(deepest_halving(Box::cube(2), 2.0, 53), 51);
    EXPECT_EQ(deepest_halving(box_at({1000, 0, 0}, 0.5), 1000.5, 24), 12);
    EXPECT_EQ(deepest_halving(box_at({1, 0, 0}, 1e-30), 1.0, 53), 1);
}

TEST(WantedPrecision, IsFloatForOrdinaryViewsAtAnyDStop) {
    for (const double half : {1e-6, 1.0, 1.1, 3.0, 1e6}) {
        const Box box = Box::cube(half);
        for (const double distance : {1.1, 2.0, 8.0, 100.0}) {
            const ViewFrame view = view_from(2.0 * half * distance);
            EXPECT_EQ(wanted_precision(box, view, finest), Precision::Float) << half;
        }
    }
    const Box off_centre{{1, 0, -1}, {3, 2, 1}};
    EXPECT_EQ(wanted_precision(off_centre, view_from(5, {2, 1, 0}), finest), Precision::Float);
}

TEST(WantedPrecision, IsDoubleBeyondTheFinestDStop) {
    const Box box = Box::cube(2);
    for (const double levels : {23.0, 30.0, 53.0}) {
        EXPECT_EQ(wanted_precision(box, view_from(8), {StopRule::DStop, levels}),
                  Precision::Double);
    }
}

TEST(WantedPrecision, IsDoubleForABoxFarFromTheOrigin) {
    for (const double half : {1e-3, 1e-9, 1e-15}) {
        const Box box = box_at({0.3, -1.2, 0.7}, half);
        const ViewFrame view = view_from(5.0 * half, box.centre());
        EXPECT_EQ(wanted_precision(box, view, interactive), Precision::Double) << half;
    }
    const Box near = box_at({0.3, -1.2, 0.7}, 1e-3);
    const StopCriterion coarse{StopRule::DStop, 4.0};
    EXPECT_EQ(wanted_precision(near, view_from(5e-3), coarse), Precision::Float);
}

TEST(WantedPrecision, IsDoubleForADeepViewInALargeBox) {
    const Box box = Box::cube(2);
    EXPECT_EQ(wanted_precision(box, view_from(1.0), interactive), Precision::Float);
    EXPECT_EQ(wanted_precision(box, view_from(0.4), interactive), Precision::Double);
    EXPECT_EQ(wanted_precision(box, view_from(1e-9), interactive), Precision::Double);
    EXPECT_EQ(wanted_precision(box, view_from(2.0), finest), Precision::Double);
}

TEST(Precision, HasNames) {
    EXPECT_EQ(std::string(name_of(Precision::Float)), "float");
    EXPECT_EQ(std::string(name_of(Precision::Double)), "double");
}

}  // namespace
}  // namespace zeroset::test::precision_test
