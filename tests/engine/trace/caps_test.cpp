#include "engine/trace/caps.hpp"

#include "engine/light/shade.hpp"
#include "engine/num/interval.hpp"
#include "engine/render/render.hpp"
#include "engine/rewrite/surface_functions.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Sections and their caps: where they are, what is proved of them, how they look.

namespace zeroset::test::caps_test {
namespace {

/// Less than 0 inside.
using Solid = std::function<double(const glm::dvec3&)>;

double ball(const glm::dvec3& p) { return glm::length(p) - 1.0; }
double shell(const glm::dvec3& p) { return std::abs(glm::length(p) - 1.0) - 0.01; }

constexpr const char* ball_text = "x^2 + y^2 + z^2 = 1";
constexpr const char* shell_text = "abs(sqrt(x^2 + y^2 + z^2) - 1) = 0.01";

class CapTest : public ::testing::TestWithParam<std::string> {
protected:
    void draw(const std::string& text) {
        scene_ = scene_of(text, Box::cube(2));
        scene_.region = region_;
        render();
    }
    void render() { render_frame(scene_, camera_, settings_at(GetParam(), 18), frame_); }
    [[nodiscard]] Ray ray(int col, int row) const {
        return {camera_, Box::cube(2), col, row, frame_, region_};
    }
    /// Calls `check(ray, pixel)` for all pixels.
    void for_pixels(const std::function<void(const Ray&, std::size_t)>& check) const {
        for (int row = 0; row < frame_.height; ++row) {
            for (int col = 0; col < frame_.width; ++col) {
                SCOPED_TRACE("pixel " + std::to_string(col) + "," + std::to_string(row));
                check(ray(col, row), frame_.index(col, row));
            }
        }
    }
    /// The solid is cut open: its caps are shown where they are, and certified; nothing else is.
    /// How many of them.
    [[nodiscard]] std::size_t check_caps(const Section& section, const Solid& solid) const {
        std::size_t caps = 0;
        for_pixels([&](const Ray& ray, std::size_t i) {
            const double at = ray.place_of(section);
            const auto depth = static_cast<double>(frame_.depth[i]);
            const bool enters = glm::dot(section.normal, ray.direction) < 0 && ray.t_in == at &&
                                ray.t_in < ray.t_out - 1e-6;
            const double inside = solid(ray.at(at));
            if (enters && inside < -1e-6) {
                ++caps;
                EXPECT_NEAR(depth, at, 1e-6);
                EXPECT_EQ(frame_.certificate[i], Certificate::Certified);
            } else if (enters && inside > 1e-3) {
                EXPECT_GT(depth, at + 1e-4);
            }
        });
        return caps;
    }

