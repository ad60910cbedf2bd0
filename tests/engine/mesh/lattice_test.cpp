#include "engine/mesh/cell_growth.hpp"
#include "engine/mesh/contour.hpp"
#include "engine/mesh/feature_point.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/mesh/star_proof.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/mesh_checks.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

// Tetrahedra between cells, the proof held against them, and the triangles in them.

namespace zeroset::test::lattice_test {
namespace {

struct Stages {
    MeshSolid solid;
    CellTree tree;
    Lattice lattice;
};

Stages stages_of(MeshSolid solid, double tolerance, int deepest) {
    CellTree tree(solid.box, deepest);
    CellGrowth growth(tree, solid, {.tolerance = tolerance, .most_cells = 1'000'000});
    growth.begin();
    Lattice lattice = make_lattice(tree, solid, {});
    return {.solid = std::move(solid), .tree = std::move(tree), .lattice = std::move(lattice)};
}

double volume_of(const Lattice& lattice, const Tetrahedron& t) {
    std::array<glm::dvec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i)
        p[i] = lattice.vertices[t.vertices[i]].point;
    return glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0])) / 6.0;
}

/// How often each face of the lattice is there, by its vertices in order.
std::map<std::array<std::uint32_t, 3>, int> faces_of(const Lattice& lattice) {
    std::map<std::array<std::uint32_t, 3>, int> faces;
    for (const Tetrahedron& t : lattice.tetrahedra) {
        for (std::size_t without = 0; without < 4; ++without) {
            std::array<std::uint32_t, 3> face{};
            std::size_t count = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                if (i != without) face.at(count++) = t.vertices[i];
            }
            std::ranges::sort(face);
            ++faces[face];
        }
    }
    return faces;
}

TEST(Lattice, MeetsFaceToFaceWhereTheSurfaceGoesThrough) {
    const UpwardRegisters upward;
    // A cone: cells of many sizes.
    const Stages cone = stages_of(solid_of({"x^2 + y^2 - z^2"}, Box::cube(1)), 0.02, 8);
    for (const Tetrahedron& t : cone.lattice.tetrahedra)
        EXPECT_GT(volume_of(cone.lattice, t), 0);
    std::size_t crossed = 0;
    for (const auto& [face, count] : faces_of(cone.lattice)) {
        EXPECT_LE(count, 2);
        const bool inside = cone.lattice.inside(face[0]);
        if (inside == cone.lattice.inside(face[1]) && inside == cone.lattice.inside(face[2]))
            continue;
        ++crossed;
        EXPECT_EQ(count, 2);
    }
    EXPECT_GT(crossed, 1000U);
}

TEST(Lattice, HasLevelsAboutAsFarAsTheSurfaceIs) {
    const UpwardRegisters upward;
    const Stages ball = stages_of(unit_ball(), 0.02, 8);
    for (const LatticeVertex& vertex : ball.lattice.vertices) {
        const double distance = glm::length(vertex.point) - 1.0;
        EXPECT_EQ(vertex.level < 0, distance < 0);
        if (std::abs(distance) >= 0.1) continue;
        EXPECT_NEAR(vertex.level, distance, 0.06 * 0.1 + 1e-9);
    }
}

TEST(StarProof, HoldsForABallAndFailsAtTheTipOfACone) {
    const UpwardRegisters upward;
    const Stages ball = stages_of(unit_ball(), 0.01, 10);
    const StarProof proved = prove_stars(ball.tree, ball.lattice, {});
    EXPECT_EQ(proved.stars, ball.lattice.vertices.size());
    EXPECT_TRUE(proved.failed.empty());
    const Stages cone = stages_of(solid_of({"x^2 + y^2 - z^2"}, Box::cube(1)), 0.02, 8);
    const StarProof open = prove_stars(cone.tree, cone.lattice, {});
    ASSERT_FALSE(open.unknown.empty());
    const auto at_tip = [&](std::uint32_t cell) {
        return glm::length(cone.tree.box(cone.tree[cell]).centre()) < 0.2;
    };
    EXPECT_TRUE(std::ranges::any_of(open.unknown, at_tip));
}

TEST(StarProof, CountsWhatIsLeftInTheEndAsNotProved) {
    const UpwardRegisters upward;
    const Stages ball = stages_of(unit_ball(), 0.02, 8);
    const MeshWork over{.limit = {.until = TimeLimit::Clock::time_point()}};
    const StarProof proof = prove_stars(ball.tree, ball.lattice, over);
    EXPECT_EQ(proof.failed.size(), ball.lattice.vertices.size());
    EXPECT_FALSE(proof.unknown.empty());
}

