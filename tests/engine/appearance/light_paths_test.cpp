#include "engine/appearance/lights.hpp"
#include "engine/image/gamma.hpp"
#include "engine/rays/first_roots.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

// Mirrors, translucent surfaces and lights, in pictures.

namespace zeroset::test::light_paths_test {
namespace {

constexpr int side = 64;

Scene scene_of_texts(const std::vector<std::string>& texts, const Box& clip) {
    Scene scene = scene_of(texts.front(), clip);
    for (std::size_t i = 1; i < texts.size(); ++i)
        scene.surfaces.push_back(scene_of(texts[i], clip).surfaces[0]);
    for (std::size_t i = 0; i < texts.size(); ++i)
        scene.surfaces[i].colors = colors_of(i);
    return scene;
}

Framebuffer picture_of(const Scene& scene, const Camera& camera, const TraceSettings& settings) {
    Framebuffer frame(side, side);
    render_frame(scene, camera, settings, frame);
    return frame;
}

std::array<float, 3> light_at(const Framebuffer& frame, int col, int row) {
    const std::uint32_t color = frame.color[frame.index(col, row)];
    return {light_of_channel(color & 0xFFU), light_of_channel(color >> 8U & 0xFFU),
            light_of_channel(color >> 16U & 0xFFU)};
}

std::size_t different_pixels(const Framebuffer& a, const Framebuffer& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        count += a.color[i] != b.color[i] ? 1U : 0U;
    return count;
}

TEST(Mirrors, FacingEachOtherShowAsManyLevelsAsAskedFor) {
    Scene scene =
        scene_of_texts({"x = -1", "x = 1", "x^2 + y^2 + (z - 0.2)^2 = 0.09"}, Box::cube(2));
    scene.lighting.look = Look::Metal;
    Camera camera = default_camera(scene.clip);
    camera.eye = {0.5, -1.2, 0.1};
    camera.look_at = {-1.0, 0.0, 0.0};
    TraceSettings settings;
    Framebuffer last = picture_of(scene, camera, settings);
    for (int levels = 1; levels <= max_reflections; ++levels) {
        settings.reflections = levels;
        const Framebuffer next = picture_of(scene, camera, settings);
        EXPECT_GT(different_pixels(last, next), 8U) << levels;
        EXPECT_EQ(next.depth, last.depth);
        last = next;
    }
}

TEST(Mirrors, ShowWhatTheMirroredEyeSees) {
    const Scene scene = scene_of_texts({"x^2 + y^2 + (z - 1)^2 = 0.5"}, Box::cube(2));
    const Camera camera = default_camera(scene.clip);
    const ViewFrame view(camera);
    const ImageSize image{.width = side, .height = side};
    const TraceFrame frame = trace_frame(scene, scene.surfaces.front(), view, image, {});
    std::vector<SceneRay> mirrored;
    std::vector<SceneRay> straight;
    std::vector<double> before;
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
            const PixelRay ray = pixel_ray(view, pixel_centre(col, row), image);
            const double t = -ray.origin.z / ray.direction.z;  // to the mirror z = 0
            if (!(t > 0.0)) continue;
            const glm::dvec3 flip(1.0, 1.0, -1.0);
            before.push_back(t);
            mirrored.push_back(
                {.origin = ray.at(t), .direction = UnitVector(flip * glm::dvec3(ray.direction))});
            straight.push_back({.origin = flip * ray.origin,
                                .direction = UnitVector(flip * glm::dvec3(ray.direction)),
                                .from = t});
        }
    }
    std::vector<RayHit> a(mirrored.size());
    std::vector<RayHit> b(mirrored.size());
    const UpwardRounding upward;
    Counters counters;
    find_first_hits({&frame, 1}, mirrored, a, counters);
    find_first_hits({&frame, 1}, straight, b, counters);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].is_hit(), b[i].is_hit()) << i;
        if (!a[i].is_hit()) continue;
        ++hits;
        EXPECT_NEAR(before[i] + a[i].t, b[i].t, 1e-9);
    }
    EXPECT_GT(hits, 100U);
}

