#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/render/render.hpp"
#include "engine/render/tracers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

// Several surfaces in one scene: on each pixel the nearest one, and what is certain of it.

namespace zeroset::test::several_surfaces_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int image_size = 60;

/// Looks along +y; x is to the right, z upwards.
const Camera along_y{{0.03, -6, 0.02}, {0.03, 0, 0.02}, {0, 0, 1}, 0.6};

Scene scene_of(std::initializer_list<std::string> texts) {
    Scene scene{{}, Box::cube(2), {}};
    for (const std::string& text : texts) {
        const auto expr = parse(text);
        if (expr) {
            scene.surfaces.push_back({.kernel = interpret(*expr)});
        } else {
            ADD_FAILURE() << text << ": " << expr.error().reason;
        }
    }
    scene.uniforms.set(0, 0.0);
    return scene;
}

Framebuffer picture_of(const Scene& scene, const Camera& camera, StopCriterion stop = {{}, 12.0},
                       int threads = 2) {
    TraceSettings settings;
    settings.stop = stop;
    settings.threads = threads;
    Framebuffer frame(image_size, image_size);
    render_frame(scene, camera, settings, frame);
    return frame;
}

Framebuffer picture_of(std::initializer_list<std::string> texts) {
    return picture_of(scene_of(texts), along_y);
}

glm::dvec3 direction_of(const Camera& camera, std::size_t pixel) {
    const auto col = static_cast<int>(pixel % image_size);
    const auto row = static_cast<int>(pixel / image_size);
    return glm::normalize(ViewFrame(camera).direction(pixel_centre(col, row),
                                                      {.width = image_size, .height = image_size}));
}

struct Sphere {
    std::string text;
    glm::dvec3 centre;
    double radius;

    /// Distance from the eye to the first hit; no value too near to the rim to be sure of one.
    [[nodiscard]] std::optional<double> first_hit(const glm::dvec3& eye,
                                                  const glm::dvec3& direction) const {
        const double along = glm::dot(centre - eye, direction);
        const double off = glm::distance(centre, eye + along * direction);
        if (std::abs(off - radius) < 0.02) return std::nullopt;
        return off > radius ? infinity : along - std::sqrt(radius * radius - off * off);
    }
};

const std::vector<Sphere> spheres{
    {"(x+0.4)^2 + y^2 + z^2 = 1", {-0.4, 0, 0}, 1.0},
    {"(x-0.5)^2 + (y+0.3)^2 + (z-0.1)^2 = 0.64", {0.5, -0.3, 0.1}, 0.8},
    {"x^2 + (y-0.8)^2 + (z-0.9)^2 = 0.49", {0, 0.8, 0.9}, 0.7}};

Scene scene_of_spheres(const std::vector<std::size_t>& order) {
    Scene scene = scene_of({});
    for (const std::size_t i : order)
        scene.surfaces.push_back(scene_of({spheres[i].text}).surfaces.front());
    return scene;
}

void check_against_spheres(const Framebuffer& frame, const Camera& camera,
                           const std::vector<std::size_t>& order, double margin) {
    std::vector<std::size_t> seen(order.size());
    for (std::size_t pixel = 0; pixel < frame.depth.size(); ++pixel) {
        SCOPED_TRACE(pixel);
        std::vector<double> depths;
        for (const std::size_t i : order) {
            const auto depth = spheres[i].first_hit(camera.eye, direction_of(camera, pixel));
            if (depth) depths.push_back(*depth);
        }
        if (depths.size() < order.size()) continue;
        const auto nearest = std::ranges::min_element(depths);
        const auto depth = static_cast<double>(frame.depth[pixel]);
        if (*nearest == infinity) {
            EXPECT_EQ(depth, infinity);
            EXPECT_EQ(frame.surface[pixel], no_surface);
            continue;
        }
        EXPECT_NEAR(depth, *nearest, margin);
        const auto close = [&](double other) { return other < *nearest + 2 * margin; };
        if (std::ranges::count_if(depths, close) > 1) continue;  // where spheres cut each other
        const auto index = static_cast<std::size_t>(nearest - depths.begin());
        EXPECT_EQ(frame.surface[pixel], index);
        ++seen[index];
    }
    EXPECT_GT(std::ranges::min(seen), 30U) << "a sphere is hardly looked at";
}

const std::vector<std::vector<std::size_t>> orders{{0, 1, 2}, {2, 1, 0}, {1, 2, 0}};

TEST(SeveralSurfaces, TheNearestSphereWins) {
    const Camera oblique = default_camera(Box::cube(2));
    for (const Camera& camera : {along_y, oblique}) {
        for (const auto& order :
             {std::vector<std::size_t>{0, 1}, orders[0], orders[1], orders[2]}) {
            const Framebuffer frame = picture_of(scene_of_spheres(order), camera);
            check_against_spheres(frame, camera, order, 8.0 * 4.0 * std::exp2(-12));
        }
    }
}

