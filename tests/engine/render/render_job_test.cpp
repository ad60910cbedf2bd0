#include "engine/render/render_job.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/render/render.hpp"
#include "tests/engine/render/hooked_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

// Pictures in the background: a quick one, then the full one; the newest request only, and an end
// at any time.

namespace zeroset::test::render_job_test {
namespace {

constexpr auto patience = std::chrono::minutes(10);

RenderRequest request_for(std::string_view text, int width, int height) {
    RenderRequest request;
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << expr.error().reason;
        return request;
    }
    request.scene = {{{.kernel = interpret(*expr)}}, Box::cube(2), {}};
    request.scene.uniforms.set(0, 0.0);
    request.camera = default_camera(request.scene.clip);
    request.settings.stop.value = 8;
    request.settings.threads = 2;
    request.width = width;
    request.height = height;
    return request;
}

/// No trial and no picture is shown while it grows, however slow the machine.
RenderPace whole_pictures() {
    RenderPace pace;
    pace.growth_shown_after = std::chrono::hours(1);
    pace.trial_shown_from_ms = 1e9;
    return pace;
}

/// A job whose pictures are all kept, but for those that nobody had time to take.
class Watched {
public:
    explicit Watched(const RenderPace& pace = whole_pictures()) : job([this] { keep(); }, pace) {}