TEST(Layers, OfNestedSpheresAreMixedFromTheFrontToTheBack) {
    Scene opaque =
        scene_of_texts({"x^2 + y^2 + z^2 = 1", "x^2 + y^2 + z^2 = 0.25", "x^2 + y^2 + z^2 = 0.04"},
                       Box::cube(1.5));
    opaque.lighting.look = Look::Matte;  // without gloss, which is as bright on glass
    const Camera camera = default_camera(opaque.clip);
    // The light of each sheet alone, seen at the middle of the picture: of the front and of the
    // back of each sphere.
    const auto sheet = [&](std::size_t surface, bool front) {
        Scene alone = opaque;
        alone.surfaces = {opaque.surfaces[surface]};
        if (!front) {
            const glm::dvec3 forward = glm::normalize(camera.look_at - camera.eye);
            alone.region.sections.push_back(make_section(-forward, 0.0, false));
        }
        return light_at(picture_of(alone, camera, {}), side / 2, side / 2);
    };
    Scene scene = opaque;
    const std::array<double, 3> opacity{0.3, 0.5, 1.0};
    for (std::size_t i = 0; i < opacity.size(); ++i)
        scene.surfaces[i].look = {.opacity = opacity[i]};
    const auto seen = light_at(picture_of(scene, camera, {}), side / 2, side / 2);
    const auto outer = sheet(0, true);
    const auto middle = sheet(1, true);
    const auto inner = sheet(2, true);
    for (std::size_t i = 0; i < 3; ++i) {
        const float mixed = 0.3F * outer[i] + 0.7F * (0.5F * middle[i] + 0.5F * inner[i]);
        EXPECT_NEAR(seen[i], mixed, 0.01F);
    }
    // Where only the outer sphere is in the way: its front, its back, the background.
    scene.surfaces.resize(1);
    const Framebuffer frame = picture_of(scene, camera, {});
    const auto through = light_at(frame, side / 2, side / 2);
    const auto back = sheet(0, false);
    const std::uint32_t behind = background_color(frame.background, side / 2, side);
    for (std::size_t i = 0; i < 3; ++i) {
        const float ground = light_of_channel(behind >> 8 * i & 0xFFU);
        const float mixed = 0.3F * outer[i] + 0.7F * (0.3F * back[i] + 0.7F * ground);
        EXPECT_NEAR(through[i], mixed, 0.01F);
    }
    const std::uint32_t alpha = frame.color[frame.index(side / 2, side / 2)] >> 24U;
    EXPECT_NEAR(alpha, 255.0 * (1.0 - 0.49), 1.0);
}

/// The greatest difference of a channel.
int difference(std::uint32_t a, std::uint32_t b) {
    int greatest = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        const auto channel = [shift](std::uint32_t color) {
            return static_cast<int>(color >> shift & 0xFFU);
        };
        greatest = std::max(greatest, std::abs(channel(a) - channel(b)));
    }
    return greatest;
}

TEST(Looks, OfSingleSurfacesAreThoseThatAllWouldHave) {
    Scene scene = scene_of_texts({"(x - 1)^2 + y^2 + z^2 = 0.5", "(x + 1)^2 + y^2 + z^2 = 0.5"},
                                 Box::cube(2));
    Camera camera = default_camera(scene.clip);
    camera.eye = {0, -8, 0};
    camera.look_at = {0, 0, 0};
    const auto picture = [&](Look all, const std::array<SurfaceLook, 2>& own) {
        scene.lighting.look = all;
        for (std::size_t i = 0; i < own.size(); ++i)
            scene.surfaces[i].look = own[i];
        return picture_of(scene, camera, {});
    };
    for (const Look look : looks()) {
        if (look == Look::Phong) continue;  // it has a light of its own, which is the picture's
        const Framebuffer alone = picture(look, {});
        const Framebuffer other = picture(Look::Matte, {});
        const Framebuffer mixed = picture(Look::Clay, {{{.look = look}, {.look = Look::Matte}}});
        ASSERT_GT(count_surfaces(mixed, 2)[0], 100U);
        ASSERT_GT(count_surfaces(mixed, 2)[1], 100U);
        for (std::size_t i = 0; i < mixed.color.size(); ++i) {
            if (mixed.surface[i] == no_surface) continue;
            const Framebuffer& same = mixed.surface[i] == 0 ? alone : other;
            EXPECT_LE(difference(mixed.color[i], same.color[i]), 1) << name_of(look) << ' ' << i;
        }
    }
}

