// Tests of the selected marker's move to a special point, as the window follows it.

#include "app/desktop/marker_snap.hpp"

#include "tests/support/picture_of.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>

namespace zeroset::test::marker_snap_test {
namespace {

constexpr auto patience = std::chrono::minutes(10);

class MarkerSnaps : public testing::Test {
protected:
    /// Selects a marker at the point and wishes that it snaps.
    void wish(const glm::dvec3& at) {
        state_.edited.document.markers = {{4, {9, 9, 9}}, {5, at, "P"}};
        state_.edited.selected_marker = 5;
        state_.wishes.snap_marker = true;
    }
    /// Follows until the search has ended; true if the outcome was told.
    bool follow(const std::optional<PictureRequest>& picture,
                const std::optional<PictureRequest>& later) {
        bool told = snap_.follow(state_, picture);
        const auto end = std::chrono::steady_clock::now() + patience;
        while (snap_.runs() && std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            told = snap_.follow(state_, later);
        }
        EXPECT_FALSE(snap_.runs());
        return told;
    }
    [[nodiscard]] const glm::dvec3& place() const { return state_.edited.document.markers[1].at; }

    ui::UiState state_;
    MarkerSnap snap_;
};

TEST_F(MarkerSnaps, MoveItToTheNearestOfAllSurfaces) {
    const PictureRequest picture = picture_of("x^2 + y^2 + z^2 = 1; (x - 1)^2 + y^2 = (z - 1)^2");
    wish({0.9, 0.1, 0.9});
    const unsigned gesture = state_.input.gesture;
    ASSERT_TRUE(follow(picture, picture));
    EXPECT_LE(glm::distance(place(), glm::dvec3(1, 0, 1)), 1e-9);
    EXPECT_EQ(state_.edited.document.markers[0].at, glm::dvec3(9, 9, 9));
    EXPECT_GT(state_.input.gesture, gesture) << "a step of undo of its own";
    EXPECT_TRUE(
        state_.shown.status.done.starts_with("P is now at a singular point (numerical: |f| = "))
        << state_.shown.status.done;
    wish({0.1, -0.1, 0.9});
    ASSERT_TRUE(follow(picture, picture));
    EXPECT_LE(glm::distance(place(), glm::dvec3(0, 0, 1)), 1e-9);
    EXPECT_TRUE(state_.shown.status.done.starts_with("P is now at a local maximum of z ("))
        << state_.shown.status.done;
}

TEST_F(MarkerSnaps, LeaveItWhereThereIsNothing) {
    const PictureRequest picture = picture_of("z = x y");
    wish({0.5, 0.5, 0.25});
    ASSERT_TRUE(follow(picture, picture));
    EXPECT_EQ(place(), glm::dvec3(0.5, 0.5, 0.25));
    EXPECT_EQ(state_.shown.status.done,
              "no singular point and no maximum or minimum of z found near P");
}

TEST_F(MarkerSnaps, AreDroppedWhereTheSurfaceIsAnotherByThen) {
    const PictureRequest picture = picture_of("x^2 + y^2 + z^2 = 1");
    PictureRequest other = picture;
    other.clip = Box::cube(3);
    for (const auto& later : {std::optional(other), std::optional<PictureRequest>()}) {
        wish({0.1, 0.1, 0.9});
        EXPECT_FALSE(follow(picture, later));
        EXPECT_EQ(place(), glm::dvec3(0.1, 0.1, 0.9));
    }
    wish({0.1, 0.1, 0.9});
    state_.edited.selected_marker = 0;
    EXPECT_FALSE(follow(picture, picture)) << "none is selected";
    EXPECT_FALSE(state_.wishes.snap_marker);
}

TEST(SnapText, NamesTheDirection) {
    const SpecialPoint bottom{.at = {0, 0, 0}, .kind = SpecialKind::Bottom, .f = 0.0, .slope = 2.0};
    const Marker marker{.number = 3, .at = {0, 0, 0}};
    EXPECT_EQ(snap_text(marker, {0, 0, 2}, bottom),
              "3 is now at a local minimum of z (numerical: |f| = 0, |grad f| = 2)");
    EXPECT_NE(snap_text(marker, {-1, 0, 0}, bottom).find("of -x "), std::string::npos);
    EXPECT_NE(snap_text(marker, {1, 1, 0}, bottom).find("of the height "), std::string::npos);
}

}  // namespace
}  // namespace zeroset::test::marker_snap_test
