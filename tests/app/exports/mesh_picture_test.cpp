#include "app/exports/previews.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace zeroset::mesh_picture_test {
namespace {

/// A triangle across the view, at this height above the origin.
MeshObject triangle_at(double height, MeshColor color) {
    MeshObject object;
    object.mesh.vertices = {
        {.point = {-1, -1, height}}, {.point = {1, -1, height}}, {.point = {0, 1, height}}};
    object.mesh.triangles = {{0, 1, 2}};
    object.color = color;
    return object;
}

Camera from_above() {
    return {.eye = {0, 0, 5}, .look_at = {0, 0, 0}, .up = {0, 1, 0}, .fov_rad = 0.6};
}

class MeshPicture : public testing::TestWithParam<Projection> {};

TEST_P(MeshPicture, ShowsTheNearerTriangle) {
    Camera camera = from_above();
    camera.projection = GetParam();
    MeshFile file;
    file.objects = {triangle_at(0.5, {255, 0, 0}), triangle_at(0.0, {0, 0, 255})};
    for (int order = 0; order < 2; ++order) {
        const RgbaImage image = mesh_picture(file, camera, {41, 41});
        const std::uint32_t middle = image.pixels[20 * 41 + 20];
        EXPECT_EQ(middle >> 24U, 0xFFU);
        EXPECT_GT(middle & 0xFFU, 100U);       // red
        EXPECT_EQ(middle >> 16U & 0xFFU, 0U);  // no blue
        EXPECT_EQ(image.pixels.front(), 0U);   // nothing is seen in the corner
        std::swap(file.objects[0], file.objects[1]);
    }
}

TEST_P(MeshPicture, ShowsAllFromAnyDistance) {
    Camera camera = from_above();
    camera.projection = GetParam();
    MeshFile file;
    file.objects = {triangle_at(0.0, {255, 255, 255})};
    const RgbaImage near = mesh_picture(file, camera, {41, 41});
    camera.eye *= 100.0;
    const RgbaImage far = mesh_picture(file, camera, {41, 41});
    const auto seen = [](const RgbaImage& image) {
        return std::ranges::count_if(image.pixels, [](std::uint32_t pixel) { return pixel != 0; });
    };
    EXPECT_GT(seen(near), 300);
    EXPECT_EQ(seen(near), seen(far));
}

TEST_P(MeshPicture, IsEmptyWithoutTriangles) {
    const RgbaImage image = mesh_picture({}, from_above(), {8, 8});
    EXPECT_EQ(image.pixels, std::vector<std::uint32_t>(64));
}

INSTANTIATE_TEST_SUITE_P(Projections, MeshPicture,
                         testing::Values(Projection::Perspective, Projection::Orthographic));

}  // namespace
}  // namespace zeroset::mesh_picture_test