    /// All pictures up to the complete one of request `number`.
    std::vector<RenderResult> pictures_until(std::uint64_t number) {
        return wait_for(
            [number](const RenderResult& last) { return last.request == number && last.complete; });
    }
    /// All pictures up to the first one of request `number`.
    std::vector<RenderResult> pictures_to(std::uint64_t number) {
        return wait_for([number](const RenderResult& last) { return last.request == number; });
    }

private:
    void keep() {
        auto result = job.take();
        const std::scoped_lock lock(mutex_);
        if (result) pictures_.push_back(std::move(*result));
        changed_.notify_all();
    }
    std::vector<RenderResult> wait_for(const std::function<bool(const RenderResult&)>& wanted) {
        std::unique_lock lock(mutex_);
        const bool came = changed_.wait_for(
            lock, patience, [&] { return !pictures_.empty() && wanted(pictures_.back()); });
        EXPECT_TRUE(came) << "the picture never came";
        return pictures_;
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<RenderResult> pictures_;

public:
    RenderJob job;  // ends before what it writes to
};

/// First pictures are as coarse as can be, and nothing rests within a test's time.
RenderPace restless() {
    RenderPace pace = whole_pictures();
    pace.budget_ms = 1e-9;
    pace.at_once_ms = 0.0;
    pace.rest_after = std::chrono::hours(1);
    return pace;
}

TEST(RenderJob, DrawsAQuickPictureFirst) {
    Watched watched;
    EXPECT_FALSE(watched.job.busy());
    EXPECT_FALSE(watched.job.take());
    const auto number = watched.job.submit(request_for("x^2 + y^2 + z^2 = 1", 101, 67));
    const auto pictures = watched.pictures_until(number);
    ASSERT_EQ(pictures.size(), 2U);
    const RenderResult& first = pictures[0];
    const RenderResult& full = pictures[1];
    EXPECT_FALSE(first.complete);
    EXPECT_EQ(first.frame->width, 13);  // an eighth: it is interpreted, and its cost not known
    EXPECT_EQ(first.frame->height, 8);
    EXPECT_TRUE(full.complete);
    EXPECT_EQ(full.frame->width, 101);
    EXPECT_EQ(full.frame->height, 67);
    EXPECT_EQ(full.counts.certified + full.counts.undecided + full.counts.miss, 101U * 67U);
    EXPECT_GT(full.counts.certified, 0U);
    for (const RenderResult& picture : pictures) {
        EXPECT_EQ(picture.request, number);
        EXPECT_GT(picture.frame_ms, 0.0);
    }
    EXPECT_FALSE(watched.job.busy());
}

TEST(RenderJob, DrawsAtOnceWhatIsKnownToBeQuick) {
    RenderPace pace = whole_pictures();
    pace.at_once_ms = 1e9;
    pace.rest_after = std::chrono::milliseconds(0);
    Watched watched(pace);
    const RenderRequest request = request_for("x^2 + y^2 + z^2 = 1", 64, 64);
    watched.pictures_until(watched.job.submit(request));
    const auto number = watched.job.submit(request);
    const auto pictures = watched.pictures_until(number);
    ASSERT_EQ(pictures.size(), 3U);
    EXPECT_TRUE(pictures[2].complete);
}

TEST(RenderJob, ShowsATrialOfWhatWillTakeLong) {
    for (const bool is_long : {true, false}) {
        RenderPace pace = whole_pictures();
        pace.trial_shown_from_ms = is_long ? 0.0 : 1e9;
        RenderRequest request = request_for("x^2 + y^2 + z^2 = 1", 128, 64);
        Watched watched(pace);
        const auto first = watched.pictures_to(watched.job.submit(request)).front();
        EXPECT_EQ(first.frame->width, is_long ? 4 : 16);
        EXPECT_EQ(first.frame->height, is_long ? 2 : 8);
        watched.pictures_until(first.request);
        // A view that has been seen needs no trial.
        request.again = true;
        const auto next = watched.pictures_to(watched.job.submit(request)).back();
        EXPECT_GE(next.frame->width, 16);
    }
}

TEST(RenderJob, ShowsASmallerTrialOfALongFormula) {
    RenderPace pace = whole_pictures();
    pace.trial_shown_from_ms = 0.0;
    std::string text = "x^2 + y^2 + z^2";
    for (int i = 1; i <= 40; ++i)
        text += " + sin(" + std::to_string(i) + "*x)";
    Watched watched(pace);
    const auto number = watched.job.submit(request_for(text + " = 4", 128, 64));
    const auto first = watched.pictures_to(number).front();
    EXPECT_EQ(first.frame->width, 2);
    EXPECT_EQ(first.frame->height, 1);
}

TEST(RenderJob, DrawsOnlyQuickPicturesWhileSomethingMoves) {
    Watched watched(restless());
    const RenderRequest request = request_for("x^2 + y^2 + z^2 = 1", 160, 160);
    watched.pictures_to(watched.job.submit(request));
    for (int i = 0; i < 5; ++i) {
        const auto number = watched.job.submit(request);
        const RenderResult last = watched.pictures_to(number).back();
        EXPECT_FALSE(last.complete);
        EXPECT_EQ(last.frame->width, 20);  // an eighth: nothing is coarser
        EXPECT_TRUE(watched.job.busy());
    }
}

TEST(RenderJob, ShowsAFullPictureWhileItGrows) {
    RenderPace pace = whole_pictures();
    pace.growth_shown_after = std::chrono::milliseconds(0);
    Watched watched(pace);
    RenderRequest request = request_for("x^2 + y^2 + z^2 = 4", 256, 192);
    request.settings.threads = 1;
    const auto number = watched.job.submit(request);
    const auto pictures = watched.pictures_until(number);
    ASSERT_GE(pictures.size(), 3U);
    const Framebuffer& first = *pictures.front().frame;
    const Framebuffer& full = *pictures.back().frame;
    const RenderResult& half_way = pictures[pictures.size() / 2];
    const Framebuffer& grown = *half_way.frame;
    EXPECT_FALSE(half_way.complete);
    ASSERT_EQ(grown.width, 256);
    ASSERT_EQ(grown.height, 192);
    // Some tiles are drawn, elsewhere the first picture is stretched.
    std::size_t drawn = 0;
    std::size_t stretched = 0;
    for (int row = 0; row < 192; ++row) {
        for (int col = 0; col < 256; ++col) {
            const float depth = grown.depth[full.index(col, row)];
            const float fine = full.depth[full.index(col, row)];
            const float coarse =
                first.depth[first.index(col * first.width / 256, row * first.height / 192)];
            ASSERT_TRUE(depth == fine || depth == coarse);
            if (fine != coarse) ++(depth == fine ? drawn : stretched);
        }
    }
    EXPECT_GT(drawn, 0U);
    EXPECT_GT(stretched, 0U);
}

TEST(RenderJob, DrawsShadowsAndSmoothEdgesLast) {
    Watched watched;
    RenderRequest request = request_for("(z + 1) (x^2 + y^2 + z^2 - 0.25) = 0", 64, 64);
    request.settings.shadows = true;
    request.settings.antialias = Antialias::Beams;
    const auto pictures = watched.pictures_until(watched.job.submit(request));
    ASSERT_EQ(pictures.size(), 4U);
    for (std::size_t i = 2; i < 4; ++i) {
        EXPECT_FALSE(pictures[i - 1].complete);
        EXPECT_EQ(pictures[i - 1].frame->depth, pictures[i].frame->depth);
        EXPECT_NE(pictures[i - 1].frame->color, pictures[i].frame->color);
        EXPECT_EQ(pictures[i - 1].counts.certified, pictures[i].counts.certified);
    }
}

TEST(RenderJob, DrawsShadowsWhileSomethingMovesOnceTheyAreKnownToFit) {
    RenderPace pace = whole_pictures();
    pace.rest_after = std::chrono::hours(1);
    RenderRequest request = request_for("(z + 1) (x^2 + y^2 + z^2 - 0.25) = 0", 64, 64);
    request.settings.shadows = true;
    Framebuffer shadowed(64, 64);
    render_frame(request.scene, request.camera, request.settings, shadowed);
    for (const bool fits : {true, false}) {
        pace.budget_ms = fits ? 1e9 : 1e-9;
        Watched watched(pace);
        watched.pictures_until(watched.job.submit(request));
        const auto moving = watched.pictures_to(watched.job.submit(request)).back();
        EXPECT_EQ(moving.frame->color == shadowed.color, fits);
        EXPECT_EQ(moving.frame->width == 64, fits);
    }
}

TEST(RenderJob, DrawsPicturesOfOnePixel) {
    Watched watched;
    const auto number = watched.job.submit(request_for("z = 0", 1, 1));
    EXPECT_EQ(watched.pictures_until(number).back().frame->color.size(), 1U);
}

TEST(RenderJob, TheNewestRequestWins) {
    Watched watched;
    std::uint64_t last = 0;
    for (int i = 0; i < 30; ++i) {
        const auto number = watched.job.submit(request_for("x^2 + y^2 + z^2 = 1", 200, 200 + i));
        EXPECT_GT(number, last);
        last = number;
    }
    const auto pictures = watched.pictures_until(last);
    EXPECT_EQ(pictures.back().frame->height, 229);
    EXPECT_FALSE(watched.job.busy());
    EXPECT_FALSE(watched.job.take());
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        EXPECT_GE(pictures[i].request, pictures[i - 1].request);
    }
}

TEST(RenderJob, ANewRequestEndsTheOneBeforeSoon) {
    Watched watched;
    RenderRequest slow = request_for("(x^2+y^2+z^2-1)*(x*y*z-0.1)*(x+y+z-2)^3", 4000, 4000);
    slow.settings.stop.value = 22;
    watched.job.submit(slow);
    EXPECT_TRUE(watched.job.busy());
    const auto number = watched.job.submit(request_for("z = 0", 16, 16));
    const auto pictures = watched.pictures_until(number);
    EXPECT_EQ(pictures.back().frame->width, 16);
}

/// A surface that no tracer comes to an end of: a first picture comes, and one can leave.
TEST(RenderJob, ShowsSomethingOfWhatHasNoEnd) {
    RenderRequest request = request_for("x^2 + y^2 + z^2 = 1", 400, 400);
    request.scene.surfaces[0].kernel = hooked(request.scene.surfaces[0].kernel, [] {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    });
    RenderPace pace = whole_pictures();
    pace.first_within = std::chrono::milliseconds(40);
    Watched watched(pace);
    const auto number = watched.job.submit(request);
    const auto first = watched.pictures_to(number);
    EXPECT_FALSE(first.back().complete);
    EXPECT_GT(count_certificates(*first.back().frame).undecided, 0U);
    const auto next = watched.job.submit(request_for("z = 0", 16, 16));
    EXPECT_EQ(watched.pictures_until(next).back().frame->width, 16);
}

// Passes by returning: a job that does not end runs into the time limit of ctest, and what it still
// touches sanitizers tell.
TEST(RenderJob, EndsWhileItDraws) {
    for (int i = 0; i < 5; ++i) {
        Watched watched;
        watched.job.submit(request_for("x^4 + y^4 + z^4 = 1", 3000, 3000));
        if (i % 2 == 1) watched.job.submit(request_for("x*y*z = 0.1", 3000, 3000));
    }
}

}  // namespace
}  // namespace zeroset::test::render_job_test
