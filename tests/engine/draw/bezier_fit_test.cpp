#include "engine/draw/page_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace zeroset::test::bezier_fit_test {
namespace {

std::vector<PagePoint> circle(double radius, std::size_t points) {
    std::vector<PagePoint> result;
    for (std::size_t i = 0; i <= points; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
        result.push_back({.place = radius * glm::dvec2(std::cos(angle), std::sin(angle)),
                          .tangent = {-std::sin(angle), std::cos(angle)}});
    }
    return result;
}

TEST(BezierFit, PiecesOfACircleAreWithinTheTolerance) {
    for (const double tolerance : {0.5, 0.05, 0.005, 0.0005}) {
        const std::vector<Bezier> pieces = fitted(circle(100.0, 1000), tolerance);
        EXPECT_LE(pieces.size(), 12U);
        for (const Bezier& piece : pieces) {
            for (int i = 0; i <= 100; ++i)
                EXPECT_NEAR(glm::length(point_of(piece, 0.01 * i)), 100.0, tolerance);
        }
    }
}

TEST(BezierFit, PiecesMeetWithOneDirection) {
    const std::vector<Bezier> pieces = fitted(circle(100.0, 1000), 0.01);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Bezier& next = pieces[(i + 1) % pieces.size()];
        EXPECT_LT(glm::distance(pieces[i][3], next[0]), 1e-9);
        const glm::dvec2 before = glm::normalize(pieces[i][3] - pieces[i][2]);
        const glm::dvec2 after = glm::normalize(next[1] - next[0]);
        EXPECT_GT(glm::dot(before, after), 1.0 - 1e-9);
    }
}

TEST(BezierFit, OneCubicIsFoundAgain) {
    const Bezier curve{glm::dvec2(0, 0), {30, 50}, {80, -20}, {100, 10}};
    std::vector<PagePoint> points;
    for (int i = 0; i <= 60; ++i) {
        const double t = i / 60.0;
        const double r = 1.0 - t;
        const glm::dvec2 slope = r * r * (curve[1] - curve[0]) +
                                 2.0 * r * t * (curve[2] - curve[1]) +
                                 t * t * (curve[3] - curve[2]);
        points.push_back({.place = point_of(curve, t), .tangent = glm::normalize(slope)});
    }
    const std::vector<Bezier> pieces = fitted(points, 0.02);
    EXPECT_LE(pieces.size(), 3U);
}

TEST(BezierFit, TwoPointsMakeALine) {
    const std::vector<PagePoint> points{{.place = {0, 0}, .tangent = {1, 0}},
                                        {.place = {3, 0}, .tangent = {1, 0}}};
    const std::vector<Bezier> pieces = fitted(points, 0.05);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(point_of(pieces[0], 0.5), glm::dvec2(1.5, 0));
}

}  // namespace
}  // namespace zeroset::test::bezier_fit_test
