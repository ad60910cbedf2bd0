#include "ui/picture/point_layer.hpp"

#include "engine/view/pixel_ray.hpp"
#include "tests/ui/panels.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/screen_areas.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <memory>

// Tests of points under the pointer, whose coordinates are sliders.

namespace zeroset::ui {
namespace {

class PointLayer : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.folded = true;
        show(HUGE_VALF);
        set_point({0.5, 0.0, 0.25});
        state_.edited.document.parameters["a"].value = 0.5;
        state_.edited.document.parameters["b"].value = 0.25;
        draw_frame();
    }
    void set_point(const glm::dvec3& at) {
        state_.shown.points = {
            {.row = 1, .name = "P", .at = at, .radius = 0.05, .sliders = {"a", "", "b"}}};
    }
    /// Shows a picture whose pixels all have this depth.
    void show(float distance) {
        Framebuffer frame = disc();
        std::ranges::fill(frame.color, 0xFF808080U);
        std::ranges::fill(frame.depth, distance);
        state_.shown.picture.frame = std::make_shared<const Framebuffer>(frame);
    }
    [[nodiscard]] glm::vec2 at(const glm::dvec3& point) const {
        const auto seen = place_in_view(ViewFrame(state_.shown.picture.camera), point);
        const ImVec2 place = viewport_area(state_.edited.layout).at(seen->place);
        return {place.x, place.y};
    }
    /// Presses at one point of the window and moves to another in steps; the button stays down.
    void drag(const glm::vec2& from, const glm::vec2& to) {
        OffscreenWindow::point(from, false);
        draw_frame();
        for (const float part : {0.0F, 0.4F, 1.0F}) {
            OffscreenWindow::point(from + part * (to - from), true);
            draw_frame();
        }
    }
    void let_go(const glm::vec2& at) {
        OffscreenWindow::point(at, false);
        draw_frame();
        draw_frame();
    }
    [[nodiscard]] double a() { return state_.edited.document.parameters["a"].value; }
    [[nodiscard]] double b() { return state_.edited.document.parameters["b"].value; }

    const glm::dvec3 start_{0.5, 0.0, 0.25};
};

TEST_P(PointLayer, MovesTheSlidersOfAPoint) {
    const Camera before = *state_.edited.document.camera;
    const ViewFrame view(before);
    const glm::dvec3 to = start_ + 0.4 * view.right + 0.3 * view.up;
    drag(at(start_), at(to));
    EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_Hand);
    const double wide = view.pixel_at_look(static_cast<int>(picture_height(state_.edited.layout)));
    EXPECT_NEAR(a(), to.x, 2 * wide);
    EXPECT_NEAR(b(), to.z, 2 * wide);
    EXPECT_TRUE(state_.input.point_drag);
    let_go(at(to));
    EXPECT_FALSE(state_.input.point_drag);
    EXPECT_EQ(*state_.edited.document.camera, before) << "the view stays";
    EXPECT_FALSE(state_.wishes.click);
}

TEST_P(PointLayer, LeavesAllElseToTheView) {
    const Camera before = *state_.edited.document.camera;
    const glm::vec2 beside = at(start_) + glm::vec2(0.0F, static_cast<float>(px(60)));
    drag(beside, beside + glm::vec2(static_cast<float>(px(30)), 0.0F));
    let_go(beside);
    EXPECT_EQ(a(), 0.5);
    EXPECT_NE(state_.edited.document.camera->eye, before.eye) << "orbits";
}

TEST_P(PointLayer, DoesNotTakePointsThatAreHiddenOrStandStill) {
    show(0.5F);  // a surface just before the eye
    drag(at(start_), at({1.0, 0.0, 0.5}));
    let_go(at(start_));
    EXPECT_EQ(a(), 0.5);
    show(HUGE_VALF);
    state_.shown.points.front().sliders = {};
    drag(at(start_), at({1.0, 0.0, 0.5}));
    EXPECT_FALSE(state_.input.point_drag);
    let_go(at(start_));
}

TEST_P(PointLayer, GivesADragUpByEsc) {
    drag(at(start_), at({1.0, 0.0, 0.5}));
    EXPECT_NE(a(), 0.5);
    press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(a(), 0.5);
    EXPECT_EQ(b(), 0.25);
    OffscreenWindow::point(at({0.0, 0.0, 0.0}), true);
    draw_frame();
    EXPECT_EQ(a(), 0.5) << "until it is let go";
    let_go(at(start_));
    EXPECT_FALSE(state_.input.point_drag);
}

TEST_P(PointLayer, WritesTheNameBesideThePoint) {
    const Framebuffer named = draw();
    state_.shown.points.front().name.clear();
    const Framebuffer unnamed = draw();
    EXPECT_NE(named.color, unnamed.color);
}

INSTANTIATE_TEST_SUITE_P(Looks, PointLayer,
                         testing::Values(Look{Theme::Dark, {min_width, min_height, 1.0F}},
                                         Look{Theme::Light, {min_width, min_height, 2.0F}}),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui
