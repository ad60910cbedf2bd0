#include "engine/mesh/collapsible_mesh.hpp"
#include "engine/mesh/finished_mesh.hpp"
#include "engine/mesh/mesh_facts.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/mesh/triangle_tree.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/mesh_checks.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Counts, measures and changes of triangles, on meshes made by hand.

namespace zeroset::test::triangles_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Adds a grid of quads, each of two triangles, whose points `at` gives for (i, k) from (0, 0) to
/// (rows, columns), with whatever is joined there given the same number by `number`.
template <class At, class Number>
TriangleMesh grid(std::uint32_t rows, std::uint32_t columns, const At& at, const Number& number) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= rows; ++i) {
        for (std::uint32_t k = 0; k <= columns; ++k) {
            if (number(i, k) == mesh.vertices.size()) mesh.vertices.push_back({.point = at(i, k)});
        }
    }
    for (std::uint32_t i = 0; i < rows; ++i) {
        for (std::uint32_t k = 0; k < columns; ++k) {
            const std::array<std::uint32_t, 4> ring{number(i, k), number(i, k + 1),
                                                    number(i + 1, k + 1), number(i + 1, k)};
            mesh.triangles.push_back({ring[0], ring[1], ring[2]});
            mesh.triangles.push_back({ring[0], ring[2], ring[3]});
        }
    }
    return mesh;
}

/// A torus about z with rings of these radii.
TriangleMesh torus(double ring, double tube, std::uint32_t rows, std::uint32_t columns) {
    const auto at = [&](std::uint32_t i, std::uint32_t k) {
        const double u = 2 * pi * i / rows;
        const double v = 2 * pi * k / columns;
        const double r = ring + tube * std::cos(v);
        return glm::dvec3(r * std::sin(u), r * std::cos(u), tube * std::sin(v));
    };
    const auto number = [&](std::uint32_t i, std::uint32_t k) {
        return i % rows * columns + k % columns;
    };
    return grid(rows, columns, at, number);
}

/// A box about the origin; `outward` false: the hollow of this shape.
TriangleMesh box(const glm::dvec3& half, bool outward = true) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
        mesh.vertices.push_back({.point = half * (2.0 * side - 1.0), .kind = VertexKind::Corner});
    }
    for (const std::array<std::uint32_t, 4>& ring : std::vector<std::array<std::uint32_t, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        mesh.triangles.push_back({ring[0], ring[1], ring[2]});
        mesh.triangles.push_back({ring[0], ring[2], ring[3]});
    }
    if (outward) return mesh;
    for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

TriangleMesh both(TriangleMesh a, const TriangleMesh& b) {
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle& t : b.triangles)
        a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return a;
}

TriangleMesh moved(TriangleMesh mesh, const glm::dvec3& by) {
    for (MeshVertex& vertex : mesh.vertices)
        vertex.point += by;
    return mesh;
}

/// The square [-1, 1]^2 in the plane z = 0, its normals along z.
TriangleMesh sheet(std::uint32_t parts) {
    TriangleMesh mesh = grid(
        parts, parts,
        [&](std::uint32_t i, std::uint32_t k) {
            return glm::dvec3(-1 + 2.0 * k / parts, -1 + 2.0 * i / parts, 0);
        },
        [&](std::uint32_t i, std::uint32_t k) { return i * (parts + 1) + k; });
    for (MeshVertex& vertex : mesh.vertices)
        vertex.normal = {0, 0, 1};
    return mesh;
}

TEST(MeshFacts, AreThoseOfABoxATorusAndASheet) {
    const MeshFacts cube = facts_of(moved(box({1, 2, 3}), {10, 0, 0}));
    EXPECT_EQ(cube.vertices, 8U);
    EXPECT_EQ(cube.edges, 18U);
    EXPECT_EQ(cube.triangles, 12U);
    EXPECT_EQ(cube.components, 1U);
    EXPECT_EQ(cube.open_edges, 0U);
    EXPECT_EQ(cube.genus(), 0);
    EXPECT_NEAR(cube.area, 2 * (2 * 4 + 4 * 6 + 2 * 6), 1e-12);
    EXPECT_NEAR(cube.volume, 48, 1e-12);
    EXPECT_EQ(cube.bounds.lo, glm::dvec3(9, -2, -3));
    const MeshFacts two = facts_of(both(torus(2, 0.5, 64, 32), moved(box({1, 1, 1}), {9, 9, 9})));
    EXPECT_EQ(two.components, 2U);
    EXPECT_EQ(two.euler(), 2);
    EXPECT_EQ(two.genus(), 1);
    EXPECT_NEAR(two.volume, 2 * pi * pi * 2 * 0.25 + 8, 0.1);
    const MeshFacts open = facts_of(sheet(3));
    EXPECT_EQ(open.open_edges, 12U);
    EXPECT_EQ(open.euler(), 1);
    EXPECT_NEAR(open.area, 4, 1e-12);
}

