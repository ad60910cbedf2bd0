#include "engine/rays/first_roots.hpp"

#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/traceable.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

// First roots on single rays, by closed forms.

namespace zeroset::test::first_roots_test {
namespace {

/// A scene of texts, one surface each, as frames.
struct Frames {
    Scene scene;
    std::vector<TraceFrame> frames;

    Frames(const std::vector<std::string>& texts, const Box& clip)
        : scene(scene_of(texts[0], clip)) {
        for (std::size_t i = 1; i < texts.size(); ++i)
            scene.surfaces.push_back(scene_of(texts[i], clip).surfaces[0]);
        const ViewFrame view(default_camera(clip));
        for (const Surface& surface : scene.surfaces)
            frames.push_back(trace_frame(scene, surface, view, {.width = 64, .height = 64}, {}));
    }
    [[nodiscard]] std::vector<RayHit> hits(const std::vector<SceneRay>& rays) const {
        const UpwardRounding upward;
        std::vector<RayHit> found(rays.size());
        Counters counters;
        find_first_hits(frames, rays, found, counters);
        return found;
    }
};

glm::dvec3 random_direction(RandomNumbers& random) {
    for (;;) {
        const glm::dvec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (glm::length(v) > 0.1 && glm::length(v) < 1.0) return v;
    }
}

TEST(FirstRoots, FromInsideASphereAreWhereItsClosedFormSays) {
    const Frames of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    RandomNumbers random(1);
    std::vector<SceneRay> rays;
    for (int i = 0; i < 200; ++i)
        rays.push_back({.origin = 0.9 * random_direction(random),
                        .direction = UnitVector(random_direction(random))});
    const std::vector<RayHit> hits = of.hits(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double b = glm::dot(rays[i].origin, glm::dvec3(rays[i].direction));
        const double c = glm::dot(rays[i].origin, rays[i].origin) - 1.0;
        EXPECT_NEAR(hits[i].t, -b + std::sqrt(b * b - c), 1e-12);
        EXPECT_EQ(hits[i].certificate, Certificate::Certified);
        const glm::dvec3 normal = glm::normalize(hits[i].gradient);
        EXPECT_NEAR(glm::dot(normal, rays[i].at(hits[i].t)), 1.0, 1e-9);
    }
}

/// Balls, and their union as a text.
struct Balls {
    std::vector<Ball> balls;
    std::string text;

    explicit Balls(std::size_t count) {
        RandomNumbers random(7);
        const auto number = [](double value) { return "(" + std::to_string(value) + ")"; };
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 c(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5),
                               random.uniform(-1.5, 1.5));
            const double r = random.uniform(0.1, 0.5);
            // The numbers as the text has them, to its digits.
            const auto kept = [](double value) { return std::stod(std::to_string(value)); };
            balls.push_back({.centre = {kept(c.x), kept(c.y), kept(c.z)}, .radius = kept(r)});
            const std::string ball = "(x-" + number(c.x) + ")^2+(y-" + number(c.y) + ")^2+(z-" +
                                     number(c.z) + ")^2-" + number(r) + "^2";
            text = text.empty() ? ball : "min(" + text + ", " + ball + ")";
        }
    }
    /// Above 0 outside of all balls, which is about how far they are.
    [[nodiscard]] double room(const glm::dvec3& at) const {
        double least = 1e9;
        for (const Ball& ball : balls)
            least = std::min(least, glm::distance(at, ball.centre) - ball.radius);
        return least;
    }
    /// Where a ray from outside first meets a ball, behind `after`.
    [[nodiscard]] double first(const SceneRay& ray, double after) const {
        double nearest = infinity;
        for (const Ball& ball : balls) {
            const glm::dvec3 from = ray.origin - ball.centre;
            const double b = glm::dot(from, glm::dvec3(ray.direction));
            const double square = b * b - glm::dot(from, from) + ball.radius * ball.radius;
            if (square < 0.0) continue;
            const double t = -b - std::sqrt(square);
            if (t > after) nearest = std::min(nearest, t);
        }
        return nearest;
    }
};

