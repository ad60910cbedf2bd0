#include "pipeline/mesh_document.hpp"

#include "pipeline/gallery.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/mesh_checks.hpp"
#include "tests/support/meshed.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

// Meshes of surfaces about which something is known without a mesh.

namespace zeroset::test::mesh_document_test {
namespace {

constexpr double pi = std::numbers::pi;

/// The only mesh of a text, which is closed and faces outwards.
MeshObject closed_mesh(const std::string& text, double half, const MeshSettings& settings,
                       const std::function<void(Document&)>& change = {}) {
    DocumentMeshes meshes = meshed(text, half, settings, change);
    if (meshes.file.objects.size() != 1) {
        ADD_FAILURE() << text << ": " << meshes.file.objects.size() << " meshes";
        return {};
    }
    const TriangleMesh& mesh = meshes.file.objects[0].mesh;
    EXPECT_EQ(defect_of(mesh), "") << text;
    EXPECT_GT(enclosed_volume(mesh), 0) << text;
    EXPECT_NEAR(enclosed_volume(mesh), meshes.surfaces[0].facts.volume, 1e-9) << text;
    EXPECT_EQ(euler_characteristic(mesh), meshes.surfaces[0].facts.euler()) << text;
    return std::move(meshes.file.objects[0]);
}

struct KnownTopology {
    std::string text;
    double half;
    double tolerance;
    long long euler;
    std::size_t components;
    bool takes_long = false;
};

class MeshTopology : public testing::TestWithParam<KnownTopology> {};

TEST_P(MeshTopology, IsProvedAndRight) {
    const KnownTopology& known = GetParam();
    for (const bool thin : {false, true}) {
        MeshSettings settings{.tolerance = known.tolerance, .thin = thin};
        const DocumentMeshes meshes = meshed(known.text, known.half, settings);
        ASSERT_EQ(meshes.surfaces.size(), 1U);
        const TriangleMesh& mesh = meshes.file.objects[0].mesh;
        EXPECT_EQ(defect_of(mesh), "");
        EXPECT_EQ(euler_characteristic(mesh), known.euler);
        EXPECT_EQ(meshes.surfaces[0].facts.components, known.components);
        EXPECT_TRUE(meshes.surfaces[0].report.isotopic) << proof_line(meshes.surfaces[0].report);
        EXPECT_EQ(meshes.surfaces[0].report.unchanged, !thin);
        EXPECT_LE(meshes.surfaces[0].report.deviation, known.tolerance);
    }
}

const std::string two_spheres = "(x^2 + y^2 + z^2 - 1)*((x - 1.5)^2 + y^2 + z^2 - 0.0004) = 0";
// The orthocircle is a tube about a graph of three rings that meet in six points: genus
// 12 - 6 + 1 = 7. The tangle's height has 8 extrema and 16 saddles: 8 - 16 = -8.
const std::string orthocircle =
    "((x^2 + y^2 - 1)^2 + z^2)*((y^2 + z^2 - 1)^2 + x^2)*((z^2 + x^2 - 1)^2 + y^2) "
    "= 0.075^2 (1 + 3 (x^2 + y^2 + z^2))";

INSTANTIATE_TEST_SUITE_P(
    Surfaces, MeshTopology,
    testing::ValuesIn(cases_to_try<KnownTopology>(
        {KnownTopology{"x^2 + y^2 + z^2 = 1", 2, 0.02, 2, 1},
         KnownTopology{"1 = x^2 + y^2 + z^2", 2, 0.02, 2, 1},
         KnownTopology{"(x^2 + y^2 + z^2 + 0.75)^2 = 4 (x^2 + y^2)", 2, 0.02, 0, 1},
         KnownTopology{"x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8 = 0", 3, 0.03, -8, 1},
         KnownTopology{orthocircle, 1.5, 0.02, -12, 1, true},
         KnownTopology{"((x^2 + y^2)^2 - x^2 + y^2)^2 + z^2 = 0.01", 2, 0.02, -2, 1},
         KnownTopology{two_spheres, 2, 0.004, 4, 2},
         KnownTopology{"x^2 + y^2 + z^2 = 0.0004", 2, 0.004, 2, 1},
         KnownTopology{"(x^2 + y^2 + z^2 - 1)^2 = 0.04", 2, 0.02, 4, 2}})),
    [](const auto& test) { return "Number" + std::to_string(test.index); });

struct KnownVolume {
    std::string text;
    double half;
    double tolerance;
    double volume;
    bool takes_long = false;
};

class MeshVolume : public testing::TestWithParam<KnownVolume> {};

TEST_P(MeshVolume, IsWithinAThousandth) {
    const KnownVolume& known = GetParam();
    const MeshObject object = closed_mesh(known.text, known.half, {.tolerance = known.tolerance});
    EXPECT_NEAR(enclosed_volume(object.mesh), known.volume, 1e-3 * known.volume);
}

INSTANTIATE_TEST_SUITE_P(
    Solids, MeshVolume,
    testing::ValuesIn(cases_to_try<KnownVolume>(
        {KnownVolume{"x^2 + y^2 + z^2 = 1", 2, 6e-4, 4 * pi / 3},
         KnownVolume{"(x^2 + y^2 + z^2 + 0.75)^2 = 4 (x^2 + y^2)", 2, 3e-4, pi* pi / 2, true},
         KnownVolume{"x^2 + 4 y^2 + z^2/2 = 1", 2, 3e-4, 4 * pi / 3 * 0.5 * std::sqrt(2.0), true},
         KnownVolume{"max(abs(x), abs(y), abs(z)) = 1", 2, 1e-2, 8},
         KnownVolume{"abs(x) + abs(y) + abs(z) = 1", 2, 1e-2, 4.0 / 3},
         // A lens: two caps of height 1/2 of balls of radius 1.
         KnownVolume{"max((x - 0.5)^2 + y^2 + z^2 - 1, (x + 0.5)^2 + y^2 + z^2 - 1) = 0", 2, 2e-4,
                     2 * pi * 0.25 * (3 - 0.5) / 3},
         KnownVolume{"x^2 + y^2 = 1, -1 < z < 1/2", 2, 3e-4, 1.5 * pi},
         // Steinmetz: two cylinders.
         KnownVolume{"max(x^2 + y^2, x^2 + z^2) = 1", 2, 3e-4, 16.0 / 3},
         // A thin disc.
         KnownVolume{"max(x^2 + y^2 - 0.25, abs(z) - 0.02) = 0", 1, 4e-4, pi * 0.01},
         // A half space, closed by the box.
         KnownVolume{"x + 0.3 y + 0.1 z = 0.05", 1, 1e-2, 4.2}})),
    [](const auto& test) { return "Number" + std::to_string(test.index); });

TEST(MeshSolid, IsClosedAtSectionsAndInTheSphere) {
    const auto cap = [](Document& document) {
        document.region.sections.push_back(make_section({0, 0, -1}, -0.5));
    };
    const MeshObject object = closed_mesh("x^2 + y^2 + z^2 = 1", 2, {.tolerance = 3e-4}, cap);
    const double height = 0.5;
    EXPECT_NEAR(enclosed_volume(object.mesh), pi * height * height * (3 - height) / 3, 1e-3 * 0.65);
    const auto ball = [](Document& document) {
        document.region.ball = Ball{.centre = {0, 0, 0}, .radius = 1};
    };
    const MeshObject half = closed_mesh("x + y - 2 z = 0", 2, {.tolerance = 5e-4}, ball);
    EXPECT_NEAR(enclosed_volume(half.mesh), 2 * pi / 3, 2e-3);
}

TEST(MeshSolid, LiesOnTheSideAskedFor) {
    const auto outside = [](Document& document) {
        document.statements[0].solid = SolidSide::Above;
    };
    const MeshObject object = closed_mesh("x^2 + y^2 + z^2 = 1", 2, {.tolerance = 2e-3}, outside);
    EXPECT_NEAR(enclosed_volume(object.mesh), 64 - 4 * pi / 3, 0.02);
    EXPECT_EQ(euler_characteristic(object.mesh), 4);
}

TEST(MeshEdges, AreSharp) {
    const MeshObject cube = closed_mesh("max(abs(x), abs(y), abs(z)) = 1", 2, {.tolerance = 0.01});
    int corners = 0;
    for (const MeshVertex& vertex : cube.mesh.vertices) {
        const glm::dvec3 size = glm::abs(vertex.point);
        EXPECT_NEAR(std::max({size.x, size.y, size.z}), 1.0, 1e-12);
        const int on = static_cast<int>(size.x > 1 - 1e-9) + static_cast<int>(size.y > 1 - 1e-9) +
                       static_cast<int>(size.z > 1 - 1e-9);
        corners += on == 3 ? 1 : 0;
        if (vertex.kind == VertexKind::Crease) {
            EXPECT_GE(on, 2);
        }
    }
    EXPECT_EQ(corners, 8);
    EXPECT_NEAR(enclosed_volume(cube.mesh), 8.0, 1e-9);
}

TEST(MeshEdges, AreKeptWhereACubeLacksABall) {
    constexpr double tolerance = 0.005;
    const MeshObject object =
        closed_mesh("max(max(abs(x), abs(y), abs(z)) - 1, 0.8 - x^2 - y^2 - (z - 1)^2) = 0", 2,
                    {.tolerance = tolerance});
    EXPECT_EQ(euler_characteristic(object.mesh), 2);
    std::size_t on_rim = 0;
    for (const MeshVertex& vertex : object.mesh.vertices) {
        if (vertex.kind == VertexKind::Smooth) continue;
        const glm::dvec3& p = vertex.point;
        const double from_ball = std::abs(glm::distance(p, {0, 0, 1}) - std::sqrt(0.8));
        if (from_ball < tolerance && std::abs(p.z - 1) < tolerance) ++on_rim;
    }
    EXPECT_GT(on_rim, 20U);
    // Less the half of a ball.
    EXPECT_NEAR(enclosed_volume(object.mesh), 8 - 2 * pi / 3 * std::pow(0.8, 1.5), 0.02);
}

TEST(MeshDistance, IsBelowTheToleranceEverywhere) {
    constexpr double tolerance = 0.01;
    const MeshObject sphere = closed_mesh("x^2 + y^2 + z^2 = 1", 2, {.tolerance = tolerance});
    const MeshObject torus =
        closed_mesh("(x^2 + y^2 + z^2 + 0.75)^2 = 4 (x^2 + y^2)", 2, {.tolerance = tolerance});
    const auto from_torus = [](const glm::dvec3& p) {
        return std::abs(std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.5);
    };
    const auto from_sphere = [](const glm::dvec3& p) { return std::abs(glm::length(p) - 1); };
    RandomNumbers random(7);
    const auto check = [&](const TriangleMesh& mesh, const auto& distance) {
        for (const MeshVertex& vertex : mesh.vertices)
            EXPECT_LT(distance(vertex.point), 1e-9);
        for (const Triangle& t : mesh.triangles) {
            const double u = random.uniform(0, 1);
            const double v = random.uniform(0, 1 - u);
            const glm::dvec3 point = u * mesh.vertices[t[0]].point + v * mesh.vertices[t[1]].point +
                                     (1 - u - v) * mesh.vertices[t[2]].point;
            EXPECT_LT(distance(point), 1.05 * tolerance);
        }
    };
    check(sphere.mesh, from_sphere);
    check(torus.mesh, from_torus);
}

TEST(MeshSingular, IsClosedAndSaidToBeUnproved) {
    for (const char* text :
         {"x^2 + y^2 = z^2", "4 (x^2 + y^2 + z^2) + 16 x y z = 1", "x^2 + y^2 z = 0"}) {
        const DocumentMeshes meshes =
            meshed(text, 2, {.tolerance = 0.05, .limit = {.until = TimeLimit::never}});
        ASSERT_EQ(meshes.surfaces.size(), 1U) << text;
        EXPECT_EQ(defect_of(meshes.file.objects[0].mesh), "") << text;
        const MeshReport& report = meshes.surfaces[0].report;
        EXPECT_FALSE(report.isotopic) << text;
        EXPECT_GT(report.unproved, 0U) << text;
        EXPECT_FALSE(report.places.empty()) << text;
        EXPECT_NE(proof_line(report).find("not proved"), std::string::npos);
    }
}

TEST(MeshOpen, EndsWhereTheBoxDoes) {
    const DocumentMeshes meshes = meshed("z = x y/2", 1, {.tolerance = 0.01, .open = true});
    ASSERT_EQ(meshes.surfaces.size(), 1U);
    EXPECT_EQ(meshes.surfaces[0].facts.euler(), 1);
    EXPECT_GT(meshes.surfaces[0].facts.open_edges, 3U);
    for (const MeshVertex& vertex : meshes.file.objects[0].mesh.vertices)
        EXPECT_NEAR(vertex.point.z, vertex.point.x * vertex.point.y / 2, 1e-6);
}

TEST(MeshWall, HasItsThicknessAndIsClosed) {
    // A hemisphere of radius 1, 100 mm wide with a wall of 4 mm: 96/2 mm to the middle of it.
    const auto half = [](Document& document) {
        document.region.sections.push_back(make_section({0, 0, 1}, 0));
    };
    const DocumentMeshes meshes =
        meshed("x^2 + y^2 + z^2 = 1", 2, {.tolerance = 0.002, .wall_mm = 4}, half);
    ASSERT_EQ(meshes.surfaces.size(), 1U);
    const TriangleMesh& mesh = meshes.file.objects[0].mesh;
    EXPECT_EQ(defect_of(mesh), "");
    EXPECT_EQ(euler_characteristic(mesh), 2);
    EXPECT_NEAR(meshes.file.mm_per_unit, 48, 0.1);
    const double step = 2 / meshes.file.mm_per_unit;
    for (const MeshVertex& vertex : mesh.vertices)
        EXPECT_NEAR(std::abs(glm::length(vertex.point) - 1), step, 0.005);
    const double shell = 2 * pi / 3 * (std::pow(1 + step, 3) - std::pow(1 - step, 3));
    EXPECT_NEAR(enclosed_volume(mesh), shell, 0.02 * shell);
}

TEST(MeshWall, OfAWavySheetIsClosed) {
    const DocumentMeshes meshes =
        meshed("z = sin(2x) cos(2y)/2", 2, {.tolerance = 0.02, .wall_mm = 2});
    ASSERT_EQ(meshes.surfaces.size(), 1U);
    EXPECT_EQ(defect_of(meshes.file.objects[0].mesh), "");
    EXPECT_EQ(euler_characteristic(meshes.file.objects[0].mesh), 2);
}

TEST(MeshWall, IsRefusedWhereTheSurfaceBendsMore) {
    ReadDocument read = read_document_text("x^2 + y^2 + z^2 = 1");
    const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    ASSERT_TRUE(prepared);
    const PictureRequest request =
        picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64});
    const auto meshes = mesh_document(request, {.tolerance = 0.02, .wall_mm = 60});
    ASSERT_FALSE(meshes);
    EXPECT_NE(meshes.error().reason.find("near"), std::string::npos) << meshes.error().reason;
}