    Region region_{{}, {make_section({1, 0, 0}, 0.3)}};
    Camera camera_ = default_camera(Box::cube(1.2));
    Framebuffer frame_{97, 83};
    Scene scene_;
};

TEST_P(CapTest, FillsABallThatIsCutOpen) {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        camera_.projection = projection;
        draw(ball_text);
        EXPECT_GT(check_caps(region_.sections.front(), ball), 300U);
    }
}

TEST_P(CapTest, FillsItInAnyDirection) {
    for (const glm::dvec3& normal : {glm::dvec3(0, -1, 0), {0, 0, 2}, {1, -2, 0.5}, {3, -1, 2}}) {
        region_.sections = {make_section(normal, 0.2)};
        draw(ball_text);
        EXPECT_GT(check_caps(region_.sections.front(), ball), 200U) << normal.x;
    }
}

TEST_P(CapTest, ShowsTheThicknessOfAShell) {
    frame_ = Framebuffer(229, 199);
    draw(shell_text);
    EXPECT_GT(check_caps(region_.sections.front(), shell), 60U);
}

TEST_P(CapTest, FillsTheSameHoweverTheEquationIsWritten) {
    draw(ball_text);
    const Framebuffer first = frame_;
    draw("1 = x^2 + y^2 + z^2");
    EXPECT_EQ(frame_.depth, first.depth);
    EXPECT_EQ(solid_sign(scene_, 0), 1);
    draw(ball_text);
    EXPECT_EQ(solid_sign(scene_, 0), -1);
}

/// Whatever the sign of f is, and certified where f is continuous.
TEST_P(CapTest, ShowsValuesWhereverTheyAreDefined) {
    region_.sections.front().values = true;
    region_.sections.front().cap = false;
    draw(ball_text);
    const Section& section = region_.sections.front();
    std::size_t seen = 0;
    for_pixels([&](const Ray& ray, std::size_t i) {
        const double at = ray.place_of(section);
        const bool enters = glm::dot(section.normal, ray.direction) < 0 && ray.t_in == at &&
                            ray.t_in < ray.t_out - 1e-6;
        if (!enters) return;
        ++seen;
        EXPECT_NEAR(static_cast<double>(frame_.depth[i]), at, 1e-6);
        EXPECT_EQ(frame_.certificate[i], Certificate::Certified);
    });
    EXPECT_GT(seen, 2000U);
}

TEST_P(CapTest, ShowsNoValuesWhereThereAreNone) {
    region_.sections.front().values = true;
    region_.sections.front().cap = false;
    draw("sqrt(z) = 0.3");
    const Section& section = region_.sections.front();
    std::size_t seen = 0;
    for_pixels([&](const Ray& ray, std::size_t i) {
        const double at = ray.place_of(section);
        const bool enters = glm::dot(section.normal, ray.direction) < 0 && ray.t_in == at &&
                            ray.t_in < ray.t_out - 1e-6;
        const double z = ray.at(at).z;
        if (!enters || std::abs(z) < 1e-3) return;
        const bool on_section = std::abs(static_cast<double>(frame_.depth[i]) - at) < 1e-6;
        EXPECT_EQ(on_section, z > 0) << z;
        ++seen;
    });
    EXPECT_GT(seen, 2000U);
}

TEST_P(CapTest, ShowsValuesInCapsAlone) {
    draw(ball_text);
    const Framebuffer plain = frame_;
    region_.sections.front().values = true;
    draw(ball_text);
    EXPECT_EQ(frame_.depth, plain.depth);
    EXPECT_EQ(frame_.certificate, plain.certificate);
    EXPECT_NE(frame_.color, plain.color);
}

/// Restrictions that leave nothing of f at the faces of the box say nothing of its side.
TEST_P(CapTest, FillsTheSameHoweverTheSurfaceIsRestricted) {
    for (const char* const text : {"1 - x^2 - y^2 - z^2", "x^2 + y^2 + z^2 - 1"}) {
        const std::string ball = text;
        draw(ball);
        const Framebuffer whole = frame_;
        const int sign = solid_sign(scene_, 0);
        for (const char* const restriction :
             {"x^2 + y^2 + z^2 < 3", "abs(x) < 1.5, abs(y) < 1.5, abs(z) < 1.5", "z > -1.5"}) {
            SCOPED_TRACE(ball + ", " + restriction);
            const auto read = read_program(ball + " = 0, " + restriction);
            ASSERT_TRUE(read);
            const Expr& surface = read->surfaces.front();
            scene_.surfaces[0].kernel = interpret(surface);
            const auto plain = unrestricted(surface);
            ASSERT_TRUE(plain);
            scene_.surfaces[0].solid = {SolidSide::Automatic, interpret(*plain).in_float.value};
            render();
            EXPECT_EQ(solid_sign(scene_, 0), sign);
            EXPECT_EQ(frame_.certificate, whole.certificate);
        }
    }
}

TEST_P(CapTest, FillsTheSideThatIsChosen) {
    draw(ball_text);
    const Framebuffer automatic = frame_;
    scene_.surfaces[0].solid = {SolidSide::Below, {}};
    render();
    EXPECT_EQ(frame_.depth, automatic.depth);
    scene_.surfaces[0].solid = {SolidSide::Above, {}};
    render();
    EXPECT_GT(check_caps(region_.sections.front(), [](const glm::dvec3& p) { return -ball(p); }),
              300U);
}

/// Curvatures are of the skin: a cap shows the surface's colour, in its own light.
TEST_P(CapTest, IsPlainWhereColoursTellOfTheSkin) {
    draw(ball_text);
    const Framebuffer plain = frame_;
    for (const ColorBy by : {ColorBy::MeanCurvature, ColorBy::GaussianCurvature, ColorBy::Gradient,
                             ColorBy::Expression, ColorBy::Height}) {
        scene_.coloring = {.by = by, .range = ValueRange{-2.0, 2.0}};
        scene_.coloring.values = {interpret_points(*parse("x + 2y"))};
        render();
        std::size_t caps = 0;
        std::size_t same = 0;
        for_pixels([&](const Ray& ray, std::size_t i) {
            const double at = ray.place_of(region_.sections.front());
            if (ray.t_in != at || ball(ray.at(at)) > -1e-2) return;
            ++caps;
            if (frame_.color[i] == plain.color[i]) ++same;
        });
        EXPECT_GT(caps, 200U);
        EXPECT_EQ(same > caps / 10, is_of_skin(by));
        if (is_of_skin(by)) {
            EXPECT_EQ(same, caps);
        }
    }
}

TEST_P(CapTest, StaysOpenWhereNoCapIsWanted) {
    region_.sections.front().cap = false;
    draw(ball_text);
    std::size_t inner = 0;
    for_pixels([&](const Ray& ray, std::size_t i) {
        const double at = ray.place_of(region_.sections.front());
        if (ray.t_in != at || ball(ray.at(at)) > -1e-3) return;
        ++inner;
        const glm::dvec3 hit = ray.at(static_cast<double>(frame_.depth[i]));
        EXPECT_NEAR(glm::length(hit), 1.0, 1e-4);
        EXPECT_LT(hit.x, 0.3);
    });
    EXPECT_GT(inner, 300U);
}

TEST_P(CapTest, CapsNothingAtTheFacesOfTheBoxOrTheBall) {
    region_.sections = {make_section({1, 0, 0}, 2.0)};
    draw("x^2 + y^2 + z^2 = 100");
    EXPECT_EQ(count_certificates(frame_).certified, 0U);
    EXPECT_EQ(count_certificates(frame_).undecided, 0U);
    region_ = {Ball{{0, 0, 0}, 1.5}, {}};
    draw("x^2 + y^2 + z^2 = 4");
    EXPECT_EQ(count_certificates(frame_).miss, frame_.depth.size());
}

/// Where both are, the first one; else the one that is there.
TEST_P(CapTest, ShowsTheFirstOfSolidsThatOverlap) {
    scene_ = scene_of(ball_text, Box::cube(2));
    scene_.surfaces.push_back(scene_of("x^2 + (y+0.7)^2 + z^2 = 1", Box::cube(2)).surfaces[0]);
    scene_.region = region_;
    render();
    std::array<std::size_t, 2> shown{};
    for_pixels([&](const Ray& ray, std::size_t i) {
        const double at = ray.place_of(region_.sections.front());
        const double first = ball(ray.at(at));
        const double second = ball(ray.at(at) + glm::dvec3(0, 0.7, 0));
        if (ray.t_in != at || std::abs(first) < 1e-3 || std::abs(second) < 1e-3) return;
        if (first > 0 && second > 0) return;
        const std::uint8_t surface = first < 0 ? 0 : 1;
        ++shown.at(surface);
        EXPECT_EQ(frame_.surface[i], surface);
        EXPECT_NEAR(static_cast<double>(frame_.depth[i]), at, 1e-6);
    });
    EXPECT_GT(shown[0], 300U);
    EXPECT_GT(shown[1], 100U);
}

/// Two sections: each caps what the other keeps.
TEST_P(CapTest, FillsAWedge) {
    region_.sections = {make_section({1, 0, 0}, 0.2), make_section({0, -1, 0}, 0.1)};
    draw(ball_text);
    EXPECT_GT(check_caps(region_.sections[0], ball), 100U);
    EXPECT_GT(check_caps(region_.sections[1], ball), 100U);
}

TEST_P(CapTest, DecidesNothingWhereTheSignIsNotKnown) {
    // f is 0 on all of the section.
    draw("(x - 0.3)*(x^2 + y^2 + z^2 + 1)");
    for_pixels([&](const Ray& ray, std::size_t i) {
        if (ray.t_in != ray.place_of(region_.sections.front()) || ray.t_out < ray.t_in + 1e-6)
            return;
        EXPECT_EQ(frame_.certificate[i], Certificate::Undecided);
    });
}

/// The picture's numbers are roots of the light; that of a cap is the same but for the tone.
TEST_P(CapTest, LooksFlatAndHatchedInTheSurfacesColour) {
    draw(ball_text);
    std::size_t lines = 0;
    std::size_t between = 0;
    double light = 0.0;
    for_pixels([&](const Ray& ray, std::size_t i) {
        const double at = ray.place_of(region_.sections.front());
        if (ray.t_in != at || ball(ray.at(at)) > -1e-2) return;
        const float tone =
            cap_tone(ViewFrame(camera_), frame_.height, ray.at(at), glm::dvec3(1, 0, 0));
        (tone < 0.8F ? lines : between) += 1;
        EXPECT_LE(tone, 0.9F);
        EXPECT_GE(tone, 0.7F);
        const double blue = static_cast<double>(frame_.color[i] >> 16U & 0xFFU);
        const double untoned = blue * blue / static_cast<double>(tone);
        if (light == 0.0) light = untoned;
        EXPECT_NEAR(untoned, light, 0.03 * light);
    });
    EXPECT_GT(light, 5000.0);
    EXPECT_GT(lines, 30U);
    EXPECT_GT(between, lines);
}

INSTANTIATE_TEST_SUITE_P(Tracers, CapTest, ::testing::ValuesIn(tracer_names()),
                         [](const auto& tracer) { return test_name(tracer.param); });

}  // namespace
}  // namespace zeroset::test::caps_test
