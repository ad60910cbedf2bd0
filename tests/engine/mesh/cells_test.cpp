#include "engine/mesh/cell_growth.hpp"
#include "engine/mesh/gradient_cone.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <cmath>

// The octree of a mesh and what enclosures tell of its cells.

namespace zeroset::test::cells_test {
namespace {

/// The least and the greatest distance of a box's points from the origin.
std::pair<double, double> distances(const Box& box) {
    const glm::dvec3 near = glm::clamp(glm::dvec3(0.0), box.lo, box.hi);
    return {glm::length(near), glm::length(glm::max(glm::abs(box.lo), glm::abs(box.hi)))};
}

CellTree grown(const MeshSolid& solid, double tolerance, int deepest) {
    CellTree tree(solid.box, deepest);
    CellGrowth growth(tree, solid, {.tolerance = tolerance, .most_cells = 1'000'000});
    growth.begin();
    EXPECT_FALSE(growth.is_cut());
    return tree;
}

TEST(CellTree, FindsLeavesAndNeighbours) {
    CellTree tree(Box::cube(1), 5);
    const std::uint32_t first = tree.split(0);
    const std::uint32_t inner = tree.split(first);
    const MeshCell& cell = tree[inner + 7];
    EXPECT_EQ(tree.width(cell), 16);
    EXPECT_EQ(tree.find(tree.middle(cell)), inner + 7);
    EXPECT_EQ(tree.find(cell.corner), inner + 7);
    EXPECT_EQ(tree.find(cell.corner - Place(1)), inner);
    EXPECT_EQ(tree.neighbour(cell, 0, -1), inner + 6);
    EXPECT_EQ(tree.neighbour(cell, 0, 1), first + 1);
    EXPECT_EQ(tree.neighbour(tree[first + 1], 0, -1), first);
    EXPECT_EQ(tree.neighbour(tree[first + 1], 0, 1), tree.size());
    std::vector<std::uint32_t> touching;
    tree.add_touching(cell, touching);
    EXPECT_EQ(touching.size(), 8U + 7U);
}

TEST(CellTree, HoldsTheBoxOffItsPlanes) {
    const Box box{.lo = {-1, 0, 2}, .hi = {2, 1, 4}};
    const CellTree tree(box, 10);
    const Box root = tree.box(tree[0]);
    EXPECT_NEAR(root.hi.x - root.lo.x, root_edge * 3, 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LT(root.lo[axis], box.lo[axis]);
        EXPECT_GT(root.hi[axis], box.hi[axis]);
        const double place = (box.lo[axis] - root.lo[axis]) / tree.step();
        EXPECT_GT(std::abs(place - std::round(place)), 1e-3);
    }
}

TEST(CellGrowth, TellsInsideFromOutside) {
    const UpwardRegisters upward;
    const MeshSolid ball = unit_ball();
    const CellTree tree = grown(ball, 0.01, 8);
    double volume = 0.0;
    std::size_t active = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const MeshCell& cell = tree[i];
        if (!cell.is_leaf()) continue;
        volume += std::pow(tree.edge(cell), 3);
        const auto [near, far] = distances(tree.box(cell));
        switch (cell.facts.side) {
            case BoxSide::Inside: EXPECT_LT(far, 1.0); break;
            case BoxSide::Outside: EXPECT_GT(near, 1.0); break;
            case BoxSide::Unknown:
                ++active;
                EXPECT_GE(int{cell.level}, least_level);
                EXPECT_FALSE(cell.uncertain);
                break;
        }
    }
    EXPECT_NEAR(volume, std::pow(root_edge * 4, 3), 1e-9 * volume);
    EXPECT_GT(active, 100U);
}

TEST(CellGrowth, KeepsActiveCellsBesideOnesOfLikeSize) {
    const UpwardRegisters upward;
    const CellTree tree = grown(solid_of({"x^2 + y^2 - z^2"}, Box::cube(1)), 0.02, 8);
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const MeshCell& cell = tree[i];
        if (!cell.is_leaf() || !cell.is_active()) continue;
        for (int face = 0; face < 6; ++face) {
            const std::uint32_t other = tree.neighbour(cell, face / 2, face % 2 == 0 ? -1 : 1);
            ASSERT_LT(other, tree.size()) << "the border is not proved to be outside";
            EXPECT_GE(tree[other].level + 1, cell.level);
        }
    }
}

TEST(CellGrowth, EndsWithTheRoomForCellsAndTheTime) {
    const UpwardRegisters upward;
    const MeshSolid ball = unit_ball();
    for (const bool by_time : {false, true}) {
        CellTree tree(ball.box, 12);
        GrowthLimits limits{.tolerance = 1e-4, .most_cells = by_time ? 1'000'000U : 2'000U};
        if (by_time) limits.work.limit.until = TimeLimit::Clock::time_point();
        CellGrowth growth(tree, ball, limits);
        growth.begin();
        EXPECT_TRUE(growth.is_cut());
        EXPECT_LE(tree.size(), 2'000U);
        for (std::size_t i = 0; i < tree.size(); ++i)
            EXPECT_TRUE(!tree[i].is_leaf() || !tree[i].is_active() || tree[i].level >= least_level);
    }
}

TEST(CellGrowth, LeavesASurfaceOfUnprovedCellsAsItIs) {
    const UpwardRegisters upward;
    // The gradient vanishes all over the surface.
    const MeshSolid solid = solid_of({"(x^2 + y^2 + z^2 - 1)^3"}, Box::cube(2));
    CellTree tree(solid.box, 12);
    CellGrowth growth(tree, solid,
                      {.tolerance = 1e-3, .most_cells = 1'000'000, .most_uncertain = 1'000});
    growth.begin();
    EXPECT_TRUE(growth.is_dense());
    EXPECT_FALSE(growth.is_cut());
    EXPECT_LT(tree.size(), 20'000U);
}

TEST(GradientCone, FindsADirectionOrNone) {
    const UpwardRegisters upward;
    const auto about = [](const glm::dvec3& g, double half) {
        return GradientBox{.lo = g - half, .hi = g + half};
    };
    const std::vector<GradientBox> apart{about({1, 0, 0}, 0.1), about({0, 5, 0}, 0.5),
                                         about({0, 0, 0.01}, 0.001)};
    const auto direction = common_rise(apart);
    ASSERT_TRUE(direction);
    for (const GradientBox& gradient : apart)
        EXPECT_GT(least_slope(gradient, *direction), 0);
    const std::vector<GradientBox> against{about({1, 0, 0}, 0.1), about({-1, 0, 0}, 0.1)};
    EXPECT_FALSE(common_rise(against));
    const std::vector<GradientBox> around_nothing{about({0.1, 0, 0}, 0.2)};
    EXPECT_FALSE(common_rise(around_nothing));
    EXPECT_LE(least_slope({.lo = {-1, 2, 0}, .hi = {1, 3, 0}}, {0.6, 0.8, 0}), 1.0);
    EXPECT_NEAR(least_slope({.lo = {-1, 2, 0}, .hi = {1, 3, 0}}, {0.6, 0.8, 0}), 1.0, 1e-12);
}

}  // namespace
}  // namespace zeroset::test::cells_test
