#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

// Functions of which nothing can be proved in whole regions: 0 in all of them, up to rounding, or
// defined nowhere. The rays end where the first such part begins.

namespace zeroset::test::plateaus_test {
namespace {

constexpr int size = 64;
constexpr int pixels = size * size;

Framebuffer picture(const std::string& text, Counters& counters) {
    const Scene scene = scene_of(text, Box::cube(2));
    Framebuffer frame(size, size);
    frame.keep_planes(true);
    counters = render_frame(scene, default_camera(scene.clip), settings_at("beams", 12), frame);
    return frame;
}

double evaluations(const Counters& counters) {
    return static_cast<double>(counters.range + counters.form + counters.value);
}

TEST(Plateaus, AreDrawnWhereTheyBegin) {
    struct Plateau {
        std::string text, exact;
    };
    const Plateau plateaus[] = {{"sin(floor(x))", "floor(x)"},
                                {"abs(x) + x", "min(max(x, 0), 5)"},
                                {"ln(ceil(x))", "ceil(x) - 1"},
                                {"atanh(sqrt(ceil(y)))", "ceil(y)"}};
    for (const Plateau& plateau : plateaus) {
        Counters counters, exact_counters;
        const Framebuffer found = picture(plateau.text, counters);
        const Framebuffer exact = picture(plateau.exact, exact_counters);
        int drawn = 0;
        for (std::size_t i = 0; i < pixels; ++i) {
            ASSERT_EQ(std::isfinite(found.depth[i]), std::isfinite(exact.depth[i]))
                << plateau.text << " at " << i;
            if (!std::isfinite(exact.depth[i])) continue;
            ++drawn;
            ASSERT_NEAR(found.depth[i], exact.depth[i], 1e-3) << plateau.text << " at " << i;
        }
        EXPECT_GT(drawn, pixels / 10) << plateau.text;
        EXPECT_LT(evaluations(counters), 2000.0 * drawn) << plateau.text;
    }
}

TEST(Plateaus, ThatAreDefinedNowhereAreUndecided) {
    Counters counters;
    const Framebuffer frame = picture("sin(atan2(ceil(z - z), ceil(z - z)))", counters);
    int undecided = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        undecided += frame.certificate[i] == Certificate::Undecided ? 1 : 0;
    EXPECT_GT(undecided, pixels / 3);
    EXPECT_LT(evaluations(counters), 20000.0 * undecided);
}

}  // namespace
}  // namespace zeroset::test::plateaus_test