TEST(TriangleTree, FindsTheNearestWayOut) {
    const TriangleMesh shell = both(torus(2, 0.5, 40, 30), box({0.3, 0.4, 0.5}));
    const TriangleTree tree(shell);
    RandomNumbers random(3);
    constexpr std::uint32_t no_own = ~std::uint32_t{0};
    std::size_t met = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 from(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1));
        const glm::dvec3 to(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1));
        const glm::dvec3 direction = glm::normalize(to - from);
        double nearest = 1e300;  // by all triangles, by signed volumes
        for (const Triangle& t : shell.triangles) {
            const glm::dvec3 a = shell.vertices[t[0]].point - from;
            const glm::dvec3 b = shell.vertices[t[1]].point - from;
            const glm::dvec3 c = shell.vertices[t[2]].point - from;
            const double u = glm::dot(direction, glm::cross(b, c));
            const double v = glm::dot(direction, glm::cross(c, a));
            const double w = glm::dot(direction, glm::cross(a, b));
            if (!(u > 0 && v > 0 && w > 0)) continue;
            const double distance = glm::dot(a, glm::cross(b, c)) / (u + v + w);
            if (distance > 0) nearest = std::min(nearest, distance);
        }
        const auto hit = tree.way_out(from, direction, no_own);
        EXPECT_EQ(hit.has_value(), nearest < 1e300);
        if (!hit) continue;
        EXPECT_NEAR(hit->distance, nearest, 1e-9);
        ++met;
    }
    EXPECT_GT(met, 100U);
}

TEST(TriangleTree, TakesRaysAlongAxesInFlatBoxes) {
    const TriangleMesh cube = box({1, 1, 1});
    const TriangleTree tree(cube);
    const auto hit = tree.way_out({1, 0.25, 0.5}, {0, 0, -1}, ~std::uint32_t{0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 1.5, 1e-12);
}

TEST(SmallestWall, OfABoxIsItsShortestEdge) {
    const auto wall = smallest_wall(box({1, 0.125, 3}), {});
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->thickness, 0.25, 1e-12);
    EXPECT_NEAR(wall->but_for_rims.value_or(0.0), 0.25, 1e-12);
    EXPECT_NEAR(wall->at.y, 0, 1e-12);
    EXPECT_EQ(wall->places, 48U);
}

TEST(SmallestWall, OfAHollowBoxIsItsThinnestSide) {
    const TriangleMesh shell =
        both(box({1, 1, 1}), moved(box({0.8, 0.8, 0.8}, false), {0, 0, 0.15}));
    EXPECT_EQ(defect_of(shell), "");
    const auto wall = smallest_wall(shell, {});
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->thickness, 0.05, 1e-12);
    EXPECT_NEAR(wall->at.z, 0.975, 1e-12);
}

TEST(SmallestWall, OfATorusIsItsTube) {
    const auto wall = smallest_wall(torus(2, 0.25, 200, 100), {});
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->thickness, 0.5, 0.002);
}

TEST(SmallestWall, IsNoneWhereNoSidesFaceEachOther) {
    // A regular tetrahedron: its sides meet at 70 degrees.
    TriangleMesh mesh;
    for (const glm::dvec3& p :
         std::vector<glm::dvec3>{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}})
        mesh.vertices.push_back({.point = p});
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    ASSERT_GT(enclosed_volume(mesh), 0);
    EXPECT_FALSE(smallest_wall(mesh, {}));
    EXPECT_FALSE(smallest_wall({}, {}));
}

TEST(Wall, OfASheetIsABox) {
    const auto wall = wall_of(sheet(4), 0.1, 1e-3);
    ASSERT_TRUE(wall) << wall.error();
    EXPECT_EQ(defect_of(*wall), "");
    EXPECT_NEAR(enclosed_volume(*wall), 0.4, 1e-12);
    const auto smallest = smallest_wall(*wall, {});
    ASSERT_TRUE(smallest);
    EXPECT_NEAR(smallest->thickness, 0.1, 1e-12);
}

