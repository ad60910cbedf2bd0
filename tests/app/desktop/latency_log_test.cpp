#include "app/desktop/latency_log.hpp"

#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace zeroset::test::latency_log_test {
namespace {

using Kind = ui::InputEvent::Kind;
using std::chrono::milliseconds;

class LatencyLogTest : public testing::Test {
protected:
    /// Returns an event that arrived one second ago.
    static ui::InputEvent event(Kind kind) {
        return {kind, LatencyLog::Clock::now() - milliseconds(1000)};
    }
    void show(std::uint64_t request) {
        log_->picture_ready();
        log_->taken(request, 40, 30, false);
        log_->about_to_swap();
    }
    std::vector<nlohmann::json> lines() {
        log_.reset();
        std::ifstream file(path_);
        std::vector<nlohmann::json> found;
        for (std::string line; std::getline(file, line);)
            found.push_back(nlohmann::json::parse(line));
        return found;
    }

    TestFolder folder_;
    std::string path_ = (folder_ / "log.jsonl").string();
    std::unique_ptr<LatencyLog> log_ = std::make_unique<LatencyLog>(path_);
};

TEST_F(LatencyLogTest, TimesTheFirstPictureAfterAnEvent) {
    log_->input(event(Kind::Key));
    log_->input(event(Kind::Move));
    log_->submitted(7);
    log_->submitted(8);
    show(6);
    show(7);
    show(7);
    const auto found = lines();
    ASSERT_EQ(found.size(), 3U);
    EXPECT_FALSE(found[0].contains("event")) << "an older picture";
    EXPECT_EQ(found[1]["event"], "key");
    EXPECT_GE(found[1]["latency_ms"].get<double>(), 1000.0);
    EXPECT_NEAR(found[1]["latency_ms"].get<double>(),
                found[1]["to_submit_ms"].get<double>() + found[1]["to_picture_ms"].get<double>() +
                    found[1]["to_swap_ms"].get<double>(),
                1e-6);
    EXPECT_FALSE(found[2].contains("event")) << "a finer one";
    EXPECT_EQ(found[2]["width"], 40);
    EXPECT_EQ(found[2]["height"], 30);
}

TEST_F(LatencyLogTest, ForgetsAnEventThatChangesNothing) {
    log_->input(event(Kind::Move));
    log_->nothing_submitted();
    log_->input(event(Kind::Wheel));
    log_->submitted(3);
    log_->nothing_submitted();
    show(3);
    const auto found = lines();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0]["event"], "wheel");
}

TEST_F(LatencyLogTest, LeavesOpenGlOut) {
    log_->input({Kind::Button, LatencyLog::Clock::now()});
    {
        const LatencyLog::InOpenGl drawing(log_.get());
        const auto busy_until = LatencyLog::Clock::now() + milliseconds(30);
        while (LatencyLog::Clock::now() < busy_until) {
        }
    }
    log_->submitted(1);
    show(1);
    const auto found = lines();
    ASSERT_EQ(found.size(), 1U);
    const double total = found[0]["total_ms"].get<double>();
    EXPECT_GE(total, 30.0);
    EXPECT_LE(found[0]["latency_ms"].get<double>(), total - 30.0 + 1e-6);
}

}  // namespace
}  // namespace zeroset::test::latency_log_test
