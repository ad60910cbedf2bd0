#include "engine/mesh/finished_mesh.hpp"
#include "engine/mesh/make_mesh.hpp"
#include "engine/mesh/mesh_facts.hpp"
#include "tests/support/mesh_checks.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

// Meshes as readers of their files see them, at edges and where nothing is proved.

namespace zeroset::test::exact_mesh_test {
namespace {

constexpr std::array scales{25.0, 0.025};

/// How many different points the vertices have in a file's numbers.
std::size_t different_points(const TriangleMesh& mesh, double scale) {
    std::set<std::array<float, 3>> points;
    for (const MeshVertex& vertex : mesh.vertices) {
        const glm::vec3 p(scale * vertex.point);
        points.insert({p.x, p.y, p.z});
    }
    return points.size();
}

/// A torus about z.
TriangleMesh torus(double tube, std::uint32_t rows, std::uint32_t columns) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < rows; ++i) {
        for (std::uint32_t k = 0; k < columns; ++k) {
            const double u = 2 * std::numbers::pi * i / rows;
            const double v = 2 * std::numbers::pi * k / columns;
            const double r = 1 + tube * std::cos(v);
            mesh.vertices.push_back(
                {.point = {r * std::sin(u), r * std::cos(u), 1 + tube * std::sin(v)}});
            const std::array<std::uint32_t, 4> ring{
                i * columns + k, i * columns + (k + 1) % columns,
                (i + 1) % rows * columns + (k + 1) % columns, (i + 1) % rows * columns + k};
            mesh.triangles.push_back({ring[0], ring[1], ring[2]});
            mesh.triangles.push_back({ring[0], ring[2], ring[3]});
        }
    }
    return mesh;
}

TEST(Numbers, OfVerticesAreDifferentAndTheMeshStaysClosed) {
    // Rings whose points are the same in 32 bits, which cannot all be made one.
    TriangleMesh thread = torus(1e-10, 30, 9);
    ASSERT_LT(different_points(thread, scales[0]), 150U);
    const std::vector<std::uint32_t> left = make_numbers_different(thread, scales);
    EXPECT_EQ(left.size(), thread.vertices.size());
    EXPECT_LT(left.size(), 270U);
    EXPECT_EQ(defect_of(thread), "");
    EXPECT_EQ(euler_characteristic(thread), 0);
    for (const double scale : scales)
        EXPECT_EQ(different_points(thread, scale), thread.vertices.size());
    for (const MeshVertex& vertex : thread.vertices)
        EXPECT_NEAR(std::hypot(vertex.point.x, vertex.point.y), 1, 1e-4);
}

TEST(Numbers, ThatAreDifferentStay) {
    TriangleMesh ring = torus(0.25, 30, 9);
    const TriangleMesh before = ring;
    EXPECT_EQ(make_numbers_different(ring, scales).size(), before.vertices.size());
    EXPECT_EQ(ring.triangles, before.triangles);
    for (std::size_t v = 0; v < before.vertices.size(); ++v)
        EXPECT_EQ(ring.vertices[v].point, before.vertices[v].point);
}

TEST(SmallestWall, IsNotLookedForWhereTheTimeIsOver) {
    EXPECT_TRUE(smallest_wall(torus(0.25, 30, 9), {}));
    const MeshWork over{.limit = {.until = TimeLimit::Clock::time_point()}};
    EXPECT_FALSE(smallest_wall(torus(0.25, 30, 9), over));
}

/// A block with a hole: two rims and twelve edges, none of them cut off anywhere.
TEST(MakeMesh, CutsOffNoEdge) {
    const double radius = 0.47;
    const MadeMesh made = make_mesh(solid_of({"x - 0.9", "-x - 0.9", "y - 0.8", "-y - 0.8",
                                              "z - 0.6", "-z - 0.6", "0.2209 - x^2 - y^2"},
                                             Box::cube(1.2)),
                                    {.tolerance = 2e-3, .thin = false});
    EXPECT_EQ(defect_of(made.mesh), "");
    EXPECT_EQ(facts_of(made.mesh).genus(), 1);
    std::size_t cut = 0;
    for (const Triangle& t : made.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const MeshVertex& a = made.mesh.vertices[t[k]];
            const MeshVertex& b = made.mesh.vertices[t[(k + 1) % 3]];
            const bool smooth = a.kind == VertexKind::Smooth && b.kind == VertexKind::Smooth;
            cut += smooth && glm::dot(a.normal, b.normal) < 0.5 ? 1U : 0U;
        }
    }
    EXPECT_EQ(cut, 0U);
    for (const MeshVertex& vertex : made.mesh.vertices) {
        if (vertex.kind == VertexKind::Smooth || std::abs(vertex.point.z) < 0.5999) continue;
        const double from_hole = std::abs(std::hypot(vertex.point.x, vertex.point.y) - radius);
        const double from_side =
            std::min(0.9 - std::abs(vertex.point.x), 0.8 - std::abs(vertex.point.y));
        EXPECT_LT(std::min(from_hole, std::abs(from_side)), 1e-6);
    }
}

