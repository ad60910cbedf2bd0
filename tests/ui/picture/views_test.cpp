// Tests of view changes by keys, by the axis gizmo and by a double click, and of the moves to new
// views.

#include "engine/view/camera.hpp"
#include "engine/view/navigation.hpp"
#include "tests/ui/panels.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/panels/panels.hpp"
#include "ui/picture/axis_gizmo.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/screen_areas.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace zeroset::ui::views_test {
namespace {

class Views : public Panels {
protected:
    /// Draws until the view rests; returns the number of frames.
    int finish_move() {
        constexpr int most = 100;
        int frames = 0;
        while (state_.input.move && frames < most) {
            draw_frame();
            ++frames;
        }
        EXPECT_FALSE(state_.input.move);
        return frames;
    }
    void type(const std::string& keys) {
        OffscreenWindow::type(keys);
        draw_frame();
        finish_move();
    }
    [[nodiscard]] const Camera& camera() const { return *state_.edited.document.camera; }
    [[nodiscard]] glm::dvec3 towards_eye() const {
        return glm::normalize(camera().eye - camera().look_at);
    }
    void expect_from(const glm::dvec3& direction, const std::string& what) const {
        EXPECT_LT(glm::distance(towards_eye(), direction), 1e-9) << what;
    }
    [[nodiscard]] GizmoBall ball(int axis, bool positive) const {
        const auto balls = gizmo_balls(camera());
        return *std::ranges::find_if(balls, [=](const GizmoBall& each) {
            return each.axis == axis && each.positive == positive;
        });
    }
    [[nodiscard]] bool has_gizmo() const { return GetParam().window.width > 700; }
    static void leave() { OffscreenWindow::point({-1, -1}, false); }
};

TEST_P(Views, FromTheAxesByKeys) {
    draw();
    const Camera before = camera();
    for (const auto& [key, direction] : {std::pair{"1", glm::dvec3(0, -1, 0)},
                                         {"3", {1, 0, 0}},
                                         {"7", {0, 0, 1}},
                                         {"9", {0, 0, -1}},
                                         {"0", glm::normalize(glm::dvec3(1, -1, 1))}}) {
        type(key);
        expect_from(direction, key);
        EXPECT_EQ(camera().look_at, before.look_at);
        EXPECT_NEAR(ViewFrame(camera()).look_distance, ViewFrame(before).look_distance, 1e-9);
    }
    for (const auto& [key, direction] : {std::pair{GLFW_KEY_1, glm::dvec3(0, 1, 0)},
                                         {GLFW_KEY_3, {-1, 0, 0}},
                                         {GLFW_KEY_7, {0, 0, -1}}}) {
        press_with_ctrl(key);
        finish_move();
        expect_from(direction, "Ctrl+" + std::to_string(key));
    }
}

TEST_P(Views, AreLeftAloneWhileARowIsTypedIn) {
    state_.wishes.focus = RowFocus{1, RowFocus::Caret::End};
    draw();
    draw();
    const Camera before = camera();
    type("1");
    EXPECT_EQ(camera(), before);
    EXPECT_TRUE(state_.edited.document.statements[0].text.ends_with("1"));
}

TEST_P(Views, ChangeSmoothlyWithinAFifthOfASecond) {
    draw();
    const Camera before = camera();
    OffscreenWindow::type("1");
    draw_frame();
    draw_frame();
    draw_frame();
    EXPECT_NE(camera(), before);
    EXPECT_LT(glm::dot(towards_eye(), glm::dvec3(0, -1, 0)), 0.9999) << "at once";
    EXPECT_LE(finish_move(), 12) << "frames of a sixtieth of a second";
    const Camera after = camera();
    draw_frame();
    EXPECT_EQ(camera(), after);
}

TEST_P(Views, StopMovingWhenSomethingElseChangesTheCamera) {
    draw();
    OffscreenWindow::type("1");
    draw_frame();
    draw_frame();
    const Camera other = default_camera(Box::cube(7));
    state_.edited.document.camera = other;
    draw_frame();
    EXPECT_FALSE(state_.input.move);
    draw_frame();
    EXPECT_EQ(camera(), other);
}

TEST_P(Views, TurnInStepsAndZoomByKeys) {
    draw();
    const Camera before = camera();
    type("6");
    const Camera right = camera();
    EXPECT_GT(glm::dot(right.eye - before.eye, ViewFrame(before).right), 0) << "to the right";
    EXPECT_NEAR(right.eye.z, before.eye.z, 1e-9);
    type("4");
    EXPECT_LT(glm::distance(camera().eye, before.eye), 1e-9);
    type("8");
    EXPECT_GT(camera().eye.z, before.eye.z);
    type("+");
    EXPECT_LT(ViewFrame(camera()).look_distance, ViewFrame(before).look_distance);
}

TEST_P(Views, FollowTheBallsOfTheGizmo) {
    draw();
    if (!has_gizmo()) return;
    click_at(gizmo_place(ball(0, true)));
    finish_move();
    expect_from({1, 0, 0}, "+x");
    // The ball is now in the middle, in front of the ball of the other end.
    click_at(gizmo_place(ball(0, true)));
    finish_move();
    expect_from({-1, 0, 0}, "-x");
    click_at(gizmo_place(ball(2, true)));
    finish_move();
    expect_from({0, 0, 1}, "+z");
    EXPECT_EQ(state_.edited.document.up, glm::dvec3(0, 0, 1));
    click_at(gizmo_place(ball(1, false)));
    finish_move();
    expect_from({0, -1, 0}, "-y");
    EXPECT_LT(glm::distance(ViewFrame(camera()).up, glm::dvec3(0, 0, 1)), 1e-9);
}

TEST_P(Views, TurnWhereTheGizmoIsDragged) {
    draw();
    if (!has_gizmo()) return;
    const Camera before = camera();
    const glm::vec2 start = gizmo_place({});
    OffscreenWindow::point(start, false);
    draw_frame();
    for (int step = 0; step <= 20; ++step) {
        OffscreenWindow::point(start + glm::vec2(static_cast<float>(step * px(2)), 0.0F), true);
        draw_frame();
    }
    leave();
    draw_frame();
    finish_move();
    EXPECT_NEAR(camera().eye.z, before.eye.z, 1e-9);
    EXPECT_GT(glm::distance(camera().eye, before.eye), 0.1);
    EXPECT_LT(glm::dot(camera().eye - before.eye, ViewFrame(before).right), 0);
}

TEST_P(Views, ZoomWhereTheWheelTurnsOverTheGizmo) {
    draw();
    if (!has_gizmo()) return;
    const auto turn_at = [this](const glm::vec2& at) {
        const Camera before = camera();
        OffscreenWindow::point(at, false);
        draw_frame();
        OffscreenWindow::turn_wheel(1.0F);
        draw_frame();
        leave();
        draw_frame();
        return ViewFrame(camera()).look_distance / ViewFrame(before).look_distance;
    };
    const glm::vec2 beside = gizmo_place({}) - glm::vec2(static_cast<float>(px(200)), 0.0F);
    const double usual = turn_at(beside);
    EXPECT_LT(usual, 0.9);
    EXPECT_NEAR(turn_at(gizmo_place({})), usual, 1e-9);
}

TEST_P(Views, SortTheBallsByTheirDepth) {
    draw();
    const auto balls = gizmo_balls(camera());
    for (std::size_t i = 1; i < balls.size(); ++i)
        EXPECT_LE(balls[i - 1].nearness, balls[i].nearness);
    EXPECT_NEAR(glm::length(ball(2, true).at), std::sqrt(1.0 - std::pow(ball(2, true).nearness, 2)),
                1e-12);
    EXPECT_GT(ball(2, true).at.y, 0) << "z is up";
}

TEST_P(Views, CentreWhereThePictureIsDoubleClicked) {
    state_.shown.picture.frame = std::make_shared<const Framebuffer>(disc());
    state_.shown.picture.camera = camera();
    draw();
    const float left = side_panel_width(state_.edited.layout);
    const glm::vec2 middle(0.5F * (left + static_cast<float>(px(GetParam().window.width))),
                           0.5F * picture_height(state_.edited.layout));
    const glm::vec2 at =
        middle + 0.1F * picture_height(state_.edited.layout) * glm::vec2(1.0F, -0.5F);
    const auto point = surface_under(state_.shown.picture, {0.1, 0.05});
    ASSERT_TRUE(point);
    const ViewFrame before(camera());
    click_at(at);
    click_at(at);
    finish_move();
    EXPECT_LT(glm::distance(camera().look_at, *point), 0.01 * before.look_distance);
    EXPECT_LT(glm::distance(ViewFrame(camera()).forward, before.forward), 1e-9);
}

TEST_P(Views, TurnFreelyOrAboutWhatIsUp) {
    draw();
    type("t");
    EXPECT_TRUE(state_.edited.document.trackball);
    const float left = side_panel_width(state_.edited.layout);
    const glm::vec2 edge(left + static_cast<float>(px(30)),
                         0.5F * picture_height(state_.edited.layout));
    OffscreenWindow::point(edge, false);
    draw_frame();
    for (const float down : {0.0F, 30.0F, 60.0F, 90.0F}) {
        OffscreenWindow::point(
            edge + glm::vec2(0.0F, static_cast<float>(px(static_cast<int>(down)))), true);
        draw_frame();
    }
    leave();
    draw_frame();
    EXPECT_GT(std::abs(ViewFrame(camera()).right.z), 0.05) << "beside the ball it rolls";
    type("t");
    EXPECT_FALSE(state_.edited.document.trackball);
    EXPECT_NEAR(ViewFrame(camera()).right.z, 0.0, 1e-9) << "upright again";
    EXPECT_EQ(camera().up, state_.edited.document.up);
}

TEST_P(Views, StandOnTheAxisThatIsUp) {
    draw();
    set_up(state_, {0, 1, 0});
    finish_move();
    EXPECT_EQ(camera().up, glm::dvec3(0, 1, 0));
    EXPECT_NEAR(ViewFrame(camera()).right.y, 0.0, 1e-9);
    type("1");
    expect_from({0, 0, 1}, "the front where y is up");
}

TEST_P(Views, HaveSwitchesForAxesBoxAndGrid) {
    draw();
    for (const char* key : {"a", "b", "g"})
        type(key);
    EXPECT_TRUE(state_.edited.document.axes && state_.edited.document.clip_box &&
                state_.edited.document.grid);
    state_.shown.picture.frame = std::make_shared<const Framebuffer>(disc());
    state_.shown.picture.camera = camera();
    const Framebuffer with = draw();
    for (const char* key : {"a", "b", "g"})
        type(key);
    const Framebuffer without = draw();
    std::size_t changed = 0;
    for (std::size_t i = 0; i < with.color.size(); ++i)
        changed += with.color[i] != without.color[i] ? 1U : 0U;
    EXPECT_GT(changed, with.color.size() / 200);
    EXPECT_LT(changed, with.color.size() / 4);
}

TEST_P(Views, AskForTheSurfacesExtent) {
    draw();
    type("f");
    EXPECT_TRUE(state_.wishes.frame_surfaces);
    state_.wishes.frame_surfaces = false;
    press(GLFW_KEY_HOME);
    EXPECT_TRUE(state_.wishes.frame_surfaces);
}

INSTANTIATE_TEST_SUITE_P(Looks, Views, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::views_test
