#include "engine/trace/render_job.hpp"

#include "engine/expr/interpret.hpp"
#include "engine/expr/parse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string_view>
#include <vector>

// Pictures in the background: coarse ones first, the newest request only, and an end at any time.

namespace zeroset::test {
namespace {

constexpr auto patience = std::chrono::seconds(60);

RenderRequest request_for(std::string_view text, int width, int height) {
    RenderRequest request;
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << expr.error().reason;
        return request;
    }
    request.scene = {{interpret(*expr)}, Box::cube(2), {}};
    request.scene.uniforms.set(0, 0.0);
    request.camera = default_camera(request.scene.clip);
    request.settings.stop.value = 8;
    request.settings.threads = 2;
    request.width = width;
    request.height = height;
    return request;
}

/// A job whose passes are all kept.
class Watched {
public:
    /// All passes up to the final one of request `number`.
    std::vector<RenderResult> passes_until(std::uint64_t number) {
        std::unique_lock lock(mutex_);
        const bool came = changed_.wait_for(lock, patience, [&] {
            return !passes_.empty() && passes_.back().request == number &&
                   passes_.back().coarseness == 1;
        });
        EXPECT_TRUE(came) << "request " << number << " was never finished";
        return passes_;
    }

private:
    void keep() {
        auto result = job.take();
        const std::scoped_lock lock(mutex_);
        if (result) passes_.push_back(std::move(*result));
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<RenderResult> passes_;

public:
    RenderJob job{[this] { keep(); }};  // ends before what it writes to
};

TEST(RenderJob, DrawsCoarsePassesFirst) {
    Watched watched;
    EXPECT_FALSE(watched.job.busy());
    EXPECT_FALSE(watched.job.take());
    const auto number = watched.job.submit(request_for("x^2 + y^2 + z^2 = 1", 101, 67));
    const auto passes = watched.passes_until(number);
    ASSERT_GE(passes.size(), 2U);
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const RenderResult& pass = passes[i];
        EXPECT_EQ(pass.request, number);
        EXPECT_EQ(pass.frame->width, (101 + pass.coarseness - 1) / pass.coarseness);
        EXPECT_EQ(pass.frame->height, (67 + pass.coarseness - 1) / pass.coarseness);
        EXPECT_EQ(pass.counts.certified + pass.counts.undecided + pass.counts.miss,
                  pass.frame->color.size());
        EXPECT_GT(pass.counts.certified, 0U);
        EXPECT_GT(pass.frame_ms, 0.0);
    }
    const auto finer = [](const RenderResult& a, const RenderResult& b) {
        return a.coarseness > b.coarseness;
    };
    EXPECT_TRUE(std::ranges::is_sorted(passes, finer));
    EXPECT_EQ(passes.back().coarseness, 1);
    EXPECT_FALSE(watched.job.busy());
}

TEST(RenderJob, DrawsPicturesOfOnePixel) {
    Watched watched;
    const auto number = watched.job.submit(request_for("z = 0", 1, 1));
    EXPECT_EQ(watched.passes_until(number).back().frame->color.size(), 1U);
}

TEST(RenderJob, TheNewestRequestWins) {
    Watched watched;
    std::uint64_t last = 0;
    for (int i = 0; i < 30; ++i) {
        const auto number = watched.job.submit(request_for("x^2 + y^2 + z^2 = 1", 200, 200 + i));
        EXPECT_GT(number, last);
        last = number;
    }
    const auto passes = watched.passes_until(last);
    EXPECT_EQ(passes.back().frame->height, 229);
    EXPECT_FALSE(watched.job.busy());
    EXPECT_FALSE(watched.job.take());
    for (std::size_t i = 1; i < passes.size(); ++i) {
        EXPECT_GE(passes[i].request, passes[i - 1].request);
    }
}

TEST(RenderJob, ANewRequestEndsTheOneBeforeSoon) {
    Watched watched;
    RenderRequest slow = request_for("(x^2+y^2+z^2-1)*(x*y*z-0.1)*(x+y+z-2)^3", 4000, 4000);
    slow.settings.stop.value = 22;
    watched.job.submit(slow);
    EXPECT_TRUE(watched.job.busy());
    const auto number = watched.job.submit(request_for("z = 0", 16, 16));
    const auto passes = watched.passes_until(number);
    EXPECT_EQ(passes.back().frame->width, 16);
}

TEST(RenderJob, EndsWhileItDraws) {
    for (int i = 0; i < 5; ++i) {
        Watched watched;
        watched.job.submit(request_for("x^4 + y^4 + z^4 = 1", 3000, 3000));
        if (i % 2 == 1) watched.job.submit(request_for("x*y*z = 0.1", 3000, 3000));
    }
}

}  // namespace
}  // namespace zeroset::test
