#include "engine/distance/surface_piece.hpp"

#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace zeroset::test::surface_piece_test {
namespace {

glm::dvec3 random_point(RandomNumbers& random, double reach) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach),
            random.uniform(-reach, reach)};
}

SurfacePiece random_piece(RandomNumbers& random) {
    SurfacePiece piece;
    const glm::dvec3 middle = random_point(random, 5);
    const glm::dvec3 half(random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
    piece.box = {.lo = middle - half, .hi = middle + half};
    piece.normal = random_point(random, 1);
    if (random.one_in(4)) piece.normal.x = 0;
    piece.normal /= glm::length(piece.normal);
    piece.offset = random.uniform(-0.5, 0.5);
    piece.half_width = random.one_in(3) ? 0.0 : random.uniform(0, 0.02);
    piece.crosses = true;
    return piece;
}

/// The distance to the slab in the box, from points of it that many alternating projections find
/// (Dykstra's algorithm), which nothing of the tested code takes part in.
std::optional<double> slab_distance(const SurfacePiece& piece, const glm::dvec3& point) {
    const glm::dvec3 middle = 0.5 * (piece.box.lo + piece.box.hi);
    glm::dvec3 x = point;
    glm::dvec3 box_step(0.0);
    glm::dvec3 slab_step(0.0);
    for (int n = 0; n < 20'000; ++n) {
        const glm::dvec3 in_box = glm::clamp(x + box_step, piece.box.lo, piece.box.hi);
        box_step = x + box_step - in_box;
        const glm::dvec3 from = in_box + slab_step;
        const double level = glm::dot(piece.normal, from - middle) - piece.offset;
        const double over = level - std::clamp(level, -piece.half_width, piece.half_width);
        x = from - over * piece.normal;
        slab_step = from - x;
    }
    const glm::dvec3 off = x - glm::clamp(x, piece.box.lo, piece.box.hi);
    if (glm::length(off) > 1e-7) return std::nullopt;  // they do not meet, or barely
    return glm::length(x - point);
}

TEST(SurfacePiece, BoundsAreTheDistancesToTheSlabInTheBox) {
    RandomNumbers random(71);
    int met = 0;
    int crossed = 0;
    for (int n = 0; n < 400; ++n) {
        const SurfacePiece piece = random_piece(random);
        const glm::dvec3 point = random_point(random, 7);
        const DistanceBounds bounds = piece.distance(point);
        const auto truth = slab_distance(piece, point);
        if (!truth) continue;
        ++met;
        EXPECT_NEAR(bounds.lo, *truth, 1e-5) << n;
        if (!std::isfinite(bounds.hi)) continue;
        ++crossed;
        EXPECT_GE(bounds.hi, *truth - 1e-5);
        EXPECT_LE(bounds.hi, *truth + (piece.half_width == 0 ? 1e-5 : 0.2)) << n;
    }
    EXPECT_GT(met, 250);
    EXPECT_GT(crossed, 200);
}

TEST(HullOf, IsNoFartherThanAnyPiece) {
    RandomNumbers random(72);
    for (int n = 0; n < 300; ++n) {
        std::vector<SurfacePiece> pieces;
        for (int i = 0; i <= n % 7; ++i) {
            SurfacePiece piece = random_piece(random);
            if (random.one_in(6)) piece.normal = glm::dvec3(0.0);
            if (!piece.is_empty()) pieces.push_back(piece);
        }
        if (pieces.empty()) continue;
        const SurfacePiece hull = hull_of(pieces);
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 point = random_point(random, 7);
            for (const SurfacePiece& piece : pieces)
                EXPECT_LE(hull.distance(point).lo, piece.distance(point).lo + 1e-9) << n;
        }
    }
}

TEST(HullOf, IsThinWherePiecesLieInLine) {
    std::vector<SurfacePiece> pieces;
    for (int i = 0; i < 8; ++i) {
        const double x = 0.1 * i;
        // Boxes along the parabola z = x^2 / 10, with slabs along its tangents.
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-x / 5, 0, 1));
        const glm::dvec3 middle(x, 0, x * x / 10);
        pieces.push_back({.box = {.lo = middle - 0.05, .hi = middle + 0.05},
                          .normal = i % 3 == 0 ? -normal : normal,
                          .half_width = 0.001});
    }
    const SurfacePiece hull = hull_of(pieces);
    EXPECT_LT(hull.half_width, 0.02);
    EXPECT_GT(hull.distance({0.35, 0, 1}).lo, 0.95);
    EXPECT_FALSE(std::isfinite(hull.distance({0.35, 0, 1}).hi));
}

TEST(SurfacePiece, KnowsWhereItsSlabMissesItsBox) {
    SurfacePiece piece{.box = Box::cube(1), .normal = {1, 0, 0}, .offset = 1.5, .half_width = 0.4};
    EXPECT_TRUE(piece.is_empty());
    piece.half_width = 0.6;
    EXPECT_FALSE(piece.is_empty());
    EXPECT_FALSE(SurfacePiece{.box = Box::cube(1)}.is_empty());
}

TEST(SurfacePiece, WithoutASlabIsItsBox) {
    SurfacePiece piece{.box = Box::cube(1)};
    EXPECT_NEAR(piece.distance({4, 5, 0}).lo, 5, 1e-11);
    EXPECT_FALSE(std::isfinite(piece.distance({4, 5, 0}).hi));
    piece.has_zero = true;
    EXPECT_NEAR(piece.distance({4, 5, 0}).hi, std::sqrt(25 + 36 + 1), 1e-11);
}

}  // namespace
}  // namespace zeroset::test::surface_piece_test
