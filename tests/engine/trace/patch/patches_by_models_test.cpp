#include "engine/render/render.hpp"
#include "tests/support/patch_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <thread>

// Parametric surfaces by models against those without, and against themselves in other sizes.

namespace zeroset::test::patches_by_models_test {
namespace {

/// A coordinate of a surface that nobody chose.
std::string random_coordinate(std::mt19937& numbers) {
    const auto number = [&](double most) {
        return std::to_string(std::uniform_real_distribution(-most, most)(numbers));
    };
    const auto wave = [&](const std::string& variable) {
        const bool is_sine = numbers() % 2 == 0;
        return std::string(is_sine ? "sin(" : "cos(") + number(5.0) + "*" + variable + "+" +
               number(3.0) + ")";
    };
    return "(" + number(0.9) + ")*" + wave("x") + "*" + wave("y") + "+(" + number(0.9) + ")*x*y+(" +
           number(0.8) + ")*" + wave(numbers() % 2 == 0 ? "x" : "y") + "+(" + number(0.5) +
           ")*exp(x-y^2)";
}

/// Models prove just what is proved without them.
TEST(RandomPatches, AreTheSameByModelsAndWithout) {
    std::mt19937 numbers(20261126);
    const Box clip = Box::cube(1.2);
    int hits = 0;
    int undecided = 0;
    for (int i = 0; i < 24; ++i) {
        const std::array<std::string, 3> texts{
            random_coordinate(numbers), random_coordinate(numbers), random_coordinate(numbers)};
        SCOPED_TRACE(texts[0] + ", " + texts[1] + ", " + texts[2]);
        const auto picture = [&](Way way) {
            Framebuffer frame(96, 80);
            render_frame(patch_scene(texts, way, clip), default_camera(clip),
                         settings_at("beams", 20), frame);
            return frame;
        };
        const Framebuffer by_models = picture(Way::ByModels);
        const Framebuffer without = picture(Way::WithoutModels);
        for (std::size_t at = 0; at < without.depth.size(); ++at) {
            if (by_models.certificate[at] == Certificate::Undecided ||
                without.certificate[at] == Certificate::Undecided) {
                ++undecided;
                continue;
            }
            const bool is_hit = std::isfinite(without.depth[at]);
            EXPECT_EQ(std::isfinite(by_models.depth[at]), is_hit) << at;
            if (!is_hit) continue;
            EXPECT_NEAR(by_models.depth[at], without.depth[at], 2e-5F * without.depth[at]) << at;
            ++hits;
        }
    }
    EXPECT_GT(hits, 4000);
    EXPECT_LE(undecided, hits / 100);
}

/// A picture is the same however small the scene is.
TEST(SmallPatches, AreLikeLargeOnes) {
    const auto picture = [](double scale) {
        std::ostringstream text;
        text << scale;
        const std::string by = text.str() + "*";
        const std::string ring = "(1+0.4*cos(6.3*y))*";
        Framebuffer frame(96, 96);
        const Box clip = Box::cube(2 * scale);
        render_frame(
            patch_scene({by + ring + "cos(6.3*x)", by + ring + "sin(6.3*x)", by + "0.4*sin(6.3*y)"},
                        Way::ByModels, clip),
            default_camera(clip), settings_at("beams", 20), frame);
        return frame;
    };
    const Framebuffer large = picture(1);
    for (const double scale : {1e-17, 1e-18, 1e-21}) {
        const Framebuffer small = picture(scale);
        int other = 0;
        for (std::size_t at = 0; at < large.depth.size(); ++at) {
            if (std::isfinite(small.depth[at]) != std::isfinite(large.depth[at])) ++other;
            if (!std::isfinite(small.depth[at]) || !std::isfinite(large.depth[at])) continue;
            if (small.certificate[at] != Certificate::Certified) continue;
            ASSERT_NEAR(static_cast<double>(small.depth[at]) / scale,
                        static_cast<double>(large.depth[at]), 1e-3)
                << scale << " at " << at;
        }
        EXPECT_LE(other, 2) << scale;
    }
}

/// A thread's room may have served tiles of other sizes and places, and other surfaces.
TEST(PatchTiles, AreTheSameWhateverWasTracedBefore) {
    const std::array<std::string, 3> sphere{"cos(pi*(x-1/2))*cos(2*pi*y)",
                                            "cos(pi*(x-1/2))*sin(2*pi*y)", "sin(pi*(x-1/2))"};
    const std::array<std::string, 3> floor{"2*x-1", "2*y-1", "0.3*x*y-0.4"};
    const auto picture = [](const std::array<std::string, 3>& texts, int width, int height) {
        Framebuffer frame(width, height);
        const Box clip = Box::cube(1.5);
        auto settings = settings_at("beams", 22);
        settings.threads = 1;
        render_frame(patch_scene(texts, Way::ByModels, clip), default_camera(clip), settings,
                     frame);
        return frame;
    };
    struct Case {
        const std::array<std::string, 3>& texts;
        int width, height;
    };
    const std::array cases{Case{sphere, 192, 192}, Case{floor, 192, 192}, Case{sphere, 150, 100},
                           Case{floor, 64, 64}};
    for (const Case& one : cases) {
        Framebuffer alone(1, 1);
        std::thread([&] { alone = picture(one.texts, one.width, one.height); }).join();
        EXPECT_GT(std::ranges::count_if(alone.depth, [](float t) { return std::isfinite(t); }), 99);
        for (const Case& before : cases) {
            static_cast<void>(picture(before.texts, before.width, before.height));
            const Framebuffer after = picture(one.texts, one.width, one.height);
            EXPECT_EQ(after.depth, alone.depth);
            EXPECT_EQ(after.certificate, alone.certificate);
        }
    }
}

/// The colours of a floor below a ball do not depend on how their shadows are searched.
TEST(PatchShadows, AreThoseWithoutModels) {
    const std::array<std::string, 3> floor{"2.4*x-1.2", "2.4*y-1.2", "-0.8"};
    const std::array<std::string, 3> ball{"0.6*cos(pi*(x-1/2))*cos(2*pi*y)",
                                          "0.6*cos(pi*(x-1/2))*sin(2*pi*y)", "0.6*sin(pi*(x-1/2))"};
    const Box clip = Box::cube(1.2);
    const auto picture = [&](Way way, bool shadows) {
        TraceSettings settings = settings_at("beams", 22);
        settings.shadows = shadows;
        Framebuffer frame(96, 82);
        Scene scene = patch_scene(floor, way, clip);
        scene.surfaces.push_back(patch_scene(ball, way, clip).surfaces.front());
        render_frame(scene, default_camera(clip), settings, frame);
        return frame.color;
    };
    const auto by_models = picture(Way::ByModels, true);
    const auto without_models = picture(Way::WithoutModels, true);
    const auto unshadowed = picture(Way::ByModels, false);
    int differ = 0;
    int dark = 0;
    for (std::size_t i = 0; i < unshadowed.size(); ++i) {
        differ += by_models[i] == without_models[i] ? 0 : 1;
        dark += by_models[i] == unshadowed[i] ? 0 : 1;
    }
    EXPECT_LE(differ, 6);
    EXPECT_GT(dark, 50);
}

}  // namespace
}  // namespace zeroset::test::patches_by_models_test
