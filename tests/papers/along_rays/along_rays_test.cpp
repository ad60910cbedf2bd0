#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "papers/along_rays/newton_step.hpp"
#include "papers/along_rays/stretch_stacks.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// The root finders of the papers: their steps, their stop rules, and what point sampling promises.
// What the others promise is tested with all tracers (tests/engine/render).

namespace zeroset::test::along_rays_test {
namespace {

/// The operator's outcome for f = x^2 - c on a stretch.
template <class Step>
TaskOutcome stepped(const Step& step, double from, double to, double c) {
    const UpwardRounding upward;
    const Stretch t{.from = from, .to = to};
    const double m = t.middle();
    const Interval<double> f{c - m * m, m * m - c};
    const Interval<double> slope{-2.0 * from, 2.0 * to};
    TaskOutcome outcome;
    step(t, f, slope, outcome);
    return outcome;
}

bool holds(const TaskOutcome& outcome, double s) {
    return std::any_of(outcome.parts.begin(), outcome.parts.begin() + outcome.count,
                       [s](const Stretch& part) { return part.from <= s && s <= part.to; });
}

TEST(NewtonStep, KeepsTheRootInAShorterStretch) {
    const TaskOutcome outcome = stepped(take_newton_step, 1.0, 2.0, 2.0);
    ASSERT_EQ(outcome.count, 1);
    EXPECT_TRUE(holds(outcome, std::sqrt(2.0)));
    EXPECT_LE(outcome.parts[0].width(), 0.5);
}

TEST(NewtonStep, RejectsAStretchWithoutARoot) {
    EXPECT_EQ(stepped(take_newton_step, 2.0, 3.0, 1.0).count, 0);
    EXPECT_EQ(stepped(take_newton_step, 0.5, 1.0, 9.0).count, 0);
}

TEST(NewtonStep, DividesWhereItGainsLittle) {
    const UpwardRounding upward;
    const Stretch t{.from = 0.0, .to = 1.0};
    TaskOutcome outcome;
    take_newton_step(t, {.neg_lo = 1.0, .hi = 1.0}, {.neg_lo = -1.0, .hi = 2.0}, outcome);
    ASSERT_EQ(outcome.count, 2);
    EXPECT_EQ(outcome.parts[0].from, 0.0);
    EXPECT_EQ(outcome.parts[0].to, outcome.parts[1].from);
    EXPECT_EQ(outcome.parts[1].to, 1.0);
}

TEST(NewtonStep, ForgetsSignsAtEndsThatItMoves) {
    const UpwardRounding upward;
    const Stretch t{.from = 1.0, .to = 2.0, .from_sign = EndSign::Below, .to_sign = EndSign::Above};
    TaskOutcome outcome;
    // f = x - 1.25 with a slope in [0.9, 1].
    take_newton_step(t, {.neg_lo = -0.25, .hi = 0.25}, {.neg_lo = -0.9, .hi = 1.0}, outcome);
    ASSERT_EQ(outcome.count, 1);
    EXPECT_TRUE(holds(outcome, 1.25));
    EXPECT_EQ(outcome.parts[0].from_sign, EndSign::NotAsked);
    EXPECT_EQ(outcome.parts[0].to_sign, EndSign::NotAsked);
}

TEST(AlefeldHansenStep, LeavesTheRootsOnBothSides) {
    const TaskOutcome outcome = stepped(take_alefeld_hansen_step, -3.0, 2.5, 4.0);
    ASSERT_EQ(outcome.count, 2);
    EXPECT_TRUE(holds(outcome, -2.0));
    EXPECT_TRUE(holds(outcome, 2.0));
    EXPECT_FALSE(holds(outcome, -0.25));
    EXPECT_LE(outcome.parts[0].width(), 2.75);
    EXPECT_LE(outcome.parts[1].width(), 2.75);
}

TEST(AlefeldHansenStep, RejectsWhatIsTooFarFrom0) {
    EXPECT_EQ(stepped(take_alefeld_hansen_step, -1.0, 1.5, 100.0).count, 0);
    EXPECT_EQ(stepped(take_alefeld_hansen_step, -1.0, 1.5, -100.0).count, 0);
}

/// A slope that only touches 0, as +0 or as -0, does not lead to one side.
TEST(AlefeldHansenStep, GoesOnlyWhereTheSlopeLeads) {
    const UpwardRounding upward;
    for (const double zero : {0.0, -0.0}) {
        const Stretch t{.from = 0.0, .to = 4.0};
        TaskOutcome rising;
        take_alefeld_hansen_step(t, {.neg_lo = -1.0, .hi = 1.0}, {.neg_lo = zero, .hi = 1.0},
                                 rising);
        ASSERT_EQ(rising.count, 1);
        EXPECT_TRUE(holds(rising, 1.0));
        EXPECT_FALSE(holds(rising, 2.0));
        TaskOutcome falling;
        take_alefeld_hansen_step(t, {.neg_lo = -1.0, .hi = 1.0}, {.neg_lo = 1.0, .hi = zero},
                                 falling);
        ASSERT_EQ(falling.count, 1);
        EXPECT_TRUE(holds(falling, 3.0));
        EXPECT_FALSE(holds(falling, 2.0));
    }
}

TEST(StretchStacks, GiveTheNearestFirst) {
    StretchStacks stacks;
    stacks.begin();
    stacks.push(7, {.from = 2, .to = 3});
    stacks.push(8, {.from = 5, .to = 6});
    stacks.push(7, {.from = 1, .to = 2});
    EXPECT_EQ(stacks.pop(7).from, 1);
    EXPECT_EQ(stacks.top(7).from, 2);
    stacks.push(8, {.from = 4, .to = 5});
    EXPECT_EQ(stacks.pop(7).from, 2);
    EXPECT_TRUE(stacks.empty(7));
    stacks.drop(8);
    EXPECT_TRUE(stacks.empty(8));
}

/// Depths of the unit sphere's hits are as near as the rule asks for, and that is hardly dearer
/// than the finest stretches: methods that soon find isolated roots gain little.
TEST(AlongRays, FollowTheStopRules) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    const Camera camera = default_camera(scene.clip);
    for (const std::string& tracer : tracer_names()) {
        if (tracer == "beams") continue;
        SCOPED_TRACE(tracer);
        const auto drawn = [&](StopCriterion stop, Framebuffer& frame) {
            TraceSettings settings = settings_at(tracer, 22);
            settings.stop = stop;
            const Counters counters = render_frame(scene, camera, settings, frame);
            return counters.range + counters.form;
        };
        Framebuffer finest(48, 48);
        Framebuffer coarse(48, 48);
        const auto most = drawn({StopRule::DStop, 22}, finest);
        for (const StopCriterion stop :
             {StopCriterion{StopRule::Epsilon, 0.02}, StopCriterion{StopRule::Delta, 0.05}}) {
            EXPECT_LT(20 * drawn(stop, coarse), 21 * most);
            int certified = 0;
            for (std::size_t i = 0; i < finest.depth.size(); ++i) {
                if (!is_proved(finest.certificate[i]) || !is_proved(coarse.certificate[i]))
                    continue;
                ++certified;
                EXPECT_NEAR(coarse.depth[i], finest.depth[i], 0.1F) << i;
            }
            EXPECT_GT(certified, 50);
        }
    }
}

struct Sampled {
    Framebuffer frame{40, 40};
    Scene scene;
    Camera camera;