TEST(SeveralSurfaces, TheirOrderDoesNotMatterForDepths) {
    const Camera oblique = default_camera(Box::cube(2));
    for (const StopCriterion stop :
         {StopCriterion{StopRule::DStop, 10}, StopCriterion{StopRule::DStop, 19},
          StopCriterion{StopRule::Epsilon, 0.01}, StopCriterion{StopRule::Delta, 0.01}}) {
        const Framebuffer first = picture_of(scene_of_spheres(orders[0]), oblique, stop);
        for (const auto& order : orders) {
            const Framebuffer frame = picture_of(scene_of_spheres(order), oblique, stop);
            EXPECT_EQ(frame.depth, first.depth);
        }
    }
}

TEST(SeveralSurfaces, LaterOnesAreNotLookedForBehindWhatIsFound) {
    for (const Tracer& tracer : tracers_of_all_formulas()) {
        TraceSettings settings;
        settings.tracer = tracer.name;
        settings.stop.value = 16;
        const auto evaluations = [&](const Scene& scene) {
            Framebuffer frame(image_size, image_size);
            const Counters counters = render_frame(scene, along_y, settings, frame);
            return counters.range + counters.form + (tracer.proves ? 0 : counters.value);
        };
        const std::string wall = "y = -1";
        const std::string hidden = "y = sin(3*x)*cos(3*z)";
        EXPECT_LT(evaluations(scene_of({wall, hidden})),
                  evaluations(scene_of({hidden, wall})) * 3 / 4)
            << tracer.name;
    }
}

TEST(SeveralSurfaces, OneBehindAnotherIsHidden) {
    const Framebuffer alone = picture_of({"y = 0.5"});
    const std::size_t pixels = count_surfaces(alone, 1)[0];
    EXPECT_GT(pixels, 1000U);
    const Framebuffer near_first = picture_of({"y = 0.5", "y = 1"});
    EXPECT_EQ(count_surfaces(near_first, 2), (std::vector<std::size_t>{pixels, 0}));
    EXPECT_EQ(near_first.depth, alone.depth);
    EXPECT_EQ(near_first.color, alone.color);
    EXPECT_EQ(near_first.certificate, alone.certificate);
    const Framebuffer near_last = picture_of({"y = 1", "y = 0.5"});
    EXPECT_EQ(count_surfaces(near_last, 2), (std::vector<std::size_t>{0, pixels}));
    EXPECT_EQ(near_last.depth, alone.depth);
    EXPECT_EQ(near_last.certificate, alone.certificate);
}

TEST(SeveralSurfaces, OfEqualOnesTheFirstIsDrawn) {
    const Framebuffer once = picture_of({"x^2 + y^2 + z^2 = 1"});
    const Framebuffer thrice =
        picture_of({"x^2 + y^2 + z^2 = 1", "x^2 + y^2 + z^2 = 1", "x^2 + y^2 + z^2 = 1"});
    EXPECT_EQ(once.surface, thrice.surface);
    EXPECT_EQ(once.depth, thrice.depth);
    EXPECT_EQ(once.certificate, thrice.certificate);
    EXPECT_EQ(once.color, thrice.color);
}

TEST(SeveralSurfaces, ColorsFollowTheIndex) {
    const Framebuffer first = picture_of({"y = 0"});
    const Framebuffer second = picture_of({"y = 1", "y = 0"});
    ASSERT_EQ(first.depth, second.depth);
    for (std::size_t pixel = 0; pixel < first.color.size(); ++pixel) {
        EXPECT_EQ(first.color[pixel] == second.color[pixel], first.surface[pixel] == no_surface);
    }
}

/// Certificates of the middle third of the middle row.
CertificateCounts middle_of(const Framebuffer& frame) {
    CertificateCounts counts;
    for (int col = image_size / 3; col < image_size * 2 / 3; ++col) {
        switch (frame.certificate[frame.index(col, image_size / 2)]) {
            case Certificate::Miss: ++counts.miss; break;
            case Certificate::Coarse:
            case Certificate::Certified: ++counts.certified; break;
            case Certificate::Undecided: ++counts.undecided; break;
            case Certificate::Jump: ++counts.jumps; break;
        }
    }
    return counts;
}

// A pole within another function, and the edge of a domain: neither can be settled.
const std::string unsettled_in_front[] = {"sinh(1/(y + 0.9))", "sqrt(y + 0.9)"};
const std::string unsettled_behind[] = {"sinh(1/(y - 0.9))", "sqrt(0.9 - y)"};