TEST(Contour, IsClosedWithVerticesOnTheSurface) {
    const UpwardRegisters upward;
    const Stages ball = stages_of(unit_ball(), 0.01, 8);
    const Contour contour = make_contour(ball.lattice, ball.solid, {});
    EXPECT_EQ(defect_of(contour.mesh), "");
    EXPECT_EQ(euler_characteristic(contour.mesh), 2);
    EXPECT_EQ(contour.tetrahedra.size(), contour.mesh.triangles.size());
    for (const MeshVertex& vertex : contour.mesh.vertices) {
        EXPECT_NEAR(glm::length(vertex.point), 1.0, 1e-12);
        EXPECT_NEAR(glm::distance(vertex.normal, vertex.point), 0.0, 1e-12);
    }
    EXPECT_NEAR(enclosed_volume(contour.mesh), 4 * std::numbers::pi / 3, 0.05);
}

TEST(Contour, IsClosedWhereTimeEndsTheRoots) {
    const UpwardRegisters upward;
    const Stages ball = stages_of(unit_ball(), 0.02, 8);
    const MeshWork over{.limit = {.until = TimeLimit::Clock::time_point()}};
    const Contour contour = make_contour(ball.lattice, ball.solid, over);
    EXPECT_EQ(defect_of(contour.mesh), "");
    EXPECT_EQ(euler_characteristic(contour.mesh), 2);
}

TEST(Roots, LieBetweenInsideAndOutside) {
    const UpwardRegisters upward;
    const MeshSolid ball = unit_ball();
    // Another one that jumps from -1 to 1 at x = 0.3.
    const MeshSolid jump = solid_of({"sign(x - 0.3)"}, Box::cube(2));
    const std::vector<CrossedEdge> along{{.inside = {0, 0, 0}, .outside = {0, 1.9, 0}},
                                         {.inside = {0.1, 0.2, 0.3}, .outside = {1.2, 0.2, 0.3}}};
    const std::vector<MeshVertex> roots = find_roots(ball, along, {});
    EXPECT_NEAR(glm::distance(roots[0].point, {0, 1, 0}), 0, 1e-12);
    EXPECT_NEAR(glm::distance(roots[1].point, {std::sqrt(0.87), 0.2, 0.3}), 0, 1e-12);
    const std::vector<MeshVertex> ends =
        find_roots(jump, {{.inside = {-1, 0, 0}, .outside = {1, 0, 0}}}, {});
    EXPECT_NEAR(ends[0].point.x, 0.3, 1e-9);
}

TEST(FeaturePoint, IsWhereTheSidesMeet) {
    const auto side = [](const glm::dvec3& point, const glm::dvec3& normal) {
        return FeatureSide{.base = point, .point = point, .normal = glm::normalize(normal)};
    };
    const std::vector<FeatureSide> corner{side({1, 5, 7}, {1, 0, 0}), side({4, 2, -3}, {0, 1, 0}),
                                          side({0, 3, 0}, {0, 1, 1})};
    const auto at_corner = meeting_point(corner, {0, 0, 0});
    ASSERT_TRUE(at_corner);
    EXPECT_NEAR(glm::distance(*at_corner, {1, 2, 1}), 0, 1e-12);
    const std::vector<FeatureSide> edge(corner.begin(), corner.begin() + 2);
    const auto on_edge = meeting_point(edge, {0, 0, 9});
    ASSERT_TRUE(on_edge);
    EXPECT_NEAR(glm::distance(*on_edge, {1, 2, 9}), 0, 1e-12);
    EXPECT_FALSE(meeting_point({corner[0]}, {0, 0, 0}));
    EXPECT_FALSE(meeting_point({corner[0], side({2, 0, 0}, {1, 0.01, 0})}, {0, 0, 0}));
    const MeshVertex left{.point = {0, 0, 0}, .normal = {-1, 0, 0}};
    const MeshVertex up{.point = {1, 0, 0}, .normal = {0, 0, 1}};
    const MeshVertex nearly_up{.point = {2, 0, 0}, .normal = glm::normalize(glm::dvec3(0.1, 0, 1))};
    EXPECT_EQ(sides_of({&left, &up, &nearly_up}).size(), 2U);
}

TEST(Features, GiveACubeItsEdgesAndCorners) {
    const UpwardRegisters upward;
    const Stages cube =
        stages_of(solid_of({"x - 0.7", "-x - 0.7", "y - 0.7", "-y - 0.7", "z - 0.7", "-z - 0.7"},
                           Box::cube(1)),
                  0.05, 5);
    Contour contour = make_contour(cube.lattice, cube.solid, {});
    EXPECT_LT(enclosed_volume(contour.mesh), 1.4 * 1.4 * 1.4 - 0.01);
    add_features(cube.tree, cube.lattice, cube.solid, contour, {});
    EXPECT_EQ(defect_of(contour.mesh), "");
    EXPECT_EQ(euler_characteristic(contour.mesh), 2);
    EXPECT_NEAR(enclosed_volume(contour.mesh), 1.4 * 1.4 * 1.4, 1e-9);
    EXPECT_EQ(std::ranges::count(contour.mesh.vertices, VertexKind::Corner, &MeshVertex::kind), 8);
}

}  // namespace
}  // namespace zeroset::test::lattice_test