    explicit Sampled(const std::string& text, const Camera* from = nullptr)
        : scene(scene_of(text, Box::cube(2))),
          camera(from != nullptr ? *from : default_camera(scene.clip)) {
        render_frame(scene, camera, settings_at("point-sampling", 16), frame);
    }
    [[nodiscard]] Ray ray(std::size_t i) const {
        const int col = static_cast<int>(i) % frame.width;
        const int row = static_cast<int>(i) / frame.width;
        return {camera, scene.clip, col, row, frame};
    }
    [[nodiscard]] bool is_hit(std::size_t i) const { return std::isfinite(frame.depth[i]); }
};

TEST(PointSampling, ProvesNothing) {
    for (const char* text : {"x^2 + y^2 + z^2 = 1", "x^2 + y^2 + z^2 + 1", "sqrt(x) = z", "1/x"}) {
        const Sampled sampled(text);
        for (std::size_t i = 0; i < sampled.frame.depth.size(); ++i) {
            const Ray ray = sampled.ray(i);
            const bool in_box = ray.t_in < ray.t_out - 1e-9;
            EXPECT_EQ(sampled.frame.certificate[i],
                      in_box ? Certificate::Undecided : Certificate::Miss)
                << text << " " << i;
        }
    }
}

/// Rays that enter the sphere and leave it more than a step later are hit where they enter, and no
/// other ray is.
TEST(PointSampling, FindsRootsThatAreMoreThanAStepApart) {
    const Sampled sampled("x^2 + y^2 + z^2 = 1");
    constexpr double step = 4.0 / 256.0;
    int hits = 0;
    for (std::size_t i = 0; i < sampled.frame.depth.size(); ++i) {
        const Ray ray = sampled.ray(i);
        const double middle = -glm::dot(ray.eye, ray.direction);
        const double square = 1.0 - glm::dot(ray.eye, ray.eye) + middle * middle;
        if (square < 0.0) {
            EXPECT_FALSE(sampled.is_hit(i)) << i;
        } else if (2.0 * std::sqrt(square) > step * ray.stretch()) {
            EXPECT_NEAR(sampled.frame.depth[i], middle - std::sqrt(square), 1e-3) << i;
            ++hits;
        }
    }
    EXPECT_GT(hits, 60);
}

TEST(PointSampling, MissesWhatIsThinnerThanAStep) {
    const Sampled shell("(x^2 + y^2 + z^2 - 1)^2 = 0.000001");  // 0.001 thick
    const Sampled touched("(x - y + z)^2");
    const auto hits = [](const Sampled& sampled) {
        return std::ranges::count_if(sampled.frame.depth, [](float t) { return std::isfinite(t); });
    };
    Framebuffer beams(40, 40);
    render_frame(shell.scene, shell.camera, settings_at("beams", 16), beams);
    EXPECT_LT(2 * hits(shell), static_cast<long>(count_certificates(beams).certified));
    EXPECT_EQ(hits(touched), 0);
}

TEST(PointSampling, TellsAPoleFromARoot) {
    const Sampled pole("1/(x + 0.1*y + 0.01*z)");
    EXPECT_TRUE(std::ranges::none_of(pole.frame.depth, [](float t) { return std::isfinite(t); }));
    const Sampled behind("(y - 1)/(x + 0.1*y + 0.01*z)");
    int hits = 0;
    for (std::size_t i = 0; i < behind.frame.depth.size(); ++i) {
        if (!behind.is_hit(i)) continue;
        EXPECT_NEAR(behind.ray(i).at(static_cast<double>(behind.frame.depth[i])).y, 1.0, 1e-3);
        ++hits;
    }
    EXPECT_GT(hits, 100);
}

TEST(PointSampling, IsUndecidedWhenStopped) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    Framebuffer frame(70, 70);
    render_frame(scene, default_camera(scene.clip), settings_at("point-sampling", 16), frame,
                 {.limit = {.until = TimeLimit::Clock::now() - std::chrono::milliseconds(20)}});
    EXPECT_EQ(count_certificates(frame).not_drawn, frame.color.size());
}

}  // namespace
}  // namespace zeroset::test::along_rays_test
