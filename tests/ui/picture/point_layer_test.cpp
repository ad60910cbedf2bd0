#include "engine/view/pixel_ray.hpp"
#include "tests/ui/picture_layers.hpp"
#include "ui/picture/layers.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/screen_areas.hpp"

#include <GLFW/glfw3.h>

// Tests of points under the pointer, whose coordinates are sliders.

namespace zeroset::ui::point_layer_test {
namespace {

class PointLayer : public PictureLayers {
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
}  // namespace zeroset::ui::point_layer_test
