#include "engine/light/shadow.hpp"

#include "engine/language/parse.hpp"
#include "engine/light/shade.hpp"
#include "engine/render/render.hpp"
#include "engine/render/tracers.hpp"
#include "engine/rewrite/traceable.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Shadows, against the known shadows of spheres and cylinders.

namespace zeroset::test::shadow_test {
namespace {

constexpr int side = 96;

Framebuffer picture_of(const Scene& scene, const Camera& camera, const std::string& tracer,
                       bool shadows) {
    Framebuffer frame(side, side);
    TraceSettings settings;
    settings.tracer = tracer;
    settings.shadows = shadows;
    render_frame(scene, camera, settings, frame);
    return frame;
}

/// Where the way from `from` to `to` leaves the box.
glm::dvec3 exit_of(const glm::dvec3& from, const glm::dvec3& to, const Box& box) {
    double t = 1.0;
    for (int i = 0; i < 3; ++i) {
        const double end = to[i] > from[i] ? box.hi[i] : box.lo[i];
        t = std::min(t, (end - from[i]) / (to[i] - from[i]));
    }
    return from + t * (to - from);
}

/// How far a sphere or, where `cylinder`, a cylinder about the z axis is from the way between two
/// points.
double clearance(const glm::dvec3& from, const glm::dvec3& to, double radius, bool cylinder) {
    const glm::dvec3 only(1.0, 1.0, cylinder ? 0.0 : 1.0);
    const glm::dvec3 a = from * only;
    const glm::dvec3 way = (to - from) * only;
    const double t = glm::clamp(-glm::dot(a, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::length(a + t * way) - radius;
}

struct Occluder {
    std::string text;
    double radius;
    bool cylinder;
};

class Shadow : public testing::TestWithParam<std::string> {};

TEST_P(Shadow, FallsWhereTheLightIsHidden) {
    const std::vector<Occluder> occluders{{"x^2 + y^2 + z^2 = 0.25", 0.5, false},
                                          {"x^2 + y^2 = 0.0009", 0.03, true}};
    for (const Occluder& occluder : occluders) {
        Scene scene = scene_of("z = -1", Box::cube(2));
        scene.surfaces.push_back(scene_of(occluder.text, Box::cube(2)).surfaces[0]);
        Camera camera = default_camera(scene.clip);
        camera.eye = {1.0, -2.0, 6.0};
        const Framebuffer bright = picture_of(scene, camera, GetParam(), false);
        const Framebuffer dark = picture_of(scene, camera, GetParam(), true);
        const ViewFrame view(camera);
        const glm::dvec3 to_light = 16.0 * key_light(view);
        std::size_t hidden = 0;
        std::size_t lit = 0;
        for (int row = 0; row < side; ++row) {
            for (int col = 0; col < side; ++col) {
                const std::size_t at = dark.index(col, row);
                ASSERT_EQ(dark.depth[at], bright.depth[at]);
                ASSERT_EQ(dark.certificate[at], bright.certificate[at]);
                if (dark.surface[at] != 0) continue;
                const glm::dvec3 along = glm::normalize(
                    view.direction(pixel_centre(col, row), {.width = side, .height = side}));
                const glm::dvec3 on_plane = view.eye + static_cast<double>(dark.depth[at]) * along;
                const double clear =
                    clearance(on_plane, exit_of(on_plane, on_plane + to_light, scene.clip),
                              occluder.radius, occluder.cylinder);
                if (std::abs(clear) < 2e-3) continue;
                const bool darker = dark.color[at] != bright.color[at];
                ASSERT_EQ(darker, clear < 0) << occluder.text << " at " << col << ", " << row;
                ++(darker ? hidden : lit);
            }
        }
        EXPECT_GT(hidden, 10U) << occluder.text;
        EXPECT_GT(lit, 1000U) << occluder.text;
    }
}

TEST_P(Shadow, DoesNotFallFromASurfaceOnItsOwnLitSide) {
    for (const char* const text : {"x^2 + y^2 + z^2 = 1", "z = 0.1 x", "x^2 + y^2 = 1"}) {
        const Scene scene = scene_of(text, Box::cube(1.5));
        const Camera camera = default_camera(scene.clip);
        const Framebuffer bright = picture_of(scene, camera, GetParam(), false);
        const Framebuffer dark = picture_of(scene, camera, GetParam(), true);
        const ViewFrame view(camera);
        std::size_t darker = 0;
        for (std::size_t at = 0; at < dark.color.size(); ++at)
            darker += dark.color[at] != bright.color[at] ? 1U : 0U;
        // The inside of the cylinder lies in the shadow of its wall.
        if (std::string(text) == "x^2 + y^2 = 1") {
            EXPECT_GT(darker, 0U);
        } else {
            EXPECT_EQ(darker, 0U) << text;
        }
    }
}

TEST_P(Shadow, DoesNotFallFromASurfaceOnItselfAtAnyZoom) {
    const double third = 1.0 / std::sqrt(3.0);
    const std::vector<std::pair<std::string, glm::dvec3>> points{
        {"x^2 + y^2 + z^2 = 1", {third, -third, third}},
        {"z = 0.1 x", {0.3, 0.2, 0.03}},
        {"(1 - sqrt(x^2 + y^2))^2 + z^2 = 0.25", {0.9, -1.2, 0.0}}};
    for (const auto& [text, point] : points) {
        const Scene scene = scene_of(text, Box::cube(2));
        for (double zoom = 1e-3; zoom > 0.5e-9; zoom *= is_long_run() ? 1e-3 : 1e-6) {
            Camera camera = default_camera(scene.clip);
            camera.look_at = point;
            camera.eye = point + zoom * glm::normalize(glm::dvec3(0.3, -0.4, 0.5));
            const Framebuffer bright = picture_of(scene, camera, GetParam(), false);
            const Framebuffer dark = picture_of(scene, camera, GetParam(), true);
            EXPECT_TRUE(std::isfinite(bright.depth[bright.index(side / 2, side / 2)]));
            EXPECT_EQ(dark.color, bright.color) << text << " at " << zoom;
        }
    }
}

/// A solid about the origin whose upper half is cut away: below 0 inside.
struct CutSolid {
    std::string text;
    double inner;  ///< radius of the hollow; 0: it is a ball

    [[nodiscard]] double depth_at(const glm::dvec3& at) const {
        const double radius = glm::length(at);
        return std::max({radius - 1.0, inner - radius, at.z});
    }
    /// The normal of its surface, outwards.
    [[nodiscard]] glm::dvec3 normal_at(const glm::dvec3& at) const {
        if (at.z > -1e-5) return {0.0, 0.0, 1.0};
        return glm::length(at) > 0.5 * (1.0 + inner) ? glm::normalize(at) : -glm::normalize(at);
    }
    /// The least of the solid's function on the way to the light, but for its beginning.
    [[nodiscard]] double least_towards(const glm::dvec3& from, const glm::dvec3& to_light) const {
        double least = 1.0;
        for (int i = 10; i < 2000; ++i)
            least = std::min(least, depth_at(from + 1e-3 * i * to_light));
        return least;
    }
};

TEST_P(Shadow, FallsOfWhatIsLeftOfASolidCutOpen) {
    const std::vector<CutSolid> solids{{"x^2 + y^2 + z^2 = 1", 0.0},
                                       {"abs(sqrt(x^2 + y^2 + z^2) - 0.9) = 0.1", 0.8}};
    for (const CutSolid& solid : solids) {
        SCOPED_TRACE(solid.text);
        Scene scene = scene_of(solid.text, Box::cube(1.5));
        scene.region = Region{{}, {make_section({0, 0, 1}, 0.0)}};
        Camera camera = default_camera(Box::cube(1.2));
        camera.eye.z = 1.8 * camera.eye.z;
        const Framebuffer bright = picture_of(scene, camera, GetParam(), false);
        const Framebuffer dark = picture_of(scene, camera, GetParam(), true);
        const ViewFrame view(camera);
        const glm::dvec3 to_light = key_light(view);
        std::size_t hidden = 0;
        std::size_t lit = 0;
        for (int row = 0; row < side; ++row) {
            for (int col = 0; col < side; ++col) {
                const std::size_t at = dark.index(col, row);
                if (!std::isfinite(dark.depth[at])) continue;
                const PixelRay ray = pixel_ray(view, pixel_centre(col, row), {side, side});
                const glm::dvec3 place = ray.at(static_cast<double>(dark.depth[at]));
                if (glm::dot(solid.normal_at(place), to_light) < 0.1) continue;
                const double least = solid.least_towards(place, to_light);
                if (std::abs(least) < 5e-3) continue;
                const bool darker = dark.color[at] != bright.color[at];
                EXPECT_EQ(darker, least < 0) << "at " << col << ", " << row;
                ++(darker ? hidden : lit);
            }
        }
        EXPECT_GT(lit, 500U);
        EXPECT_EQ(hidden > 10, solid.inner > 0.0) << hidden;
    }
}

INSTANTIATE_TEST_SUITE_P(AllTracers, Shadow, testing::ValuesIn(names_of(proving_tracers_to_try())),
                         [](const auto& name) { return test_name(name.param); });

// A quotient is drawn as its numerator with the denominator's sign. Where that is not known the
// form is the numerator's, whose sign tells nothing of the quotient's before and behind.
TEST(Shadows, OfAQuotientAreThoseOfItsNumerator) {
    const std::string tracer(usual_tracer().name);
    const std::string numerator = "(sin(5 x) + sin(4 y) + sin(5 z) - 0.1 x)";
    const Box clip = Box::cube(1.5);
    const Camera camera = default_camera(clip);
    const Scene plain = scene_of(numerator + " = 0", clip);
    const Framebuffer bright = picture_of(plain, camera, tracer, false);
    const Framebuffer dark = picture_of(plain, camera, tracer, true);
    for (const char* const divisor :
         {"(0.31 x - 0.4 y - 0.56 z + 0.21)", "(x^2 + y^2 + z^2 - 0.7)", "sin(9 x + 7 y - 8 z)"}) {
        Scene quotient = plain;
        const std::string text = numerator + "/" + divisor + " = 0";
        quotient.surfaces[0].kernel = interpret(traceable(parse(text).value()));
        const Framebuffer found = picture_of(quotient, camera, tracer, false);
        const Framebuffer shaded = picture_of(quotient, camera, tracer, true);
        int same = 0;
        int different = 0;
        for (std::size_t i = 0; i < dark.color.size(); ++i) {
            if (std::abs(found.depth[i] - bright.depth[i]) > 1e-4F) continue;
            const bool is_dark = dark.color[i] != bright.color[i];
            const bool is_found_dark = shaded.color[i] != found.color[i];
            ++(is_dark == is_found_dark ? same : different);
        }
        EXPECT_GT(same, 8000);
        EXPECT_LE(different, 2) << text;  // where the light grazes
    }
}

}  // namespace
}  // namespace zeroset::test::shadow_test