/// Two wedges that meet along a line: as many handles as there are cells, or none.
TEST(MakeMesh, HasNoHandlesWhereSheetsCross) {
    const MadeMesh made = make_mesh(solid_of({"x*y"}, Box::cube(1)), {.tolerance = 0.01});
    EXPECT_EQ(defect_of(made.mesh), "");
    const MeshFacts facts = facts_of(made.mesh);
    EXPECT_EQ(facts.genus(), 0);
    EXPECT_LE(facts.components, 2U);
    EXPECT_FALSE(made.report.isotopic);
    EXPECT_FALSE(made.report.places.empty());
}

TEST(MakeMesh, HasAThinShellWithCellsOfItsSides) {
    for (const char* inner : {"0.9801 - x^2 - y^2 - z^2", "0.9604 - x^2 - y^2 - z^2"}) {
        const MadeMesh made = make_mesh(solid_of({"x^2 + y^2 + z^2 - 1", inner}, Box::cube(1.25)),
                                        {.tolerance = 2.5e-3});
        EXPECT_EQ(defect_of(made.mesh), "") << inner;
        const MeshFacts facts = facts_of(made.mesh);
        EXPECT_EQ(facts.components, 2U) << inner;
        EXPECT_EQ(facts.genus(), 0) << inner;
        EXPECT_TRUE(made.report.isotopic) << inner;
        EXPECT_LE(made.report.deviation, 2.5e-3) << inner;
        EXPECT_LT(facts.triangles, 10'000U) << inner;
        for (const MeshVertex& vertex : made.mesh.vertices) {
            EXPECT_LT(glm::length(vertex.point), 1 + 1e-9);
            EXPECT_GT(glm::length(vertex.point), 0.98 - 1e-9);
        }
    }
}

/// Where parts meet, or end at the box, all is meshed together.
TEST(MakeMesh, TakesPartsThatMeetTogether) {
    const MadeMesh lens = make_mesh(
        solid_of({"(x - 0.5)^2 + y^2 + z^2 - 1", "(x + 0.5)^2 + y^2 + z^2 - 1"}, Box::cube(2)),
        {.tolerance = 2e-3});
    EXPECT_EQ(defect_of(lens.mesh), "");
    EXPECT_NEAR(facts_of(lens.mesh).volume, 5 * std::numbers::pi / 12, 0.02);
    const MadeMesh plate =
        make_mesh(solid_of({"z - 0.1", "-z - 0.1"}, Box::cube(1)), {.tolerance = 0.01});
    EXPECT_EQ(defect_of(plate.mesh), "");
    EXPECT_EQ(facts_of(plate.mesh).components, 1U);
    EXPECT_NEAR(facts_of(plate.mesh).volume, 0.8, 1e-6);
}

/// A point beside a ball has no triangles, but it is not proved that nothing is there.
TEST(MakeMesh, TellsWhatIsNotProvedOfAPartWithoutTriangles) {
    MeshSolid solid = solid_of({"x^2 + y^2 + z^2 - 0.25", "(x - 1.5)^2 + y^2 + z^2"}, Box::cube(2));
    solid.nodes.back().kind = SolidNode::Kind::Min;
    const MadeMesh made = make_mesh(solid, {.tolerance = 0.01});
    EXPECT_EQ(facts_of(made.mesh).components, 1U);
    EXPECT_FALSE(made.report.isotopic);
    EXPECT_GT(made.report.unproved, 0U);
}

}  // namespace
}  // namespace zeroset::test::exact_mesh_test