TEST(MeshTriangles, AreAsFewAsWanted) {
    const MeshObject object =
        closed_mesh("x^2 + y^2 + z^2 = 1", 2, {.tolerance = 0.002, .most_triangles = 500});
    EXPECT_LE(object.mesh.triangles.size(), 500U);
    EXPECT_GT(object.mesh.triangles.size(), 100U);
    EXPECT_EQ(euler_characteristic(object.mesh), 2);
}

TEST(MeshDocument, HasAnObjectForEachSurfaceOrOneByNumber) {
    const std::string text = "x^2 + y^2 + z^2 = 1; (x - 1)^2 + y^2 + z^2 = 0.25";
    const DocumentMeshes both = meshed(text, 2, {.tolerance = 0.02});
    ASSERT_EQ(both.file.objects.size(), 2U);
    EXPECT_NE(both.file.objects[0].color, both.file.objects[1].color);
    const DocumentMeshes second = meshed(text, 2, {.tolerance = 0.02, .surface = 2});
    ASSERT_EQ(second.surfaces.size(), 1U);
    EXPECT_EQ(second.surfaces[0].number, 2U);
    EXPECT_NEAR(second.file.mm_per_unit, 100, 3);
}

TEST(MeshDocument, TakesTheColorsOfTheLook) {
    const auto by_height = [](Document& document) { document.coloring.by = ColorBy::Height; };
    const DocumentMeshes meshes = meshed("x^2 + y^2 + z^2 = 1", 2, {.tolerance = 0.02}, by_height);
    const MeshObject& object = meshes.file.objects.at(0);
    ASSERT_EQ(object.colors.size(), object.mesh.vertices.size());
    std::size_t low = 0;
    std::size_t high = 0;
    for (std::size_t v = 0; v < object.colors.size(); ++v) {
        if (object.mesh.vertices[v].point.z < object.mesh.vertices[low].point.z) low = v;
        if (object.mesh.vertices[v].point.z > object.mesh.vertices[high].point.z) high = v;
    }
    EXPECT_NE(object.colors[low], object.colors[high]);
}

/// Whatever the formula is, with poles, jumps and ends of its domain, the mesh is closed.
TEST(MeshOfRandomFormulas, IsClosed) {
    RandomNumbers random(20);
    const int formulas = formulas_to_try(8);
    int meshes_made = 0;
    for (int i = 0; i < formulas; ++i) {
        const std::string text = equation_text(random_expression(random, 4));
        ReadDocument read = read_document_text(text);
        if (!read.rows) continue;
        const MeshSettings settings{.tolerance = 0.2, .depth = 4};
        const DocumentMeshes meshes = meshed(text, 2, settings);
        for (const MeshObject& object : meshes.file.objects) {
            EXPECT_EQ(defect_of(object.mesh), "") << text;
            ++meshes_made;
        }
    }
    EXPECT_GT(meshes_made, formulas / 8);
}

}  // namespace
}  // namespace zeroset::test::mesh_document_test
