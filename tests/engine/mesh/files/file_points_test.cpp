#include "engine/mesh/files/file_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <vector>

namespace zeroset::test::file_points_test {
namespace {

using Place = std::array<float, 3>;

MeshObject object_at(const std::vector<glm::dvec3>& points) {
    MeshObject object{.name = "a", .mesh = {}};
    for (const glm::dvec3& point : points)
        object.mesh.vertices.push_back({.point = point});
    return object;
}

TEST(FilePoints, NoTwoOfAFileAreEqual) {
    const double near = 1 + 1e-9;  // 1 as a float
    MeshFile file{.objects = {object_at({{1, 2, 3}, {near, 2, 3}, {0, 0, 0}, {-0.0, 0, 0}}),
                              object_at({{1, 2, 3}, {-4, 1, 2}, {-4, 1, 2}, {0, 0, 0}})},
                  .mm_per_unit = 2};
    const FilePoints points(file);
    std::set<Place> places;
    for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_EQ(points.of(i).size(), 4U);
        for (std::size_t v = 0; v < 4; ++v) {
            const glm::vec3& point = points.of(i)[v];
            EXPECT_TRUE(places.insert({point.x, point.y, point.z}).second) << i << " " << v;
            const glm::dvec3 wanted = 2.0 * file.objects[i].mesh.vertices[v].point;
            EXPECT_LT(glm::length(glm::dvec3(point) - wanted), 4e-6);
        }
    }
    EXPECT_EQ(points.of(0)[0], glm::vec3(2, 4, 6)) << "the first of equal points stays";
}

TEST(FilePoints, TakeAnyNumbers) {
    const double infinite = std::numeric_limits<double>::infinity();
    const MeshFile file{.objects = {object_at({{infinite, 0, 0},
                                               {infinite, 0, 0},
                                               {0, infinite, 0},
                                               {0, infinite, 0},
                                               {1e300, 0, 0},
                                               {std::nan(""), 0, 0}})}};
    EXPECT_EQ(FilePoints(file).of(0).size(), 6U);
    EXPECT_EQ(FilePoints({.objects = {object_at({})}}).of(0).size(), 0U);
}

/// Two tetrahedra that share an edge, each closed: joined at equal points their edge had four
/// triangles.
TEST(FilePoints, KeepAnStlWithoutBranches) {
    MeshObject object = object_at(
        {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}});
    for (const std::uint32_t first : {0U, 4U}) {
        for (const Triangle& t : {Triangle{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
            object.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    const MeshFile file{.objects = {object}};
    const auto bytes = mesh_format_of("a.stl")->encode(file);
    ASSERT_TRUE(bytes) << bytes.error();
    std::set<Place> places;
    for (std::size_t triangle = 0; triangle < 8; ++triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Place place{};
            std::memcpy(place.data(), bytes->data() + 84 + 50 * triangle + 12 * (corner + 1),
                        sizeof place);
            places.insert(place);
        }
    }
    EXPECT_EQ(places.size(), 8U);
}

}  // namespace
}  // namespace zeroset::test::file_points_test
