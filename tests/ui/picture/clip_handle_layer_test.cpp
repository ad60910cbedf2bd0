#include "engine/annotate/axes.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/ui/picture_layers.hpp"
#include "ui/picture/layers.hpp"
#include "ui/picture/viewport.hpp"
#include "ui/style/screen_areas.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>

// Tests of the clip region's handles under the pointer.

namespace zeroset::ui::clip_handle_layer_test {
namespace {

class ClipHandleLayer : public PictureLayers {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.clip_open = true;
        state_.edited.layout.folded = true;
        show(HUGE_VALF);
        draw_frame();
    }
    [[nodiscard]] std::uint32_t red() const {
        return (GetParam().theme == Theme::Dark ? axes_on_dark : axes_on_light).axes[0];
    }
    static std::uint32_t pixel(const Framebuffer& frame, const glm::vec2& at) {
        return frame.color[frame.index(static_cast<int>(at.x), static_cast<int>(at.y))];
    }

    const Box whole_{};
    /// Handle of a face that nothing else covers in any window.
    const glm::dvec3 face_{2, 0, 0};
};

TEST_P(ClipHandleLayer, MovesAFace) {
    const Camera before = *state_.edited.document.camera;
    drag(at(face_), at({1.25, 0, 0}));
    EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_ResizeEW);
    // Width of the window's pixels at the point looked at.
    const double wide =
        ViewFrame(before).pixel_at_look(static_cast<int>(picture_height(state_.edited.layout)));
    EXPECT_NEAR(state_.edited.document.clip.hi.x, 1.25, 2 * wide);
    EXPECT_TRUE(state_.input.handle_drag);
    let_go(at({1.25, 0, 0}));
    EXPECT_FALSE(state_.input.handle_drag);
    EXPECT_EQ(state_.edited.document.clip.lo, whole_.lo);
    EXPECT_EQ(state_.edited.document.clip.hi.y, 2);
    EXPECT_EQ(*state_.edited.document.camera, before);
    EXPECT_FALSE(state_.wishes.click);
}

TEST_P(ClipHandleLayer, MovesTheSphereAndTurnsASection) {
    state_.edited.document.region.ball = Ball{{0, 0, 0}, 0.75};
    state_.edited.document.region.sections = {Section{{-1, 0, 0}, 0.5, true}};
    const auto grip = [this](HandlePart part) {
        const auto all = shown_handles(state_, picture_height(state_.edited.layout));
        return at(std::ranges::find(all, HandleId{part, 0}, &Handle::id)->at);
    };
    const auto move = [&](HandlePart part, const glm::vec2& way) {
        drag(grip(part), grip(part) + way);
        let_go(grip(part));
    };
    const glm::vec2 way(static_cast<float>(px(20)), static_cast<float>(px(-10)));
    move(HandlePart::BallCentre, way);
    EXPECT_GT(glm::length(state_.edited.document.region.ball->centre), 0.05);
    EXPECT_EQ(state_.edited.document.region.ball->radius, 0.75);
    move(HandlePart::BallRadius, way);
    EXPECT_GT(state_.edited.document.region.ball->radius, 0.76);
    move(HandlePart::SectionTilt, way);
    EXPECT_NE(state_.edited.document.region.sections[0].normal, glm::dvec3(-1, 0, 0));
    EXPECT_EQ(state_.edited.document.clip, whole_);
}

TEST_P(ClipHandleLayer, LeavesAllElseToTheView) {
    const Camera before = *state_.edited.document.camera;
    const glm::vec2 beside = at(face_) + glm::vec2(0.0F, static_cast<float>(px(40)));
    drag(beside, beside + glm::vec2(static_cast<float>(px(30)), 0.0F));
    let_go(beside);
    EXPECT_EQ(state_.edited.document.clip, whole_);
    EXPECT_NE(state_.edited.document.camera->eye, before.eye) << "orbits";
    for (bool Layout::* const gone : {&Layout::handles, &Layout::clip_open}) {
        state_.edited.layout.*gone = false;
        drag(at(face_), at({1, 0, 0}));
        let_go(at(face_));
        EXPECT_EQ(state_.edited.document.clip, whole_);
        state_.edited.layout.*gone = true;
    }
}

TEST_P(ClipHandleLayer, GivesADragUpByEsc) {
    drag(at(face_), at({1, 0, 0}));
    EXPECT_NE(state_.edited.document.clip, whole_);
    press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(state_.edited.document.clip, whole_);
    OffscreenWindow::point(at({0.5, 0, 0}), true);
    draw_frame();
    EXPECT_EQ(state_.edited.document.clip, whole_) << "until it is let go";
    let_go(at(face_));
    EXPECT_FALSE(state_.input.handle_drag);
}

TEST_P(ClipHandleLayer, LetsGoOfWhatSomethingElseChanges) {
    drag(at(face_), at({1, 0, 0}));
    const Box other = Box::cube(7);
    state_.edited.document.clip = other;
    OffscreenWindow::point(at({0.5, 0, 0}), true);
    draw_frame();
    EXPECT_EQ(state_.edited.document.clip, other);
}

TEST_P(ClipHandleLayer, ChangesNothingByAPressAlone) {
    state_.edited.document.clip.hi.x = 1.23456789012;
    draw();
    const Box before = state_.edited.document.clip;
    click_at(at({1.23456789012, 0, 0}) + glm::vec2(2.0F, 1.0F));
    EXPECT_EQ(state_.edited.document.clip, before);
    EXPECT_FALSE(state_.wishes.click);
}

TEST_P(ClipHandleLayer, IsFaintBehindSurfacesAndReachableThere) {
    const glm::vec2 middle = at(face_);
    EXPECT_EQ(pixel(draw(), middle), red());
    show(0.5F);
    const std::uint32_t faint = pixel(draw(), middle);
    EXPECT_FALSE(is_like(faint, red(), exact));
    drag(middle, at({1, 0, 0}));
    let_go(at({1, 0, 0}));
    EXPECT_LT(state_.edited.document.clip.hi.x, 1.5);
}

TEST_P(ClipHandleLayer, LightsUpUnderThePointerWithItsValue) {
    const Framebuffer before = draw();
    OffscreenWindow::point(at(face_), false);
    const Framebuffer after = draw();
    int changed = 0;
    for (std::size_t i = 0; i < before.color.size(); ++i)
        changed += before.color[i] != after.color[i] ? 1 : 0;
    EXPECT_GT(changed, px(10) * px(10)) << "a larger square, the face's outline, a tag";
    EXPECT_EQ(pixel(after, at(face_)), red());
    EXPECT_FALSE(state_.input.pointer) << "nothing is said of the surface below";
}

TEST_P(ClipHandleLayer, IsSwitchedByItsKey) {
    OffscreenWindow::type("h");
    draw();
    EXPECT_FALSE(has_clip_handles(state_.edited.layout));
    EXPECT_TRUE(shown_handles(state_, picture_height(state_.edited.layout)).empty());
    state_.edited.layout.clip_open = false;
    OffscreenWindow::type("h");
    draw();
    EXPECT_TRUE(state_.edited.layout.clip_open && state_.edited.layout.handles);
    EXPECT_FALSE(shown_handles(state_, picture_height(state_.edited.layout)).empty());
}

INSTANTIATE_TEST_SUITE_P(Looks, ClipHandleLayer,
                         testing::Values(Look{Theme::Dark, {min_width, min_height, 1.0F}},
                                         Look{Theme::Light, {min_width, min_height, 2.0F}}),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::clip_handle_layer_test
