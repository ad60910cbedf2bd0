#include "engine/image/frame_pictures.hpp"
#include "engine/render/render.hpp"
#include "engine/render/tracers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

// The cost of pixels to a tracer.

namespace zeroset::test::cost_test {
namespace {

struct Drawn {
    Framebuffer frame{128, 128};
    Counters counters;

    [[nodiscard]] double told() const {
        return std::accumulate(frame.cost.begin(), frame.cost.end(), 0.0);
    }
    [[nodiscard]] double counted() const {
        return static_cast<double>(counters.range + counters.value + counters.form);
    }
};

Drawn drawn(const Scene& scene, const std::string& tracer, bool costs = true) {
    TraceSettings settings;
    settings.tracer = tracer;
    settings.stop.value = 12;
    settings.costs = costs;
    settings.threads = 1;
    Drawn result;
    result.counters = render_frame(scene, default_camera(scene.clip), settings, result.frame);
    return result;
}

class Cost : public testing::TestWithParam<std::string> {};

TEST_P(Cost, IsEveryEvaluationSharedOutOverThePixels) {
    for (const char* const text :
         {"x^2 + y^2 + z^2 = 1", "(x^2 + y^2 + z^2 + 0.5)^2 = 2.6*(x^2 + y^2)",
          "max(x^2 + y^2 - 1, abs(z) - 0.5) = 0", "1/x + y = z^2", "sqrt(x) = y + z",
          "abs(x) + min(y, z^2) = 1", "floor(3x) = y"}) {
        const Drawn picture = drawn(scene_of(text, Box::cube(1.5)), GetParam());
        ASSERT_GT(picture.counted(), 0.0) << text;
        EXPECT_NEAR(picture.told() / picture.counted(), 1.0, 1e-4) << text;
    }
}

TEST_P(Cost, IsHigherWhereThereIsSomethingToFind) {
    const Drawn picture = drawn(scene_of("x^2 + y^2 + z^2 = 0.2", Box::cube(1.0)), GetParam());
    const auto& cost = picture.frame.cost;
    EXPECT_GT(cost[picture.frame.index(64, 64)], cost[0]);
}

TEST_P(Cost, ChangesNothing) {
    const Scene scene = scene_of("x^3 + y^2 = z^2 + 0.1", Box::cube(1.5));
    const Drawn with = drawn(scene, GetParam());
    const Drawn without = drawn(scene, GetParam(), false);
    EXPECT_EQ(with.frame.color, without.frame.color);
    EXPECT_EQ(with.frame.depth, without.frame.depth);
    EXPECT_EQ(with.counted(), without.counted());
    EXPECT_TRUE(without.frame.cost.empty());
}

std::vector<std::string> names_of_tracers() {
    std::vector<std::string> names;
    for (const Tracer& tracer : tracers_of_all_formulas())
        names.emplace_back(tracer.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(AllTracers, Cost, testing::ValuesIn(names_of_tracers()),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(CostColors, AreThoseOfAScaleEvenInLogarithms) {
    Framebuffer frame(5, 1);
    frame.cost = {0.0F, 0.1F, 10.0F, 1000.0F, 1e6F};
    const auto colors = cost_colors(frame);
    EXPECT_EQ(colors[0], shown_color_at(cost_map, 0.0));
    EXPECT_EQ(colors[1], shown_color_at(cost_map, 0.0));
    EXPECT_EQ(colors[2], shown_color_at(cost_map, 0.5));
    EXPECT_EQ(colors[3], shown_color_at(cost_map, 1.0));
    EXPECT_EQ(colors[4], shown_color_at(cost_map, 1.0));
    EXPECT_NEAR(mean_cost(frame), 1001010.1 / 5.0, 0.1);
    EXPECT_EQ(mean_cost(Framebuffer(3, 3)), 0.0);
}

}  // namespace
}  // namespace zeroset::test::cost_test
