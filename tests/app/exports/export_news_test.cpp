#include "app/exports/export_news.hpp"

#include "app/exports/export_run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace zeroset::export_news_test {
namespace {

Framebuffer painted(int width, int height, std::uint32_t color) {
    Framebuffer frame(width, height);
    std::ranges::fill(frame.color, color);
    return frame;
}

std::optional<ExportOutcome> outcome_of(ExportRun& run) {
    for (int i = 0; i < 2000; ++i) {
        if (auto outcome = run.take()) return outcome;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::nullopt;
}

TEST(ExportNews, TellHowFarItIs) {
    ExportNews news([] {});
    news.enter("making code");
    EXPECT_EQ(news.share(), 0.0);
    EXPECT_EQ(news.text(), "making code");
    news.enter("drawing", 200);
    news.add(50);
    EXPECT_EQ(news.share(), 0.25);
    EXPECT_EQ(news.text().substr(0, 4), "25 %");
    news.enter("drawing", 180, "frame");
    news.add(12);
    EXPECT_EQ(news.text().substr(0, 15), "frame 12 of 180");
}

TEST(ExportNews, TellTheRateAndTheTimeLeft) {
    ExportNews::Clock::time_point now;
    ExportNews news([] {}, [&now] { return now; });
    news.enter("drawing", 40, "frame");
    now += std::chrono::milliseconds(200);
    news.add(2);
    EXPECT_EQ(news.text(), "frame 2 of 40");
    now += std::chrono::milliseconds(300);
    EXPECT_EQ(news.text(), "frame 2 of 40, 4 a second, 0:10 left");
}

TEST(ExportNews, WriteTimesAsClocksDo) {
    EXPECT_EQ(clock_text(0.2), "0:01");
    EXPECT_EQ(clock_text(20.0), "0:20");
    EXPECT_EQ(clock_text(3599.0), "59:59");
    EXPECT_EQ(clock_text(3723.0), "1:02:03");
}

TEST(ExportNews, KeepTheBandsOfAPicture) {
    int woken = 0;
    ExportNews news([&] { ++woken; });
    EXPECT_FALSE(news.take_picture());
    news.show(painted(8, 2, 0xFF0000FF), 0, 4);
    news.show(painted(8, 2, 0xFF00FF00), 2, 4);
    const auto picture = news.take_picture();
    ASSERT_TRUE(picture);
    EXPECT_EQ(woken, 2);
    EXPECT_EQ(picture->width, 8);
    EXPECT_EQ(picture->height, 4);
    EXPECT_EQ(picture->pixels.front(), 0xFF0000FF);
    EXPECT_EQ(picture->pixels.back(), 0xFF00FF00);
    EXPECT_FALSE(news.take_picture());
}

TEST(ExportNews, MakePicturesSmaller) {
    ExportNews news([] {});
    news.show(painted(1920, 1080, 0xFFFFFFFF), 0, 1080);
    const auto picture = news.take_picture();
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 480);
    EXPECT_EQ(picture->height, 270);
}

TEST(ExportRun, GivesTheOutcomeOnce) {
    ExportRun run([] {});
    run.start("a.png", [](ExportNews&) { return ExportOutcome("saved a.png"); });
    EXPECT_TRUE(run.runs());
    const auto outcome = outcome_of(run);
    ASSERT_TRUE(outcome && *outcome);
    EXPECT_EQ(**outcome, "saved a.png");
    EXPECT_FALSE(run.runs());
    EXPECT_FALSE(run.take());
}

TEST(ExportRun, TellsThatItWasStopped) {
    ExportRun run([] {});
    std::atomic<bool> begun = false;
    run.start("a.mp4", [&](ExportNews& news) -> ExportOutcome {
        begun = true;
        while (!news.cancel)
            std::this_thread::yield();
        return std::unexpected("it was cancelled");
    });
    while (!begun)
        std::this_thread::yield();
    run.cancel();
    const auto outcome = outcome_of(run);
    ASSERT_TRUE(outcome && *outcome);
    EXPECT_EQ(**outcome, "saving a.mp4 was stopped");
}

}  // namespace
}  // namespace zeroset::export_news_test