TEST(Layers, SwallowTheColoursThatTheyAreNotByTheirThickness) {
    Scene scene = scene_of_texts({"max(|x| - 0.5, |y| - 3, |z| - 3)"}, Box::cube(2));
    scene.lighting.look = Look::Matte;
    scene.surfaces[0].look = {.opacity = 0.0};
    scene.lighting.absorption = 1.5;
    scene.background = {.top = 0xFFFFFF, .bottom = 0xFFFFFF};
    Camera camera = default_camera(scene.clip);
    camera.eye = {8, 0, 0};
    camera.look_at = {0, 0, 0};
    const auto seen = light_at(picture_of(scene, camera, {}), side / 2, side / 2);
    const SurfaceColors& colors = scene.colors_of_surface(0);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(seen[i], std::exp(-1.5F * 1.0F * (1.0F - colors.front[i])), 0.02F);
}

TEST(Lights, OfTheirOwnTakeThePlaceOfTheLooks) {
    Scene scene = scene_of_texts({"z = 0"}, Box::cube(1));
    scene.lighting.look = Look::Matte;
    Camera camera = default_camera(scene.clip);
    camera.eye = {0.1, 0, 5};
    const auto light_of = [&](const glm::dvec3& towards, double power) {
        scene.lighting.lights = {{.towards = towards, .with_camera = false, .power = power}};
        return light_at(picture_of(scene, camera, {}), side / 2, side / 2)[2];
    };
    const float none = light_of({0, 0, 1}, 0.0);
    const float straight = light_of({0, 0, 1}, 0.5) - none;
    const float slanted = light_of({1, 0, 1}, 0.5) - none;
    EXPECT_GT(straight, 0.2F);
    EXPECT_NEAR(slanted / straight, std::sqrt(0.5), 0.02);
    EXPECT_NEAR(light_of({0, 0, -1}, 0.5), none, 0.005F);
}

TEST(Lights, ThatAreBroadThrowSoftShadows) {
    Scene scene = scene_of_texts({"z = -1", "x^2 + y^2 + z^2 = 0.25"}, Box::cube(2));
    Camera camera = default_camera(scene.clip);
    camera.eye = {0.1, -0.2, 7};
    const auto steps_of = [&](double radius_deg) {
        scene.lighting.lights = {
            {.towards = {0.5, 0, 1}, .with_camera = false, .radius_deg = radius_deg}};
        TraceSettings settings;
        settings.shadows = true;
        const Framebuffer frame = picture_of(scene, camera, settings);
        std::vector<std::uint32_t> shades;
        for (std::size_t i = 0; i < frame.color.size(); ++i) {
            if (frame.surface[i] == 0) shades.push_back(frame.color[i]);
        }
        std::ranges::sort(shades);
        return std::ranges::unique(shades).begin() - shades.begin();
    };
    EXPECT_GT(steps_of(15.0), steps_of(0.0) + 10);
}

TEST(Looks, ShowTheSameSurfaceEachInItsWay) {
    const Scene scene =
        scene_of_texts({"x^4 + y^4 + z^4 - (x^2 + y^2 + z^2) = -0.4"}, Box::cube(1.5));
    const Camera camera = default_camera(scene.clip);
    const Framebuffer standard = picture_of(scene, camera, {});
    for (const Look look : looks()) {
        if (look == Look::Standard) continue;
        Scene other = scene;
        other.lighting.look = look;
        const Framebuffer frame = picture_of(other, camera, {});
        EXPECT_EQ(frame.depth, standard.depth) << name_of(look);
        EXPECT_EQ(frame.certificate, standard.certificate) << name_of(look);
        EXPECT_GT(different_pixels(frame, standard), 300U) << name_of(look);
        for (std::size_t i = 0; i < frame.color.size(); ++i) {
            if (frame.surface[i] == no_surface) {
                ASSERT_EQ(frame.color[i], standard.color[i]);
            } else {
                ASSERT_NE(frame.color[i] & 0xFFFFFFU, 0U) << name_of(look) << ": black";
            }
        }
    }
}

