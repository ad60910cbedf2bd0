#include "engine/render/render.hpp"
#include "engine/rewrite/traceable.hpp"
#include "tests/engine/render/domain_scenes.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Poles, jumps, kinks and ends of domains: what each tracer draws there, where, and what it claims
// to have proved, at coarse and fine d_stop, along and across the discontinuity.

namespace zeroset::test::domain_test {
namespace {

constexpr int image_size = 25;
constexpr double rounding = 1e-5;  ///< of depths of up to 12 in float, upward
/// A certificate looks for the opposite sign up to three cells behind the first.
constexpr double bracket_cells = 4.0;
/// Clear rays must be decided in cells that are small, but larger than the errors of float.
bool must_decide(double d_stop) { return d_stop >= 14 && d_stop <= 18; }

std::vector<Camera> cameras() {
    return {{{5, -6, 4}, {0.07, 0.03, 0}, {0, 0, 1}, 0.56},
            {{0.1, 0.2, 8}, {0.1, 0.2, 0}, {0, 1, 0}, 0.62},
            {{-8, 0.13, 0.21}, {0, 0.13, 0.21}, {0, 0, 1}, 0.62}};
}

struct Pixel {
    Certificate certificate;
    double depth;
};

/// How many rays were clear, so that a test of them is not one of none.
struct Clear {
    int hits = 0, misses = 0;
};

class DomainTest : public ::testing::TestWithParam<std::string> {
protected:
    static Framebuffer picture_of(const Scene& scene, const Camera& camera, double d_stop) {
        Framebuffer frame(image_size, image_size);
        render_frame(scene, camera, settings_at(GetParam(), d_stop), frame);
        return frame;
    }
    static void check_pictures(const DomainScene& domain, const Scene& scene);
};

/// A pixel must show and claim the truth.
void expect_true(const DomainScene& scene, const Ray& ray, const Meeting& met, const Pixel& pixel,
                 double cell) {
    const double margin = bracket_cells * cell * ray.stretch() + rounding;
    if (pixel.certificate == Certificate::Miss) {
        EXPECT_EQ(met.first, infinity) << "claimed empty";
    } else if (pixel.certificate == Certificate::Certified) {
        EXPECT_NEAR(pixel.depth, met.first, margin) << "certified";
    } else if (pixel.depth < infinity) {
        // The places that is_near tries may all miss the domain where the point is outside of it.
        EXPECT_TRUE(std::abs(pixel.depth - met.first) < margin ||
                    is_near(scene, ray.at(pixel.depth), bracket_cells * cell + rounding))
            << "drawn at " << pixel.depth << ", off the surface";
    }
}

/// A clear ray must be drawn where it hits, and be decided.
void expect_decided(const DomainScene& scene, const Ray& ray, const Meeting& met,
                    const Pixel& pixel, double cell) {
    const bool hits = met.first < infinity;
    if (hits) {
        EXPECT_NEAR(pixel.depth, met.first, bracket_cells * cell * ray.stretch() + rounding);
    } else {
        EXPECT_EQ(pixel.depth, infinity) << "drawn, where there is nothing";
    }
    if (met.jumps && scene.undecided_jumps) return;
    EXPECT_EQ(pixel.certificate, hits ? Certificate::Certified : Certificate::Miss);
}

Clear check(const DomainScene& domain, const Scene& scene, const Camera& camera,
            const std::vector<Framebuffer>& frames, const std::vector<double>& d_stops) {
    Clear clear;
    for (int row = 0; row < image_size; ++row) {
        for (int col = 0; col < image_size; ++col) {
            const Ray ray(camera, scene.clip, col, row, frames.front());
            const Meeting met = meeting_of(domain, ray);
            (met.first < infinity ? clear.hits : clear.misses) += met.clear ? 1 : 0;
            for (std::size_t i = 0; i < frames.size(); ++i) {
                SCOPED_TRACE(domain.text + ", eye x " + std::to_string(camera.eye.x) + ", pixel " +
                             std::to_string(col) + "," + std::to_string(row) + ", d_stop " +
                             std::to_string(d_stops[i]) + ", root " + std::to_string(met.first));
                const std::size_t at = frames[i].index(col, row);
                const Pixel pixel{frames[i].certificate[at],
                                  static_cast<double>(frames[i].depth[at])};
                const double cell = scene.clip.size() * std::exp2(-d_stops[i]);
                expect_true(domain, ray, met, pixel, cell);
                if (met.clear && must_decide(d_stops[i])) {
                    expect_decided(domain, ray, met, pixel, cell);
                }
            }
        }
    }
    return clear;
}

void DomainTest::check_pictures(const DomainScene& domain, const Scene& scene) {
    const std::vector<double> d_stops{6, 10, 14, 18, 22};
    Clear clear;
    for (const Camera& camera : cameras()) {
        std::vector<Framebuffer> frames;
        for (const double d_stop : d_stops)
            frames.push_back(picture_of(scene, camera, d_stop));
        const Clear more = check(domain, scene, camera, frames, d_stops);
        clear.hits += more.hits;
        clear.misses += more.misses;
    }
    EXPECT_GT(clear.hits, 40) << domain.text;
    EXPECT_GT(clear.misses, 40) << domain.text;
}

TEST_P(DomainTest, DrawsWhatIsThereAndNothingElse) {
    for (const DomainScene& domain : domain_scenes())
        check_pictures(domain, scene_of(domain.text, Box::cube(2)));
}

/// The form that the program traces has no poles, and gives the same pictures.
TEST_P(DomainTest, DrawsTheSameInTheTraceableForm) {
    int rewritten = 0;
    for (const DomainScene& domain : domain_scenes()) {
        const Expr typed = *parse(domain.text);
        const Expr drawn = traceable(typed);
        const bool other = std::ranges::any_of(
            drawn.nodes(), [](const Node& node) { return node.op == Op::Oriented; });
        if (!other) continue;
        ++rewritten;
        Scene scene{{{.kernel = interpret(drawn)}}, Box::cube(2), {}};
        scene.uniforms.set(0, 0.0);
        check_pictures(domain, scene);
    }
    EXPECT_GE(rewritten, 2);
}

/// A formula that is defined on a plane only has no inside where a sign could change.
TEST_P(DomainTest, LeavesUndecidedWhatHasNoInside) {
    const Scene scene = scene_of("sqrt(-x^2)", Box::cube(2));
    for (const Camera& camera : cameras()) {
        for (const double d_stop : {6.0, 14.0, 22.0}) {
            const Framebuffer frame = picture_of(scene, camera, d_stop);
            for (int row = 0; row < image_size; ++row) {
                for (int col = 0; col < image_size; ++col) {
                    const Ray ray(camera, scene.clip, col, row, frame);
                    const double t = -ray.eye.x / ray.direction.x;
                    const bool crosses = t > ray.t_in + 0.1 && t < ray.t_out - 0.1;
                    const std::size_t at = frame.index(col, row);
                    EXPECT_NE(frame.certificate[at], Certificate::Certified);
                    EXPECT_TRUE(!crosses || frame.certificate[at] == Certificate::Undecided)
                        << col << "," << row;
                }
            }
        }
    }
}

/// On the clip box's own face f has no opposite sign behind it.
TEST_P(DomainTest, DrawsASurfaceOnAFaceOfTheBox) {
    const Scene scene = scene_of("z = 2", Box::cube(2));
    const Camera above = cameras()[1];
    for (const double d_stop : {6.0, 14.0, 22.0}) {
        const Framebuffer frame = picture_of(scene, above, d_stop);
        const std::size_t middle = frame.index(image_size / 2, image_size / 2);
        EXPECT_EQ(frame.certificate[middle], Certificate::Undecided);
        EXPECT_NEAR(static_cast<double>(frame.depth[middle]), 6.0, 4 * std::exp2(-d_stop) + 1e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(AllTracers, DomainTest,
                         ::testing::ValuesIn(names_of(proving_tracers_to_try())),
                         [](const auto& tracer) { return test_name(tracer.param); });

}  // namespace
}  // namespace zeroset::test::domain_test
