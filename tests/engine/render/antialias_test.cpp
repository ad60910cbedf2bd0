#include "engine/render/render.hpp"
#include "tests/support/alike_frames.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

// Smooth edges: more rays for the colours, and nothing else.

namespace zeroset::test::antialias_test {
namespace {

Framebuffer picture_of(const std::string& text, Antialias antialias) {
    const Scene scene = scene_of(text, Box::cube(1.2));
    Framebuffer frame(141, 101);
    TraceSettings settings;
    settings.antialias = antialias;
    render_frame(scene, default_camera(scene.clip), settings, frame);
    return frame;
}

TEST(Antialias, ChangesColoursAtEdgesOnly) {
    const Framebuffer plain = picture_of("x^2 + y^2 + z^2 = 1", Antialias::None);
    const Framebuffer smooth = picture_of("x^2 + y^2 + z^2 = 1", Antialias::Beams);
    EXPECT_EQ(smooth.depth, plain.depth);
    EXPECT_EQ(smooth.certificate, plain.certificate);
    EXPECT_EQ(smooth.surface, plain.surface);
    std::size_t mixed = 0;
    for (int row = 1; row + 1 < plain.height; ++row) {
        for (int col = 1; col + 1 < plain.width; ++col) {
            const std::size_t at = plain.index(col, row);
            bool edge = false;
            for (int i = 0; i < 9; ++i) {
                const std::size_t beside = plain.index(col + i % 3 - 1, row + i / 3 - 1);
                edge = edge || plain.surface[beside] != plain.surface[at];
            }
            // Without an edge the four rays around see nearly the same.
            const int change = color_change(plain.color[at], smooth.color[at]);
            if (edge) {
                mixed += change > 10 ? 1U : 0U;
            } else {
                ASSERT_LE(change, 3) << col << ", " << row;
            }
        }
    }
    EXPECT_GT(mixed, 50U);
}

/// Pixels that differ by more than 16 of 255 in a channel.
std::size_t far_pixels(const Framebuffer& a, const Framebuffer& b) {
    return different_pixels(a, b, 16);
}

/// A picture of a scene from its usual side.
Framebuffer picture_of(const Scene& scene, TraceSettings settings, Antialias antialias) {
    Framebuffer frame(181, 131);
    settings.antialias = antialias;
    render_frame(scene, default_camera(scene.clip), settings, frame);
    return frame;
}

/// Expects pictures by beams to differ from ones by many rays in so many pixels at most, and those
/// by one ray a pixel in more than 200.
void expect_near_many_rays(const Scene& scene, const TraceSettings& settings, std::size_t most) {
    const Framebuffer many = picture_of(scene, settings, Antialias::Rays64);
    EXPECT_LE(far_pixels(picture_of(scene, settings, Antialias::Beams), many), most);
    EXPECT_GT(far_pixels(picture_of(scene, settings, Antialias::None), many), 200U);
}

TEST(Antialias, IsNearToManyRaysAtEdgesOfSurfacesAndShadows) {
    const Scene scene = scene_of("min(z + 0.8, x^2 + y^2 + z^2 - 0.4)", Box::cube(1.2));
    TraceSettings settings;
    settings.shadows = true;
    expect_near_many_rays(scene, settings, 6);
}

TEST(Antialias, IsNearToManyRaysWhereSurfacesMeetAndHideEachOther) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    for (const char* const text : {"(x - 0.7)^2 + y^2 + (z - 0.3)^2 = 0.8", "z = 0.2 x - 0.2"})
        scene.surfaces.push_back(scene_of(text, scene.clip).surfaces.front());
    expect_near_many_rays(scene, {}, 2);
}

TEST(Antialias, IsNearToManyRaysInMirrorsAndBehindTranslucentSurfaces) {
    Scene scene = scene_of("z = -0.7", Box::cube(1.5));
    for (const char* const text : {"x^2 + y^2 + z^2 = 0.4", "(x + 0.2)^2 + (y + 1)^2 + z^2 = 0.16"})
        scene.surfaces.push_back(scene_of(text, scene.clip).surfaces.front());
    scene.lighting.look = Look::Porcelain;
    scene.surfaces.back().look = {.opacity = 0.3};
    TraceSettings settings;
    settings.reflections = 2;
    settings.soft_light = false;
    expect_near_many_rays(scene, settings, 20);
}

TEST(Antialias, ShowsWhatLiesBetweenThePixels) {
    // A wire thinner than a pixel: broken without, seamless with more rays.
    const auto rows_with = [](const Framebuffer& frame) {
        std::size_t count = 0;
        for (int row = 0; row < frame.height; ++row) {
            bool any = false;
            for (int col = 0; col < frame.width; ++col) {
                const std::uint32_t color = frame.color[frame.index(col, row)];
                any = any || color != frame.color[frame.index(0, row)];
            }
            count += any ? 1U : 0U;
        }
        return count;
    };
    const std::string wire = "(x - 0.3 z)^2 + y^2 = 0.00002";
    EXPECT_GT(rows_with(picture_of(wire, Antialias::Beams)),
              rows_with(picture_of(wire, Antialias::None)));
}

/// A picture from the suite's side.
Framebuffer suite_picture_of(const char* text, double half_edge, int width, int height,
                             Antialias antialias) {
    Framebuffer frame(width, height);
    TraceSettings settings;
    settings.antialias = antialias;
    render_frame(scene_of(text, Box::cube(half_edge)), suite_camera(half_edge), settings, frame);
    return frame;
}

/// Rays enter the clip box behind the surface at a corner of pixels on the box's edges only.
TEST(Antialias, IsNearToManyRaysWhereCornersOfPixelsEnterBehindASheet) {
    // Beside the dark background a hundredth of a pixel is seen: 64 rays miss as much.
    const auto many_rays = [](const char* text, double half_edge) {
        return averaged(suite_picture_of(text, half_edge, 4 * 320, 4 * 180, Antialias::Rays64), 4);
    };
    const char* const cone = "abs(x) + abs(y) - z";
    EXPECT_LE(
        far_pixels(suite_picture_of(cone, 2.0, 320, 180, Antialias::Beams), many_rays(cone, 2.0)),
        1U);
    // In long stretches behind a wall there may be more sheets beside the edge in that.
    const char* const inverse = "1/(x - y^2) - z";
    EXPECT_EQ(far_pixels(suite_picture_of(inverse, 2.0, 320, 180, Antialias::Beams),
                         many_rays(inverse, 2.0)),
              0U);
}

/// Edges in walls of the clip box, beside which another surface is seen, another sheet of the same
/// one, or nearly all of a pixel that is told by quarters.
TEST(Antialias, LosesNothingBesideEdgesInWalls) {
    const auto lost = [](const Scene& scene, const Camera& camera, int width, int height) {
        const auto picture = [&](Antialias antialias, int scale) {
            Framebuffer frame(scale * width, scale * height);
            TraceSettings settings;
            settings.antialias = antialias;
            render_frame(scene, camera, settings, frame);
            return frame;
        };
        return different_pixels(picture(Antialias::Beams, 1),
                                averaged(picture(Antialias::Rays16, 4), 4), 40);
    };
    Scene scene = scene_of("sin(5.785x) = 0.2079z", Box::cube(0.7099));
    scene.surfaces.push_back(scene_of("y = 0.3x", scene.clip).surfaces.front());
    Camera camera = default_camera(scene.clip);
    camera.eye = {-1.967, 2.65, 2.647};
    camera.look_at = {0, 0, 0};
    camera.fov_rad = glm::radians(42.0);
    camera.projection = Projection::Orthographic;
    EXPECT_EQ(lost(scene, camera, 300, 300), 0U);
    const Scene waves = scene_of("sin(5.265x) sin(1.563y) = 1.427z", Box::cube(2));
    EXPECT_EQ(lost(waves, default_camera(waves.clip), 160, 120), 0U);
    const Scene sheets = scene_of("sin(8.613x) + sin(8.681y) + sin(8.613z) = 0", Box::cube(0.9969));
    camera.eye = {0.07498, 2.356, -1.495};
    camera.projection = Projection::Perspective;
    EXPECT_LE(lost(sheets, camera, 100, 100), 1U);
}

/// In the middle of this asterisk a sheet and its back lie close behind each other, in a long
/// stretch of rays at whose both ends f has one sign.
TEST(Antialias, LeavesNoHoleWhereASheetAndItsBackAreInOneStretch) {
    const char* const asterisk =
        "sin(3*atan2(y,x))*sin(4*acos(z/sqrt(x^2+y^2+z^2))) - sqrt(x^2+y^2+z^2)";
    const auto picture = [&](Antialias antialias) {
        return suite_picture_of(asterisk, 1.1, 500, 500, antialias);
    };
    const Framebuffer beams = picture(Antialias::Beams);
    const Framebuffer rays = picture(Antialias::Rays16);
    for (int row = 240; row < 260; ++row) {
        for (int col = 240; col < 260; ++col) {
            const std::size_t at = beams.index(col, row);
            for (unsigned shift = 0; shift < 24; shift += 8)
                EXPECT_NEAR(beams.color[at] >> shift & 255U, rays.color[at] >> shift & 255U, 60)
                    << col << ", " << row;
        }
    }
}

/// Beyond the Roman surface an axis goes on as a line without width, here between two pixels.
TEST(Antialias, LeavesNoGapInALineOnTheBorderOfPixels) {
    const Scene scene = scene_of("x^2*y^2 + y^2*z^2 + x^2*z^2 + x*y*z", Box::cube(1));
    Camera camera = default_camera(scene.clip);
    camera.eye = {1.259, 1.259, 1.007};
    camera.look_at = {0, 0, 0};
    camera.fov_rad = glm::radians(42.0);
    Framebuffer frame(500, 500);
    TraceSettings settings;
    settings.antialias = Antialias::Beams;
    render_frame(scene, camera, settings, frame);
    constexpr int first_row = 20;  // of the line, which the surface ends
    constexpr int last_row = 90;
    constexpr int middle = 250;
    for (int row = first_row; row <= last_row; ++row) {
        const std::uint32_t beside = frame.color[frame.index(middle - 20, row)];
        EXPECT_TRUE(frame.color[frame.index(middle - 1, row)] != beside ||
                    frame.color[frame.index(middle, row)] != beside)
            << row;
    }
}

TEST(Antialias, LeavesASceneWithoutSurfacesAsItIs) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    scene.surfaces.clear();
    Framebuffer plain(70, 50);
    Framebuffer smooth(70, 50);
    const Camera camera = default_camera(scene.clip);
    render_frame(scene, camera, {}, plain);
    TraceSettings settings;
    settings.antialias = Antialias::Beams;
    render_frame(scene, camera, settings, smooth);
    EXPECT_EQ(smooth.color, plain.color);
    EXPECT_EQ(smooth.surface, plain.surface);
}

}  // namespace
}  // namespace zeroset::test::antialias_test