/// The mean of the hits' colours in a quarter of a picture, and how far they are from it on the
/// mean: 0 to 255.
struct Tint {
    double red, green, blue, spread;
};
Tint tint_of(const Framebuffer& frame, int quarter) {
    std::array<double, 3> sum{};
    std::array<double, 3> squares{};
    double count = 0.0;
    for (int row = quarter / 2 * side / 2; row < (quarter / 2 + 1) * side / 2; ++row) {
        for (int col = quarter % 2 * side / 2; col < (quarter % 2 + 1) * side / 2; ++col) {
            const std::size_t at = frame.index(col, row);
            if (frame.surface[at] == no_surface) continue;
            count += 1.0;
            for (unsigned i = 0; i < 3; ++i) {
                const double channel = frame.color[at] >> 8U * i & 0xFFU;
                sum[i] += channel;
                squares[i] += channel * channel;
            }
        }
    }
    double variance = 0.0;
    for (unsigned i = 0; i < 3; ++i)
        variance += squares[i] / count - sum[i] / count * sum[i] / count;
    return {sum[0] / count, sum[1] / count, sum[2] / count, std::sqrt(variance)};
}

TEST(Looks, StayAsTheyWereSeenToBeRight) {
    Scene scene =
        scene_of_texts({"x^4 + y^4 + z^4 - (x^2 + y^2 + z^2) = -0.4", "z = -0.95"}, Box::cube(1.3));
    const Camera camera = default_camera(scene.clip);
    const std::vector<std::pair<Look, std::array<Tint, 2>>> known{
        {Look::Standard, {{{86.6, 131.5, 185.0, 60.4}, {51.7, 111.7, 126.4, 49.9}}}},
        {Look::Phong, {{{84.0, 125.5, 175.3, 66.4}, {45.3, 94.3, 104.2, 53.7}}}},
        {Look::Matte, {{{68.9, 123.7, 186.7, 53.5}, {42.8, 112.3, 128.4, 55.1}}}},
        {Look::Porcelain, {{{141.6, 162.7, 194.4, 68.5}, {112.7, 137.8, 147.3, 51.2}}}},
        {Look::Metal, {{{113.8, 129.6, 154.1, 93.2}, {89.1, 111.9, 122.4, 74.4}}}},
        {Look::Glass, {{{102.5, 114.6, 131.7, 40.7}, {84.0, 100.2, 106.1, 35.9}}}},
        {Look::Clay, {{{141.3, 143.5, 160.5, 58.9}, {114.0, 119.9, 121.7, 54.1}}}},
        {Look::Technical, {{{150.1, 155.4, 163.2, 124.1}, {124.7, 130.8, 133.9, 107.5}}}},
    };
    ASSERT_EQ(known.size(), looks().size());
    for (const auto& [look, tints] : known) {
        scene.lighting.look = look;
        TraceSettings settings;
        settings.shadows = true;
        settings.reflections = look == Look::Matte || look == Look::Clay ? 0 : 2;
        const Framebuffer frame = picture_of(scene, camera, settings);
        for (std::size_t i = 0; i < 2; ++i) {
            const Tint tint = tint_of(frame, i == 0 ? 0 : 3);
            EXPECT_NEAR(tint.red, tints[i].red, 1.0) << name_of(look);
            EXPECT_NEAR(tint.green, tints[i].green, 1.0) << name_of(look);
            EXPECT_NEAR(tint.blue, tints[i].blue, 1.0) << name_of(look);
            EXPECT_NEAR(tint.spread, tints[i].spread, 1.5) << name_of(look);
        }
    }
}

}  // namespace
}  // namespace zeroset::test::light_paths_test
