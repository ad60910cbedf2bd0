#include "engine/render/render.hpp"
#include "engine/trace/tile_turns.hpp"
#include "tests/engine/render/hooked_kernel.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

// Frames that end before they are finished: what they say is what the whole frame says.

namespace zeroset::test::time_limit_test {
namespace {

using Clock = TimeLimit::Clock;
using std::chrono::milliseconds;

constexpr int image_size = 130;  // nine tiles

class TimeLimitTest : public ::testing::TestWithParam<std::string> {
protected:
    static Framebuffer drawn(const Scene& scene, const TraceSettings& settings,
                             const RenderWatch& watch, Counters* counters = nullptr) {
        Framebuffer frame(image_size, image_size);
        const Counters done =
            render_frame(scene, default_camera(scene.clip), settings, frame, watch);
        if (counters != nullptr) *counters = done;
        return frame;
    }
    [[nodiscard]] static TraceSettings settings() {
        TraceSettings settings = settings_at(GetParam(), 14);
        settings.threads = 1;
        return settings;
    }
};

/// A frame whose time runs out with the call number `last` of the kernel.
struct CutFrame {
    Framebuffer frame;
    Counters counters;

    CutFrame(const Scene& scene, const TraceSettings& settings, int last)
        : frame(image_size, image_size) {
        std::atomic<int> calls = 0;
        Scene slow = scene;
        // A limit cannot be moved while it is looked at: the call sleeps until a near one is over.
        const TimeLimit limit{.until = Clock::now() + milliseconds(60)};
        for (Surface& surface : slow.surfaces) {
            surface.kernel = hooked(surface.kernel, [&calls, last, &limit] {
                if (++calls == last) std::this_thread::sleep_until(limit.until + milliseconds(12));
            });
        }
        counters = render_frame(slow, default_camera(slow.clip), settings, frame, {.limit = limit});
    }
};

void expect_agrees(const Framebuffer& cut, const Framebuffer& whole) {
    for (std::size_t i = 0; i < cut.depth.size(); ++i) {
        switch (cut.certificate[i]) {
            case Certificate::Undecided: break;
            case Certificate::Jump: ADD_FAILURE() << i << ": not asked for"; break;
            case Certificate::Miss: ASSERT_EQ(whole.certificate[i], Certificate::Miss) << i; break;
            case Certificate::Certified:
            case Certificate::Coarse:
                ASSERT_TRUE(is_proved(whole.certificate[i])) << i;
                ASSERT_NEAR(cut.depth[i], whole.depth[i], 2e-3F) << i;
                break;
        }
    }
}

TEST_P(TimeLimitTest, SaysNothingThatTheWholeFrameDoesNot) {
    const std::vector<std::vector<std::string>> scenes{{"sin(5x) sin(5y) sin(5z) = 0.1"},
                                                       {"floor(3x) + y^2 + z^2 = 1"},
                                                       {"x^2 + y^2 + z^2 = 1", "z = 0.3 sin(4x)"}};
    for (const auto& texts : scenes) {
        SCOPED_TRACE(texts.front());
        Scene scene = scene_of(texts.front(), Box::cube(2));
        for (std::size_t i = 1; i < texts.size(); ++i)
            scene.surfaces.push_back(scene_of(texts[i], scene.clip).surfaces.front());
        const Framebuffer whole = drawn(scene, settings(), {});
        std::size_t cuts = 0;
        const std::vector<int> ends =
            is_long_run() ? std::vector{1, 2, 3, 5, 8, 13, 21, 34, 60, 100} : std::vector{2, 34};
        for (const int last : ends) {
            SCOPED_TRACE(last);
            const CutFrame cut(scene, settings(), last);
            expect_agrees(cut.frame, whole);
            const auto undecided = count_certificates(cut.frame).undecided;
            EXPECT_LE(cut.counters.cut_pixels, undecided);
            cuts += cut.counters.cut_pixels > 0 ? 1 : 0;
        }
        EXPECT_GE(cuts, ends.size() / 2);
    }
}

TEST_P(TimeLimitTest, DecidesNothingWithoutTime) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    Counters counters;
    const Framebuffer frame =
        drawn(scene, settings(), {.limit = {.until = Clock::now() - milliseconds(20)}}, &counters);
    const CertificateCounts counts = count_certificates(frame);
    EXPECT_EQ(counts.undecided, frame.color.size());
    EXPECT_EQ(counts.not_drawn, frame.color.size());
    EXPECT_EQ(counters.cut_pixels, frame.color.size());
    EXPECT_EQ(counters.form + counters.range + counters.value, 0U);
}

TEST_P(TimeLimitTest, ChangesNothingWhereThereIsTime) {
    const Scene scene = scene_of("sin(5x) sin(5y) sin(5z) = 0.1", Box::cube(2));
    Counters counters;
    const Framebuffer frame = drawn(
        scene, settings(), {.limit = {.until = Clock::now() + std::chrono::hours(1)}}, &counters);
    const Framebuffer whole = drawn(scene, settings(), {});
    EXPECT_EQ(frame.color, whole.color);
    EXPECT_EQ(frame.certificate, whole.certificate);
    EXPECT_FALSE(counters.is_cut());
}

INSTANTIATE_TEST_SUITE_P(AllTracers, TimeLimitTest,
                         ::testing::ValuesIn(names_of(proving_tracers_to_try())),
                         [](const auto& tracer) { return test_name(tracer.param); });

TEST(TileTurns, ShareWhatIsLeft) {
    const auto start = Clock::now();
    const auto hour = std::chrono::minutes(60);
    TileTurns turns(4, 2, {.until = start + hour});
    turns.begin(4);
    const auto first = turns.take(0);
    ASSERT_TRUE(first);
    EXPECT_LE(first->until, start + hour / 2 + std::chrono::minutes(1));
    EXPECT_GE(first->until, start + hour / 2 - std::chrono::minutes(1));
    turns.take(1);
    turns.take(2);
    // The last two have a core each.
    EXPECT_EQ(turns.take(3)->until, start + hour);
    // Tiles that are tried again get more time than they had.
    turns.begin(1);
    EXPECT_EQ(turns.take(0)->until, start + hour);
    turns.begin(1);
    EXPECT_FALSE(turns.take(0));
}

TEST(TileTurns, EndWithTheirTime) {
    const auto over = Clock::now() - milliseconds(20);
    TileTurns turns(2, 1, {.until = over});
    turns.begin(2);
    EXPECT_TRUE(turns.take(0)->over());
    turns.begin(1);
    EXPECT_FALSE(turns.take(0));
}

TEST(TileTurns, HaveAllTheTimeWithoutALimit) {
    TileTurns turns(1, 1, {});
    turns.begin(1);
    EXPECT_EQ(turns.take(0)->until, TimeLimit::never);
}

TEST(TileTurns, GrowFromAFirstOne) {
    TileTurns turns(1, 1, {}, std::chrono::hours(1));
    for (const int hours : {1, 4, 16}) {
        turns.begin(1);
        const auto until = turns.take(0)->until;
        EXPECT_NEAR(std::chrono::duration<double>(until - Clock::now()).count(), 3600.0 * hours,
                    60.0);
    }
}

/// Without a limit a tile that takes long waits for the others, and is finished in the end.
TEST(RenderFrame, DrawsQuickTilesFirst) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    std::atomic<int> calls = 0;
    scene.surfaces[0].kernel = hooked(scene.surfaces[0].kernel, [&] {
        if (calls++ == 1) std::this_thread::sleep_for(milliseconds(40));
    });
    Framebuffer frame(image_size, image_size);
    TraceSettings settings = settings_at("beams", 10);
    settings.threads = 1;
    std::vector<PixelRect> order;
    const Counters counters =
        render_frame(scene, default_camera(scene.clip), settings, frame,
                     {.first_turn = milliseconds(16),
                      .on_tile = [&](const PixelRect& rect) { order.push_back(rect); }});
    ASSERT_EQ(order.size(), 9U);
    EXPECT_FALSE(counters.is_cut());
    EXPECT_GT(count_certificates(frame).certified, 500U);
}

}  // namespace
}  // namespace zeroset::test::time_limit_test
