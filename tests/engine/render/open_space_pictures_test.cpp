#include "engine/measure/open_space.hpp"
#include "engine/render/render.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>

// Pictures drawn with the knowledge of where the surface is not, against those without.

namespace zeroset::test::open_space_pictures_test {
namespace {

constexpr int usual_size = 160;
constexpr int size_of_random = 80;  // formulas that nobody chose may take long

TraceSettings settings_with(Antialias antialias, bool shadows) {
    TraceSettings settings = settings_at("beams", 12);
    settings.antialias = antialias;
    settings.shadows = shadows;
    return settings;
}

Framebuffer picture(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                    Counters& counters, int size) {
    Framebuffer frame(size, size);
    frame.keep_planes(true);
    counters = render_frame(scene, camera, settings, frame);
    return frame;
}

/// Expects both pictures to be the same, and the second one to take no more evaluations.
void expect_same(Scene scene, const Camera& camera, const TraceSettings& settings,
                 const std::string& what, int size = usual_size) {
    Counters without, with;
    const Framebuffer known = picture(scene, camera, settings, with, size);
    for (Surface& surface : scene.surfaces)
        surface.open_space = nullptr;
    const Framebuffer plain = picture(scene, camera, settings, without, size);
    ASSERT_EQ(plain.certificate, known.certificate) << what;
    ASSERT_EQ(plain.depth, known.depth) << what;
    ASSERT_EQ(plain.color, known.color) << what;
    ASSERT_EQ(plain.light, known.light) << what;
    EXPECT_LE(with.form, without.form) << what;
}

/// Gives a scene whose w goes from lo to hi its open space.
void know(Scene& scene, double lo, double hi) {
    Uniforms uniforms;
    uniforms.set(0, lo, hi);
    for (Surface& surface : scene.surfaces) {
        surface.open_space = std::make_shared<const OpenSpace>(
            find_open_space(surface.kernel, scene.clip, uniforms, 5, scene.jumps, 2).space);
    }
}

Camera turned(const Scene& scene, double yaw) {
    return orbit(default_camera(scene.clip), yaw, 0.3 * yaw);
}

TEST(OpenSpacePictures, AreTheSameWithEveryLook) {
    const std::string texts[] = {"x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + 0.4 + 0.2 w",
                                 "(x^2 + y^2 + z^2 + 0.5)^2 = (2.5 + w)*(x^2 + y^2)",
                                 "min((x-w)^2 + y^2, (x+w)^2 + z^2, x^2 + (y-w)^2) + 0.1 z^2 - 0.2",
                                 "sin(4 x) + sin(4 y) + sin(4 z) - w"};
    const TraceSettings looks[] = {
        settings_with(Antialias::None, false), settings_with(Antialias::None, true),
        settings_with(Antialias::Beams, true), settings_with(Antialias::Rays4, false)};
    for (const std::string& text : texts) {
        Scene scene = scene_of(text, Box::cube(1.5));
        know(scene, 0.2, 0.4);
        for (const TraceSettings& look : looks) {
            for (const double w : {0.2, 0.27, 0.4}) {
                scene.uniforms.set(0, w);
                Camera camera = turned(scene, 5 * w);
                if (w == 0.27) camera.projection = Projection::Orthographic;
                expect_same(scene, camera, look, text);
            }
        }
    }
}

TEST(OpenSpacePictures, AreTheSameOfCutsSeveralSurfacesAndJumps) {
    Scene scene = scene_of("x^2 + y^2 + z^2 - 1 - w", Box::cube(1.5));
    scene.surfaces.push_back(scene_of("x + y - z^2 + w", scene.clip).surfaces.front());
    scene.region.ball = Ball{.centre = {0.1, 0, 0}, .radius = 1.2};
    scene.region.sections.push_back(make_section({1, 0.5, 0}, 0.4));
    scene.uniforms.set(0, 0.1);
    know(scene, 0.0, 0.2);
    for (const bool shadows : {false, true})
        expect_same(scene, turned(scene, 0.5), settings_with(Antialias::None, shadows), "cuts");
    Scene jumps = scene_of("floor(3 x) + y + w - 0.5", Box::cube(1.5));
    jumps.jumps = true;
    know(jumps, 0.0, 0.2);
    expect_same(jumps, turned(jumps, 0.5), settings_with(Antialias::None, false), "jumps");
}

TEST(OpenSpacePictures, AreTheSameOfRandomFormulas) {
    RandomNumbers random(23);
    for (int i = 0; i < formulas_to_try(25); ++i) {
        Scene scene;
        const Expr expr = random_expression(random, 3);
        scene.surfaces.push_back({.kernel = interpret(expr)});
        scene.clip = Box::cube(random.uniform(0.5, 4));
        const double lo = random.uniform(-2, 2);
        const double hi = lo + std::exp2(random.uniform(-10, 0));
        know(scene, lo, hi);
        scene.uniforms.set(0, random.one_in(3) ? hi : random.uniform(lo, hi));
        expect_same(scene, turned(scene, random.uniform(-3, 3)),
                    settings_with(Antialias::None, random.one_in(2)), expr.canonical(),
                    size_of_random);
    }
}

}  // namespace
}  // namespace zeroset::test::open_space_pictures_test
