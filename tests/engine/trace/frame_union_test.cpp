#include "engine/trace/frame_union.hpp"

#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "tests/support/csg_scenes.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

// The parts of a union in the tiles of an image, against spheres whose roots are known.

namespace zeroset::test::frame_union_test {
namespace {

constexpr int image_size = 192;

std::string sphere(double x, double y, double z, double radius) {
    return CsgSphere{{x, y, z}, radius}.text();
}

/// With the digits of its text.
CsgSphere as_typed(const CsgSphere& sphere) {
    return {glm::round(1e5 * sphere.centre) / 1e5,
            std::sqrt(std::round(1e7 * sphere.radius * sphere.radius) / 1e7)};
}

/// Along the ray, where it enters the sphere from outside.
std::optional<double> entry(const CsgSphere& sphere, const Ray& ray) {
    const glm::dvec3 from = ray.eye - sphere.centre;
    const double middle = -glm::dot(from, ray.direction);
    const double square = sphere.radius * sphere.radius -
                          glm::dot(from + middle * ray.direction, from + middle * ray.direction);
    if (square <= 0 || middle - std::sqrt(square) < ray.t_in) return std::nullopt;
    return middle - std::sqrt(square);
}

bool listed(const FrameUnion& all, const Tile& tile, std::vector<UnionMember>& parts) {
    const UpwardRounding upward;
    return all.list(tile, parts);
}

class View : public testing::TestWithParam<Camera> {};

TEST_P(View, ListsThePartsThatRaysMeet) {
    std::vector<CsgSphere> spheres = visible_spheres(60, suite_camera(1.0).eye);
    std::ranges::transform(spheres, spheres.begin(), as_typed);
    const Scene scene = scene_of(combined("min", spheres), Box::cube(1));
    const ViewFrame view(GetParam());
    const TraceFrame frame = trace_frame(scene, scene.surfaces[0], view,
                                         {.width = image_size, .height = image_size}, {});
    const UnionParts& union_parts = *scene.surfaces[0].kernel.specializer->union_parts();
    const FrameUnion all(frame, union_parts);
    Framebuffer picture(image_size, image_size);
    render_frame(scene, GetParam(), settings_at("beams", 22), picture);
    std::vector<UnionMember> parts;
    int hits = 0;
    for (int row = 0; row < image_size; ++row) {
        for (int col = 0; col < image_size; ++col) {
            if (!listed(all, {col / 64 * 64, row / 64 * 64, 64, 64}, parts)) continue;
            const Ray ray(GetParam(), scene.clip, col, row, picture);
            double first = INFINITY;
            for (std::size_t i = 0; i < spheres.size(); ++i) {
                const auto at = entry(spheres[i], ray);
                if (!at) continue;
                first = std::min(first, *at);
                const auto found =
                    std::ranges::find(parts, union_parts.kernels()[i], &UnionMember::kernel);
                ASSERT_NE(found, parts.end());
                const double depth =
                    glm::dot(ray.eye + *at * ray.direction - view.eye, view.forward) -
                    view.look_distance;
                EXPECT_LE(found->from, depth);
                EXPECT_GE(found->to, depth);
                ++hits;
            }
            const auto pixel = static_cast<std::size_t>(row * image_size + col);
            if (picture.certificate[pixel] == Certificate::Undecided) continue;
            EXPECT_NEAR(std::min(picture.depth[pixel], 1e9F), std::min(first, 1e9), 1e-5);
        }
    }
    EXPECT_GT(hits, 1000);
}

Camera parallel(Camera camera) {
    camera.projection = Projection::Orthographic;
    return camera;
}

INSTANTIATE_TEST_SUITE_P(All, View,
                         testing::Values(suite_camera(1.0), parallel(suite_camera(1.0)),
                                         Camera{{0.9, -0.95, 0.9}, {0, 0, 0}, {0, 0, 1}, 1.2},
                                         Camera{{3, 0.1, 0.2}, {0.4, 0.1, 0}, {0, 1, 0}, 0.1}));

/// How many tiles cannot be searched part by part.
int tiles_as_whole(const std::string& text, const Camera& camera) {
    const Scene scene = scene_of(text, Box::cube(1));
    const TraceFrame frame = trace_frame(scene, scene.surfaces[0], ViewFrame(camera),
                                         {.width = image_size, .height = image_size}, {});
    const FrameUnion all(frame, *scene.surfaces[0].kernel.specializer->union_parts());
    std::vector<UnionMember> parts;
    int count = 0;
    for (int tile = 0; tile < 9; ++tile)
        count += listed(all, {tile % 3 * 64, tile / 3 * 64, 64, 64}, parts) ? 0 : 1;
    return count;
}

TEST(FrameUnion, AreApartWhereRaysBeginOutside) {
    const Camera camera = suite_camera(1.0);
    const std::string one = sphere(0.1, 0, 0, 0.4);
    EXPECT_EQ(tiles_as_whole("min(" + one + ", " + sphere(-0.2, 0, 0, 0.5) + ")", camera), 0);
    // Cut by a face of the box where rays enter, and by one where they leave.
    EXPECT_GT(tiles_as_whole("min(" + one + ", " + sphere(0, 0, 0.9, 0.5) + ")", camera), 0);
    EXPECT_EQ(tiles_as_whole("min(" + one + ", " + sphere(0, 0, -0.9, 0.5) + ")", camera), 0);
    EXPECT_GT(tiles_as_whole("min(" + one + ", z + 0.1)", camera), 0);
    EXPECT_GT(tiles_as_whole("min(" + one + ", " + one + " + sqrt(0.5 - z))", camera), 0);
}

TEST(FrameUnion, AreNotApartWhereTheEyeIsInOne) {
    const std::string text = "min(" + sphere(0, 0, 0, 0.5) + ", " + sphere(0.4, 0, 0, 0.3) + ")";
    EXPECT_GT(tiles_as_whole(text, {{0.1, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0.7}), 0);
    EXPECT_EQ(tiles_as_whole(text, {{-0.9, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0.7}), 0);
}

}  // namespace
}  // namespace zeroset::test::frame_union_test