TEST(FirstRoots, OfAUnionAreTheFirstOnesOfItsParts) {
    const Balls balls(24);
    const Frames of({balls.text + " = 0"}, Box::cube(2));
    RandomNumbers random(8);
    std::vector<SceneRay> rays;
    std::vector<double> after;
    while (rays.size() < 600) {
        SceneRay ray{.origin = 1.9 * random_direction(random),
                     .direction = UnitVector(random_direction(random))};
        if (balls.room(ray.origin) < 0.01) continue;
        rays.push_back(ray);
        after.push_back(0.0);
        // On from where it meets a ball, mirrored there.
        const double t = balls.first(ray, 0.0);
        if (!(t < 3.0)) continue;
        const glm::dvec3 at = ray.at(t);
        glm::dvec3 normal(0.0);
        for (const Ball& ball : balls.balls) {
            if (std::abs(glm::distance(at, ball.centre) - ball.radius) < 1e-9)
                normal = glm::normalize(at - ball.centre);
        }
        rays.push_back({.origin = at,
                        .direction = UnitVector(glm::reflect(glm::dvec3(ray.direction), normal)),
                        .own = 0,
                        .own_error = 1e-9,
                        .own_sign = 1});
        after.push_back(1e-6);
    }
    const std::vector<RayHit> hits = of.hits(rays);
    std::size_t met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double expected = balls.first(rays[i], after[i]);
        const bool inside = glm::all(glm::lessThan(glm::abs(rays[i].at(expected)), glm::dvec3(2)));
        if (!std::isfinite(expected) || !inside) {
            EXPECT_FALSE(hits[i].is_hit()) << i;
            continue;
        }
        ++met;
        EXPECT_NEAR(hits[i].t, expected, 1e-9) << i;
        EXPECT_EQ(hits[i].certificate, Certificate::Certified) << i;
    }
    EXPECT_GT(met, 100U);
}

TEST(FirstRoots, OfAUnionFromInsideAreWhereTheLastPartIsLeft) {
    const Frames of({"min(x^2 + y^2 + z^2 - 1, (x - 1)^2 + y^2 + z^2 - 1) = 0"}, Box::cube(3));
    const std::vector<RayHit> hits =
        of.hits({{.origin = {0, 0, 0}, .direction = UnitVector(glm::dvec3(1, 0, 0))},
                 {.origin = {-1, 0, 0},
                  .direction = UnitVector(glm::dvec3(1, 0, 0)),
                  .own = 0,
                  .own_error = 1e-9,
                  .own_sign = -1}});
    EXPECT_NEAR(hits[0].t, 2.0, 1e-12);
    EXPECT_NEAR(hits[1].t, 3.0, 1e-12);
}

TEST(FirstRoots, OfARayFromTheSurfaceLeaveOutWhereItBegins) {
    const Frames of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    RandomNumbers random(2);
    std::vector<SceneRay> rays;
    for (int i = 0; i < 400; ++i) {
        const UnitVector at(random_direction(random));
        const UnitVector along(random_direction(random));
        const double cosine = std::abs(glm::dot(glm::dvec3(at), glm::dvec3(along)));
        if (cosine < 0.01) continue;
        // The origin is off the sphere by what rounding makes of a depth.
        rays.push_back({.origin = (1.0 + random.uniform(-1e-7, 1e-7)) * glm::dvec3(at),
                        .direction = along,
                        .own = 0,
                        .own_error = 2e-7 / cosine});
    }
    const std::vector<RayHit> hits = of.hits(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double inwards = -glm::dot(rays[i].origin, glm::dvec3(rays[i].direction));
        EXPECT_EQ(hits[i].is_hit(), inwards > 0.0) << i;
        if (inwards > 0.0) {
            EXPECT_NEAR(hits[i].t, 2.0 * inwards, 1e-5) << i;
        }
        EXPECT_NE(hits[i].certificate, Certificate::Undecided) << i;
    }
}