TEST(OpenSurface, IsLeftWhereCutsAreTakenOut) {
    const UpwardRegisters upward;
    const MeshSolid half = solid_of({"z"}, Box::cube(1));
    TriangleMesh mesh = both(moved(box({1, 1, 0.5}), {0, 0, -0.5}), {});
    keep_surface(mesh, half);
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.vertices.size(), 4U);
    for (const MeshVertex& vertex : mesh.vertices)
        EXPECT_EQ(vertex.point.z, 0);
}

TEST(Deviations, AreDistances) {
    const UpwardRegisters upward;
    TriangleMesh mesh;
    for (const glm::dvec3& p : std::vector<glm::dvec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
        mesh.vertices.push_back({.point = p});
    mesh.triangles = {{0, 1, 2}};
    const std::vector<float> far = deviations(solid_of({"x + y + z - 2"}, Box::cube(2)), mesh, {});
    ASSERT_EQ(far.size(), 1U);
    EXPECT_NEAR(far[0], 1 / std::sqrt(3.0), 1e-6);
}

TEST(Thinning, LeavesABoxItsCorners) {
    const UpwardRegisters upward;
    // A cube whose sides are sheets of many triangles.
    constexpr std::uint32_t parts = 6;
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            TriangleMesh face = moved(sheet(parts), {0, 0, 1});
            for (MeshVertex& vertex : face.vertices) {
                const glm::dvec3 p = side * vertex.point;
                vertex.point = axis == 0   ? glm::dvec3(p.z, p.x, p.y)
                               : axis == 1 ? glm::dvec3(p.y, p.z, p.x)
                                           : p;
            }
            if (side < 0) {
                for (Triangle& t : face.triangles)
                    std::swap(t[1], t[2]);
            }
            mesh = both(std::move(mesh), face);
        }
    }
    // Vertices at the same point become one, of the kind that the edges there make it.
    TriangleMesh cube;
    std::vector<std::uint32_t> numbers;
    for (const MeshVertex& vertex : mesh.vertices) {
        const auto same = std::ranges::find_if(cube.vertices, [&](const MeshVertex& other) {
            return glm::distance(other.point, vertex.point) < 1e-9;
        });
        numbers.push_back(static_cast<std::uint32_t>(same - cube.vertices.begin()));
        if (same != cube.vertices.end()) continue;
        int sides = 0;
        for (int axis = 0; axis < 3; ++axis)
            sides += std::abs(vertex.point[axis]) > 1 - 1e-9 ? 1 : 0;
        cube.vertices.push_back({.point = vertex.point,
                                 .kind = sides == 3   ? VertexKind::Corner
                                         : sides == 2 ? VertexKind::Crease
                                                      : VertexKind::Smooth});
    }
    for (const Triangle& t : mesh.triangles)
        cube.triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
    ASSERT_EQ(defect_of(cube), "");
    const MeshSolid solid =
        solid_of({"x - 1", "-x - 1", "y - 1", "-y - 1", "z - 1", "-z - 1"}, Box::cube(2));
    TriangleMesh thinned = cube;
    thin(thinned, solid, {.tolerance = 1e-6});
    EXPECT_EQ(defect_of(thinned), "");
    EXPECT_NEAR(enclosed_volume(thinned), 8, 1e-12);
    EXPECT_LE(thinned.triangles.size(), 24U);
    EXPECT_EQ(std::ranges::count(thinned.vertices, VertexKind::Corner, &MeshVertex::kind), 8);
    TriangleMesh half = cube;
    thin(half, solid, {.tolerance = 1e-6, .most_triangles = 200});
    EXPECT_LE(half.triangles.size(), 200U);
    EXPECT_GT(half.triangles.size(), 150U);
    TriangleMesh same = cube;
    thin(same, solid,
         {.tolerance = 1e-6, .work = {.limit = {.until = TimeLimit::Clock::time_point()}}});
    EXPECT_EQ(same.triangles.size(), cube.triangles.size());
}

TEST(CollapsibleMesh, KeepsATetrahedron) {
    TriangleMesh mesh;
    for (const glm::dvec3& p :
         std::vector<glm::dvec3>{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}})
        mesh.vertices.push_back({.point = p});
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const CollapsibleMesh tetrahedron(mesh);
    EXPECT_FALSE(tetrahedron.may_collapse(0, 1));
    CollapsibleMesh cube(box({1, 1, 1}));
    ASSERT_TRUE(cube.may_collapse(0, 1));
    cube.collapse(0, 1);
    EXPECT_EQ(cube.triangles(), 10U);
    EXPECT_EQ(defect_of(cube.finish()), "");
}

}  // namespace
}  // namespace zeroset::test::triangles_test