TEST(SeveralSurfaces, AnUnsettledCellInFrontTakesTheCertificate) {
    const std::string plane = "y = 0.1";
    const Framebuffer alone = picture_of({plane});
    const std::size_t all = image_size / 3;
    EXPECT_EQ(middle_of(alone).certified, all);
    for (const std::string& other : unsettled_in_front) {
        for (const Framebuffer& frame : {picture_of({other, plane}), picture_of({plane, other})}) {
            EXPECT_EQ(middle_of(frame).undecided, all) << other;
            EXPECT_EQ(frame.depth, alone.depth) << other;
        }
    }
    for (const std::string& other : unsettled_behind) {
        for (const Framebuffer& frame : {picture_of({other, plane}), picture_of({plane, other})}) {
            EXPECT_EQ(middle_of(frame).certified, all) << other;
            EXPECT_EQ(frame.depth, alone.depth) << other;
        }
    }
}

TEST(SeveralSurfaces, UnsettledCellsCountPixelByPixel) {
    // The pole y = z is in front of the plane y = 0.1 where z < 0.1.
    const Framebuffer frame = picture_of({"y = 0.1", "sinh(1/(y - z))"});
    constexpr int col = image_size / 2;
    for (int row = 0; row < image_size; ++row) {
        const std::size_t pixel = frame.index(col, row);
        if (frame.surface[pixel] == no_surface) continue;
        const glm::dvec3 hit =
            along_y.eye + static_cast<double>(frame.depth[pixel]) * direction_of(along_y, pixel);
        if (std::abs(hit.z - 0.1) < 0.02) continue;
        EXPECT_EQ(frame.certificate[pixel],
                  hit.z < 0.1 ? Certificate::Undecided : Certificate::Certified)
            << hit.z;
    }
}

TEST(SeveralSurfaces, AnUnsettledCellWithoutAHitIsUndecided) {
    const Framebuffer frame = picture_of({"x = 8", "sinh(1/(y - 0.9))", "x = 9"});
    EXPECT_EQ(middle_of(frame).undecided, static_cast<std::size_t>(image_size / 3));
    EXPECT_EQ(count_surfaces(frame, 3), std::vector<std::size_t>(3));
    EXPECT_EQ(std::ranges::count(frame.depth, std::numeric_limits<float>::infinity()),
              image_size * image_size);
}

TEST(SeveralSurfaces, TheSameOnAnyThreads) {
    const Scene scene = scene_of({"x^2 + y^2 + z^2 = 1", "z - 1/x", "sqrt(x) - y", "x*y*z = 0.1"});
    const Camera camera = default_camera(scene.clip);
    Framebuffer frames[2] = {Framebuffer(150, 130), Framebuffer(150, 130)};
    Counters counters[2];
    for (int i = 0; i < 2; ++i) {
        TraceSettings settings;
        settings.stop.value = 10;
        settings.threads = i + 1;
        counters[i] = render_frame(scene, camera, settings, frames[i]);
    }
    EXPECT_EQ(frames[0].color, frames[1].color);
    EXPECT_EQ(frames[0].depth, frames[1].depth);
    EXPECT_EQ(frames[0].certificate, frames[1].certificate);
    EXPECT_EQ(frames[0].surface, frames[1].surface);
    EXPECT_EQ(counters[0].range, counters[1].range);
    EXPECT_EQ(counters[0].form, counters[1].form);
    EXPECT_EQ(counters[0].value, counters[1].value);
    EXPECT_GT(std::ranges::min(count_surfaces(frames[0], scene.surfaces.size())), 100U);
}

TEST(SeveralSurfaces, HaveGradientsOfPixelsThatTheyWon) {
    TraceSettings settings;
    settings.tracer = "k-bisection";  // it evaluates values for gradients only
    settings.stop.value = 10;
    Framebuffer frame(image_size, image_size);
    const auto values = [&](std::initializer_list<std::string> texts) {
        return render_frame(scene_of(texts), along_y, settings, frame).value;
    };
    const auto alone = values({"y = -0.5"});
    EXPECT_GE(alone, count_surfaces(frame, 1).front());
    EXPECT_EQ(values({"y = -0.5", "x^2 + y^2 + z^2 = 0.1", "y*(x^2 + 1) - 1"}), alone);
    EXPECT_EQ(values({"y*(x^2 + 1) - 1", "y = -0.5"}), alone);
}

TEST(SeveralSurfaces, StopWhenCancelled) {
    const Scene scene = scene_of({"y = 0", "y = 1"});
    Framebuffer frame(image_size, image_size);
    const std::atomic<bool> cancel{true};
    EXPECT_EQ(render_frame(scene, along_y, {}, frame, {.limit = {.cancel = &cancel}}).range, 0U);
    EXPECT_EQ(count_certificates(frame).miss, frame.color.size());
}

}  // namespace
}  // namespace zeroset::test::several_surfaces_test
