#include "app/cli/progress.hpp"

#include "app/cli/render_picture.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

// Tests of long commands: the progress they show and the message when their time budget is over.

namespace zeroset::test::progress_test {
namespace {

using Clock = std::chrono::steady_clock;

TEST(Progress, IsALineOfOneWidth) {
    const auto line = [](double done) {
        return progress_line(Progress::Stage::Drawing, done, 3.0);
    };
    EXPECT_EQ(line(0.0), "drawing  [                              ]    0 %");
    EXPECT_EQ(line(0.5), "drawing  [###############               ]   50 %");
    EXPECT_EQ(line(1.0), "drawing  [##############################]  100 %");
    EXPECT_EQ(line(1.5), line(1.0));
    EXPECT_EQ(progress_line(Progress::Stage::Compiling, -1.0, 2.6), "compiling, 3 s");
}

TEST(Progress, CountsPartsOfAStage) {
    Progress progress;
    EXPECT_EQ(progress.stage(), Progress::Stage::Compiling);
    EXPECT_LT(progress.done(), 0.0);
    progress.enter(Progress::Stage::Drawing, 8);
    progress.add(2);
    EXPECT_EQ(progress.done(), 0.25);
    progress.enter(Progress::Stage::Fitting);
    EXPECT_LT(progress.done(), 0.0);
}

TEST(FinishUntil, WaitsForTheEnd) {
    const Progress progress;
    bool done = false;
    EXPECT_TRUE(finish_until(Clock::now() + std::chrono::hours(1), progress, [&] { done = true; }));
    EXPECT_TRUE(done);
}

TEST(FinishUntil, LeavesWhatTakesTooLong) {
    const Progress progress;
    const auto goes_on = std::make_shared<std::atomic<bool>>(true);
    const auto ended = std::make_shared<std::atomic<bool>>(false);
    EXPECT_FALSE(
        finish_until(Clock::now() + std::chrono::milliseconds(20), progress, [goes_on, ended] {
            while (*goes_on)
                std::this_thread::yield();
            *ended = true;
        }));
    EXPECT_FALSE(*ended);
    *goes_on = false;
    while (!*ended)
        std::this_thread::yield();
}

TEST(BudgetNote, SaysHowManyPixelsAreLeft) {
    RenderedPicture picture;
    picture.plan.size = {.width = 20, .height = 10};
    EXPECT_EQ(budget_note(picture), "");
    picture.in_time = false;
    picture.plan.budget_s = 2.5;
    picture.timing.counters.cut_pixels = 7;
    EXPECT_EQ(budget_note(picture),
              "the budget of 2.5 s is spent: 7 of 200 pixels are left undecided; --budget SECONDS "
              "gives more");
    picture.stage_at_end = Progress::Stage::Compiling;
    EXPECT_EQ(budget_note(picture).substr(0, 43), "the budget of 2.5 s is spent on compiling: ");
}

TEST(RenderPicture, EndsWithItsBudget) {
    RenderPlan plan;
    ReadDocument read = read_document_text("x^2 + y^2 + z^2 = 1");
    plan.document = std::move(read.document);
    plan.document.clip = Box::cube(2);
    plan.rows = std::move(*read.rows);
    plan.size = {32, 24};
    plan.budget_s = 60.0;
    const auto now = Clock::now();
    const RenderOutcome whole = render_picture(plan, now);
    EXPECT_FALSE(whole.stuck);
    EXPECT_TRUE(whole.picture->in_time);
    EXPECT_GT(count_certificates(whole.picture->frame).certified, 20U);
    // The deadline passed before the start, by more than the few milliseconds of its tolerance.
    const RenderOutcome late = render_picture(plan, now - std::chrono::milliseconds(60'100));
    EXPECT_FALSE(late.picture->in_time);
    const CertificateCounts counts = count_certificates(late.picture->frame);
    EXPECT_EQ(counts.undecided, 32U * 24U);
    EXPECT_EQ(late.picture->timing.counters.cut_pixels, 32U * 24U);
    EXPECT_EQ(late.picture->request.formula == nullptr, late.stuck);
}

}  // namespace
}  // namespace zeroset::test::progress_test
