#include "engine/trace/jumps.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/render/render.hpp"
#include "engine/view/pixel_ray.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Places where f changes its sign in a jump (Scene::jumps).

namespace zeroset::test::jumps_test {
namespace {

constexpr int size = 96;

struct Picture {
    Framebuffer frame{size, size};
    ViewFrame view;
};

Picture drawn(const std::string& text, bool jumps) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr) << text;
    Scene scene;
    scene.surfaces.push_back({.kernel = interpret(*expr)});
    scene.clip = Box::cube(1.5);
    scene.uniforms.set(0, 0.0);
    scene.jumps = jumps;
    const Camera camera = default_camera(scene.clip);
    Picture picture{Framebuffer(size, size), ViewFrame(camera)};
    render_frame(scene, camera, TraceSettings(), picture.frame);
    return picture;
}

glm::dvec3 direction_of(const Picture& picture, std::size_t pixel) {
    const auto col = static_cast<double>(pixel % size) + 0.5;
    const auto row = static_cast<double>(pixel / size) + 0.5;
    return pixel_ray(picture.view, {.col = col, .row = row}, {.width = size, .height = size})
        .direction;
}

/// The distance from the eye to the ball of radius 1 at the origin; nothing where the ray passes
/// it.
std::optional<double> distance_to_ball(const glm::dvec3& eye, const glm::dvec3& direction) {
    const double along = glm::dot(eye, direction);
    const double inside = along * along - glm::dot(eye, eye) + 1.0;
    if (inside < 0.0) return std::nullopt;
    return -along - std::sqrt(inside);
}

TEST(Jumps, AreDrawnWhereTheyAreAskedFor) {
    const std::string text = "if(x^2 + y^2 + z^2 < 1, -1, z + 2)";
    EXPECT_EQ(count_certificates(drawn(text, false).frame).miss, std::size_t{size * size});
    const Picture picture = drawn(text, true);
    std::size_t jumps = 0;
    for (std::size_t i = 0; i < picture.frame.depth.size(); ++i) {
        const auto expected = distance_to_ball(picture.view.eye, direction_of(picture, i));
        ASSERT_EQ(picture.frame.certificate[i], expected ? Certificate::Jump : Certificate::Miss)
            << i;
        if (!expected) continue;
        ++jumps;
        EXPECT_NEAR(static_cast<double>(picture.frame.depth[i]), *expected, 1e-4) << i;
    }
    EXPECT_GT(jumps, 500U);
    EXPECT_EQ(count_certificates(picture.frame).jumps, jumps);
}

TEST(Jumps, AreThoseOfEachStep) {
    for (const char* const text :
         {"floor(x + y/2 + z/3) + 0.5", "sign(x - z/2)", "ceil(x - y/4) - 0.5",
          "round(x + y^2/4) + 0.25", "mod(x + z/2, 2.5) - 1", "atan2(x, y - 2) + 0.1"}) {
        EXPECT_GT(count_certificates(drawn(text, true).frame).jumps, 500U) << text;
    }
}

TEST(Jumps, ThatKeepTheSignAreNotDrawn) {
    for (const char* const text : {"floor(x) + 5", "if(x < y, 1, 2)", "abs(sign(x - y)) + 1"}) {
        EXPECT_EQ(count_certificates(drawn(text, true).frame).miss, std::size_t{size * size})
            << text;
    }
}

TEST(Jumps, PolesAreNone) {
    for (const char* const text : {"1/x + y", "tan(3x) + y", "1/(x^2 + y^2 - 0.5)"})
        EXPECT_EQ(count_certificates(drawn(text, true).frame).jumps, 0U) << text;
}

TEST(Jumps, RootsStayWhatTheyAre) {
    const std::string text = "if(x < 0, z - 0.3, z^2 + 0.1) (x^2 + y^2 + z^2 - 1)";
    const Picture plain = drawn(text, false);
    const Picture with_jumps = drawn(text, true);
    int hidden = 0;
    for (std::size_t i = 0; i < plain.frame.depth.size(); ++i) {
        if (with_jumps.frame.certificate[i] == Certificate::Jump) {
            hidden += plain.frame.certificate[i] == Certificate::Certified ? 1 : 0;
            EXPECT_LE(with_jumps.frame.depth[i], plain.frame.depth[i]) << "nothing is before it";
        } else {
            EXPECT_EQ(with_jumps.frame.certificate[i], plain.frame.certificate[i]) << i;
            EXPECT_EQ(with_jumps.frame.depth[i], plain.frame.depth[i]) << i;
        }
    }
    EXPECT_GT(hidden, 0);
}

TEST(Jumps, ToASolidOfZerosAreCertified) {
    // The cone is as near to ends of brackets as numbers tell.
    for (const char* const text :
         {"if(atan2(z, sqrt(x^2 + y^2)) < 0.89, -1, 0)",
          "if(sqrt(x^2 + y^2) < 0.7, cos(x), 1)*if(sqrt(x^2 + y^2) < 0.7, 1, 0)"}) {
        const CertificateCounts counts = count_certificates(drawn(text, false).frame);
        EXPECT_GT(counts.certified, 500U) << text;
        EXPECT_EQ(counts.undecided, 0U) << text;
    }
}

TEST(JumpNormals, AreThoseOfTheSurfaceAcross) {
    const auto f = [](const std::vector<glm::dvec3>& points) {
        std::vector<double> values;
        for (const glm::dvec3& p : points)
            values.push_back(glm::dot(p, p) < 1.0 ? -1.0 : 5.0);
        return values;
    };
    const glm::dvec3 eye(4.0, 1.0, 2.0);
    std::vector<JumpPlace> places;
    for (const glm::dvec3& at : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.6, 0.0, 0.8)})
        places.push_back({at, glm::normalize(at - eye), 1e-3, Trend::Falling});
    const std::vector<glm::dvec3> normals = jump_normals(places, f);
    ASSERT_EQ(normals.size(), places.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
        EXPECT_LT(glm::length(normals[i] - places[i].position), 2e-3) << i;
}

TEST(JumpNormals, FaceTheEyeWhereNothingIsAcross) {
    const auto f = [](const std::vector<glm::dvec3>& points) {
        return std::vector<double>(points.size(), 1.0);
    };
    const std::vector<JumpPlace> places{
        {glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0), 0.01, Trend::Falling},
        {glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0), 0.01, Trend::Rising}};
    const std::vector<glm::dvec3> normals = jump_normals(places, f);
    EXPECT_EQ(normals[0], glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_EQ(normals[1], glm::dvec3(0.0, 0.0, -1.0));
}

}  // namespace
}  // namespace zeroset::test::jumps_test
