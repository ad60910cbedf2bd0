#include "engine/base/parallel.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "tests/support/host_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

// The threads of the parallel loop round as their work says, whatever the mode of the thread that
// started it, and leave that one's alone: in both implementations of the loop.

#define parallel_for parallel_for_jthread
#define core_count core_count_jthread
#include "engine/base/parallel_jthread.cpp"
#undef parallel_for
#undef core_count

namespace zeroset::test::rounding_threads_test {
namespace {

using Loop = void (*)(std::size_t, int, const std::function<void(std::size_t)>&);
struct Implementation {
    const char* name;
    Loop loop;
};
constexpr Implementation implementations[] = {{"built", parallel_for},
                                              {"jthread", parallel_for_jthread}};

constexpr std::size_t calls = 400;

/// Upper bounds of a product that is a denormal, and of -1/3.
bool computes_upward() {
    const volatile float tiny = 0x1p-100F;
    const volatile float tinier = 0x1.8p-40F;
    const volatile float one = -1.0F;
    const volatile float three = 3.0F;
    const volatile float product = tiny * tinier;
    const volatile float quotient = one / three;
    return product == 0x1.8p-140F && quotient == -0x1.555554p-2F;
}

TEST(ParallelRounding, IsThatOfTheGuardInEveryModeOfTheCaller) {
    for (const auto& [name, loop] : implementations) {
        for (const int mode : all_modes) {
            for (const unsigned flush : all_flushes) {
                const HostControl host(mode, flush);
                const unsigned before = control();
                std::atomic<std::size_t> upward{0};
                loop(calls, 3, [&](std::size_t) {
                    const UpwardRounding guard;
                    if (rounds_upward() && computes_upward()) ++upward;
                });
                EXPECT_EQ(upward, calls) << name << " in mode " << mode;
                EXPECT_EQ(control(), before) << name;
                EXPECT_EQ(std::fegetround(), mode) << name;
            }
        }
    }
}

TEST(ParallelRounding, DoesNotLeakFromCallToCall) {
    for (const auto& [name, loop] : implementations) {
        std::atomic<std::size_t> changed{0};
        loop(calls, 3, [&](std::size_t) {
            const unsigned before = control();
            {
                const UpwardRounding guard;
                const NearestCall call;
            }
            if (control() != before) ++changed;
        });
        EXPECT_EQ(changed, 0U) << name;
        EXPECT_EQ(std::fegetround(), FE_TONEAREST) << name;
    }
}

TEST(ParallelRounding, HoldsWithinALoopWithinALoop) {
    for (const auto& [name, loop] : implementations) {
        std::atomic<std::size_t> upward{0};
        loop(8, 2, [&, inner = loop](std::size_t) {
            const UpwardRounding outer;
            inner(8, 2, [&](std::size_t) {
                const UpwardRounding guard;
                if (computes_upward()) ++upward;
            });
            if (!rounds_upward()) upward = 1000;
        });
        EXPECT_EQ(upward, 64U) << name;
    }
}

std::vector<float> depths_of_a_sphere() {
    Scene scene;
    scene.surfaces = {{.kernel = interpret(*parse("x^2 + y^2 + z^2 - 1"))}};
    scene.uniforms.set(0, 0.0);
    Framebuffer frame(48, 32);
    TraceSettings settings;
    settings.threads = 2;
    const Counters counters = render_frame(scene, default_camera(scene.clip), settings, frame);
    EXPECT_GT(counters.range + counters.form, 0U);
    return {frame.depth.begin(), frame.depth.end()};
}

TEST(RenderedFrame, IsTheSameInEveryModeOfTheCaller) {
    const std::vector<float> expected = depths_of_a_sphere();
    for (const int mode : all_modes) {
        const HostControl host(mode, flush_all);
        const unsigned before = control();
        EXPECT_EQ(depths_of_a_sphere(), expected) << mode;
        EXPECT_EQ(control(), before);
        EXPECT_EQ(std::fegetround(), mode);
    }
}

}  // namespace
}  // namespace zeroset::test::rounding_threads_test
