#include "pipeline/plans/frame_ranges.hpp"

#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// How many frames share a search for empty space.

namespace zeroset::test::frame_ranges_test {
namespace {

FilmPlan sweep_of(int frames) {
    FilmPlan plan;
    plan.frames = frames;
    plan.sweeps = {{"w", 0.0, 1.0}};
    return plan;
}

/// The film w = 0.5 + frame / 1000 of a sphere with the square of its radius w.
class Frames {
public:
    Frames(const FilmPlan& plan, FrameRangeChoice choice, const std::string& tracer = "beams")
        : ranges_(plan, choice, settings_at(tracer, 10), 256,
                  [](double moment) { return std::vector<double>{0.5 + moment / 1000}; }) {}

    /// Whether a frame was told where it is empty; it took so many evaluations.
    bool draw(int frame, std::uint64_t evaluations) {
        scene_.surfaces.front().open_space = nullptr;
        ranges_.add_to(scene_, frame);
        ranges_.learn(evaluations);
        return scene_.surfaces.front().open_space != nullptr;
    }
    [[nodiscard]] const FrameRangeWork& work() const { return ranges_.work(); }
    [[nodiscard]] const OpenSpace& space() const { return *scene_.surfaces.front().open_space; }

private:
    FrameRanges ranges_;
    Scene scene_ = scene_of("x^2 + y^2 + z^2 - w", Box::cube(2));
};

TEST(FrameRanges, SearchOnceForAsManyFramesAsIsAskedFor) {
    Frames frames(sweep_of(20), 8);
    for (int frame = 0; frame < 20; ++frame)
        EXPECT_TRUE(frames.draw(frame, 1'000'000)) << frame;
    EXPECT_EQ(frames.work().searches, 3);
    EXPECT_EQ(frames.work().frames, 20);
    EXPECT_EQ(frames.work().length, 8);
}

TEST(FrameRanges, GroupsDoNotDependOnTheFirstFrame) {
    Frames all(sweep_of(20), 8), part(sweep_of(20), 8);
    for (int frame = 0; frame <= 13; ++frame)
        all.draw(frame, 1'000'000);
    part.draw(13, 1'000'000);
    EXPECT_EQ(all.space().cells, part.space().cells);
}

TEST(FrameRanges, AreLargerTheMoreMomentsTheyHold) {
    FilmPlan blurred = sweep_of(200);
    blurred.blur = 8;
    blurred.shutter = 1.0;
    Frames one(sweep_of(200), 1), mixed(blurred, 1), many(sweep_of(200), 200);
    for (Frames* frames : {&one, &mixed, &many})
        frames->draw(100, 1'000'000);
    EXPECT_LE(one.space().cells.size(), mixed.space().cells.size());
    EXPECT_LT(mixed.space().cells.size(), many.space().cells.size());
}

TEST(FrameRanges, SearchOnceWhereOnlyTheCameraMoves) {
    FilmPlan plan = sweep_of(40);
    plan.sweeps.clear();
    plan.turn = CameraTurn{};
    Frames frames(plan, 3);
    for (int frame = 5; frame < 40; ++frame)
        EXPECT_TRUE(frames.draw(frame, 1'000'000));
    EXPECT_EQ(frames.work().searches, 1);
}

TEST(FrameRanges, AreLeftOutWhereTheyAreNotWantedOrNotKnown) {
    Frames off(sweep_of(20), 0), other(sweep_of(20), 8, "k-bisection");
    EXPECT_FALSE(off.draw(0, 1000));
    EXPECT_FALSE(other.draw(0, 1000));
    EXPECT_EQ(off.work().searches + other.work().searches, 0);
}

TEST(FrameRanges, AreUsedWhereMeasurementSaysThatTheyPay) {
    Frames pays(sweep_of(300), {});
    Frames costs(sweep_of(300), {});
    EXPECT_FALSE(pays.draw(0, 10'000'000)) << "the first frame is drawn without";
    costs.draw(0, 10'000'000);
    int frame = 1;
    for (; frame < 4; ++frame) {
        pays.draw(frame, 8'000'000);
        costs.draw(frame, 10'000'000);
    }
    for (; frame < 90; ++frame) {
        EXPECT_TRUE(pays.draw(frame, 8'000'000)) << frame;
        EXPECT_FALSE(costs.draw(frame, 10'000'000)) << frame;
    }
    EXPECT_EQ(costs.work().length, 0);
    EXPECT_GT(pays.work().length, 1) << "a longer range costs less and saves as much";
    for (; frame < 200; ++frame)
        costs.draw(frame, frame % 96 == 0 ? 10'000'000 : 5'000'000);
    EXPECT_GT(costs.work().length, 0) << "it is measured again";
}

}  // namespace
}  // namespace zeroset::test::frame_ranges_test
