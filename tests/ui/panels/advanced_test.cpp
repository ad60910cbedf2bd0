// The section Advanced, and two tracers side by side.

#include "tests/ui/panels.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/inspection.hpp"
#include "ui/picture/layers.hpp"
#include "ui/style/screen_areas.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace zeroset::ui::advanced_test {
namespace {

class Advanced : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        if (window_ == nullptr) return;
        state_.shown.tracers = {{.name = "beams", .about = "by beams", .finds_jumps = true},
                                {.name = "newton", .about = "by steps", .finds_jumps = false}};
        state_.edited.layout.view_open = false;
        state_.edited.layout.advanced_open = true;
        frame_ = std::make_shared<Framebuffer>(disc());
        state_.shown.picture.frame = frame_;
    }
    /// The frame once the layout has settled; its picture may be of one colour.
    Framebuffer settled() {
        for (int i = 0; i <= frames_to_settle; ++i)
            draw_frame();
        return window_->pixels();
    }
    [[nodiscard]] Inspection& wanted() { return state_.edited.inspection; }
    [[nodiscard]] float divider_x() {
        const PictureArea area = viewport_area(state_.edited.layout);
        return area.lo.x + wanted().divider * (area.hi.x - area.lo.x);
    }
    /// Picks a line of the list that opens at a line of the section.
    void pick(int line, int entry) {
        const glm::vec2 list = section_line("advanced", line);
        click_at(list + glm::vec2(static_cast<float>(px(100)), 0.0F));
        draw_frame();
        const ImGuiWindow& popup = *ImGui::GetCurrentContext()->OpenPopupStack.back().Window;
        const float height = ImGui::GetTextLineHeightWithSpacing();
        click_at({popup.Pos.x + static_cast<float>(px(40)),
                  popup.Pos.y + ImGui::GetStyle().WindowPadding.y +
                      height * (static_cast<float>(entry) + 0.5F)});
    }
    /// A picture of the other tracer all in one colour.
    void show_other(std::uint32_t color) {
        auto frame = std::make_shared<Framebuffer>(disc());
        frame->color.assign(frame->color.size(), color);
        frame->depth.assign(frame->depth.size(), 1.0F);
        other_ = std::make_unique<Texture>();
        other_->upload(*frame, 0);
        OtherPicture& other = state_.shown.other;
        other.tracer = "newton";
        other.frame = frame;
        other.texture = other_->name();
        other.frame_ms = 12.5;
        other.complete = true;
        wanted().other = "newton";
    }

    std::shared_ptr<Framebuffer> frame_;
    std::unique_ptr<Texture> other_;
};

TEST_P(Advanced, ChoosesTheTracerAndAnotherOne) {
    pick(0, 1);
    EXPECT_EQ(wanted().tracer, "newton");
    EXPECT_FALSE(wanted().other);
    pick(1, 1);
    EXPECT_EQ(wanted().other, "beams");
    pick(1, 0);
    EXPECT_FALSE(wanted().other);
}

TEST_P(Advanced, ShowsTheOtherPictureBehindTheDivider) {
    constexpr std::uint32_t green = 0xFF20C040U;
    show_other(green);
    const Framebuffer frame = settled();
    const PictureArea area = viewport_area(state_.edited.layout);
    const auto x = static_cast<int>(divider_x());
    const int row = static_cast<int>(0.6F * (area.lo.y + area.hi.y));
    EXPECT_TRUE(is_like(frame.color[frame.index(x + px(20), row)], green, exact));
    EXPECT_FALSE(is_like(frame.color[frame.index(x - px(20), row)], green, exact));
}

TEST_P(Advanced, MovesTheDividerAndNotTheView) {
    show_other(0xFF20C040U);
    settled();
    const Camera before = *state_.edited.document.camera;
    const PictureArea area = viewport_area(state_.edited.layout);
    const float y = 0.7F * area.hi.y;
    const float x = divider_x();
    const float to = area.lo.x + 0.75F * (area.hi.x - area.lo.x);
    OffscreenWindow::point({x, y}, false);
    draw_frame();
    OffscreenWindow::point({x, y}, true);
    draw_frame();
    OffscreenWindow::point({to, y}, true);
    draw_frame();
    OffscreenWindow::point({to, y}, false);
    draw_frame();
    EXPECT_NEAR(wanted().divider, 0.75F, 0.01F);
    EXPECT_EQ(*state_.edited.document.camera, before);
}

TEST_P(Advanced, CoversThePictureByTheDifference) {
    constexpr std::uint32_t grey = 0xFF404040U;
    show_other(grey);
    wanted().difference = true;
    EXPECT_FALSE(has_divider(state_));
    const Framebuffer frame = settled();
    const PictureArea area = viewport_area(state_.edited.layout);
    const auto at = frame.index(static_cast<int>(area.lo.x) + px(30),
                                static_cast<int>(0.6F * (area.lo.y + area.hi.y)));
    EXPECT_TRUE(is_like(frame.color[at], grey, exact));
}

TEST_P(Advanced, IsNotInAPresentation) {
    show_other(0xFF20C040U);
    state_.edited.layout.presents = true;
    EXPECT_FALSE(has_divider(state_));
    const Framebuffer frame = settled();
    const auto at = frame.index(3 * frame.width / 4, 3 * frame.height / 4);
    EXPECT_FALSE(is_like(frame.color[at], 0xFF20C040U, exact));
}

TEST_P(Advanced, IsReachedByCommands) {
    action_named("Another tracer beside").run(state_);
    EXPECT_EQ(wanted().other, "newton");
    action_named("Difference of two tracers").run(state_);
    EXPECT_TRUE(wanted().difference);
    action_named("Difference of two tracers").run(state_);
    EXPECT_FALSE(wanted().difference);
    EXPECT_TRUE(wanted().other) << "the pictures stay side by side";
    action_named("Another tracer beside").run(state_);
    EXPECT_FALSE(wanted().other);
    EXPECT_FALSE(action_named("Difference of two tracers").is_on(state_));
    action_named("Cost of each pixel").run(state_);
    EXPECT_TRUE(wanted().costs);
}

INSTANTIATE_TEST_SUITE_P(Looks, Advanced, testing::ValuesIn(different_looks()),
                         [](const auto& instance) { return name_of(instance.param); });

}  // namespace
}  // namespace zeroset::ui::advanced_test