TEST(FirstRoots, OfSeveralSurfacesAreTheNearest) {
    const Frames of({"x = 1", "x = 0.5", "x^2 + y^2 + z^2 = 0.01"}, Box::cube(2));
    const std::vector<RayHit> hits =
        of.hits({{.origin = {-1, 0, 0}, .direction = UnitVector({1, 0, 0})},
                 {.origin = {-1, 1, 0}, .direction = UnitVector({1, 0, 0})},
                 {.origin = {1.5, 1, 0}, .direction = UnitVector({-1, 0, 0})},
                 {.origin = {1.5, 1, 0}, .direction = UnitVector({0, 1, 0})}});
    EXPECT_EQ(hits[0].surface, 2);
    EXPECT_NEAR(hits[0].t, 0.9, 1e-12);
    EXPECT_EQ(hits[1].surface, 1);
    EXPECT_EQ(hits[2].surface, 0);
    EXPECT_FALSE(hits[3].is_hit());
    EXPECT_EQ(hits[3].certificate, Certificate::Miss);
}

TEST(FirstRoots, DoNotLeaveOutAThinSheetOrOneBehindAPole) {
    // A shell of 1e-4, and a surface behind one at which f goes to infinity.
    const Frames of({"max(x^2 - 1e-8, -y)", "1/(x - 0.5) = 4"}, Box::cube(2));
    const std::vector<RayHit> hits =
        of.hits({{.origin = {-1, 1, 0}, .direction = UnitVector({1, 0, 0})},
                 {.origin = {0.1, 1, 0}, .direction = UnitVector({1, 0, 0})}});
    EXPECT_NEAR(hits[0].t, 1.0 - 1e-4, 1e-9);
    EXPECT_EQ(hits[0].certificate, Certificate::Certified);
    EXPECT_EQ(hits[1].surface, 1);
    EXPECT_NEAR(hits[1].t, 0.65, 1e-9);
}

// A quotient is drawn as its numerator with the denominator's sign. Where that is not known the
// form is the numerator's, whose sign tells nothing of the quotient's before and behind.
TEST(FirstRoots, OfAQuotientAreThoseOfItsNumerator) {
    const std::string numerator = "(1.96 y - 0.57 y x^2 + 0.56 x - 3.56 (0.14 x - 0.4 y - 0.56 z))";
    const std::string divisor = "(0.14 x - 0.4 y - 0.56 z + 0.21 y^2)";
    const Box clip = Box::cube(1.5);
    const Frames plain({numerator + " = 0"}, clip);
    Frames quotient({numerator + "/" + divisor + " = 0"}, clip);
    quotient.scene.surfaces[0].kernel =
        interpret(traceable(parse(numerator + "/" + divisor + " = 0").value()));
    RandomNumbers random(5);
    std::vector<SceneRay> rays;
    for (int i = 0; i < 100'000; ++i) {
        const glm::dvec3 origin = 0.9 * random_direction(random);
        rays.push_back({.origin = origin, .direction = UnitVector(random_direction(random))});
    }
    const std::vector<RayHit> expected = plain.hits(rays);
    const std::vector<RayHit> found = quotient.hits(rays);
    int known = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (expected[i].certificate == Certificate::Undecided) continue;
        if (found[i].certificate == Certificate::Undecided) continue;
        ++known;
        ASSERT_EQ(found[i].is_hit(), expected[i].is_hit()) << i << ": " << expected[i].t;
        if (found[i].is_hit()) {
            ASSERT_NEAR(found[i].t, expected[i].t, 1e-9) << i;
        }
    }
    EXPECT_GT(known, 99'000);
}

TEST(FirstRoots, AreOnlyInTheRegion) {
    Frames of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    of.scene.region.sections.push_back(make_section({1, 0, 0}, 0.5));
    const SceneRay right{.origin = {0, 0, 0}, .direction = UnitVector({1, 0, 0})};
    const SceneRay left{.origin = {0, 0, 0}, .direction = UnitVector({-1, 0, 0})};
    const std::vector<RayHit> hits = of.hits({right, left});
    EXPECT_FALSE(hits[0].is_hit());
    EXPECT_NEAR(clipped(right, of.scene).to, 0.5, 1e-15);
    EXPECT_NEAR(hits[1].t, 1.0, 1e-12);
}

}  // namespace
}  // namespace zeroset::test::first_roots_test
