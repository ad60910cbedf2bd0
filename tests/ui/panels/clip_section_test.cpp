#include "tests/ui/panels.hpp"
#include "ui/model/section_axis.hpp"
#include "ui/panels/sections.hpp"

#include <GLFW/glfw3.h>

#include <cmath>
#include <limits>
#include <vector>

// Tests of the section with clip box, sphere and section planes, and of the projection's key.

namespace zeroset::ui::clip_section_test {
namespace {

class ClipSection : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.view_open = false;
        state_.edited.layout.clip_open = true;
    }

    /// Scrolls a row of the section into sight and clicks it; `along` is 0 left, 1 right.
    void click_row(int row, float along) {
        const glm::vec2 at = section_line("clip", row);
        click_at({section("clip")->Pos.x + along * section("clip")->WorkRect.GetWidth(), at.y});
        OffscreenWindow::point({-1, -1}, false);
        draw();
    }
    void type(const char* text) {
        OffscreenWindow::type(text);
        draw_frame();
        press(GLFW_KEY_ENTER);
        draw();
    }
    std::vector<Section>& sections() { return state_.edited.document.region.sections; }
};

TEST_P(ClipSection, ShowsASphereAndHidesItAgain) {
    click_row(1, 0.02F);
    ASSERT_TRUE(state_.edited.document.region.ball);
    EXPECT_EQ(*state_.edited.document.region.ball, (Ball{{0, 0, 0}, 2.0}));
    click_row(2, 0.5F);
    OffscreenWindow::hold_ctrl(true);
    press(GLFW_KEY_A);
    OffscreenWindow::hold_ctrl(false);
    type("1.25");
    ASSERT_TRUE(state_.edited.document.region.ball);
    EXPECT_EQ(state_.edited.document.region.ball->radius, 1.25);
    click_row(1, 0.02F);
    EXPECT_FALSE(state_.edited.document.region.ball);
}

TEST_P(ClipSection, ReadsADecimalCommaAndThenFramesTheBox) {
    click_row(0, 0.5F);
    press_with_ctrl(GLFW_KEY_A);
    OffscreenWindow::type("3,5");
    draw();
    EXPECT_EQ(state_.edited.document.clip, Box::cube(3.5));
    EXPECT_FALSE(state_.wishes.frame_box) << "it is still typed";
    press(GLFW_KEY_ENTER);
    EXPECT_TRUE(state_.wishes.frame_box);
}

TEST_P(ClipSection, LeavesTheBoxWhereNoNumberIsTyped) {
    for (const char* text : {"3,5,1", "abc", "-1", "0", "nan", "1e300"}) {
        click_row(0, 0.5F);
        press_with_ctrl(GLFW_KEY_A);
        type(text);
        // The text typed on the way to "1e300" is a number: 1.
        const double half = 0.5 * state_.edited.document.clip.size();
        EXPECT_TRUE(half == 2.0 || half == 1.0 || half == 3.0 || half == 3.5) << text << half;
        EXPECT_NE(half, 35.0);
        state_.edited.document.clip = Box();
    }
}

TEST_P(ClipSection, ShowsWhereABoxLiesThatIsNotAboutTheOrigin) {
    const float plain = clip_section_height(state_.edited);
    state_.edited.document.clip = {.lo = {7.9, -1.1, -1.1}, .hi = {10.1, 1.1, 1.1}};
    EXPECT_GT(clip_section_height(state_.edited), plain);
    EXPECT_FALSE(state_.edited.layout.edges_open);
    click_row(1, 0.3F);
    press_with_ctrl(GLFW_KEY_A);
    type("8,5");
    EXPECT_EQ(state_.edited.document.clip.lo.x, 8.5);
    EXPECT_EQ(state_.edited.document.clip.hi.x, 10.1);
}

TEST_P(ClipSection, AddsAndTurnsAndRemovesASection) {
    click_row(2, 0.5F);
    ASSERT_EQ(sections().size(), 1U);
    // The default eye is on the side x > 0.
    EXPECT_EQ(sections()[0], (Section{{1, 0, 0}, 0.0, true}));
    click_row(3, 0.02F);
    ASSERT_EQ(sections().size(), 1U);
    EXPECT_EQ(sections()[0].normal, glm::dvec3(-1, 0, 0));
    click_row(3, 0.98F);
    EXPECT_TRUE(sections().empty());
}

TEST_P(ClipSection, ChoosesLevelAndWindowOfValuesInSections) {
    Section section = make_section({0, 0, 1}, 0.25);
    section.values = true;
    sections() = {section};
    state_.shown.picture.usual_section_range = ValueRange{100, 300};
    const float plain = clip_section_height(state_.edited);
    sections()[0].values = false;
    EXPECT_LT(clip_section_height(state_.edited), plain);
    sections()[0].values = true;
    SectionChoice& choice = state_.edited.document.section_values;
    draw();
    EXPECT_EQ(choice, SectionChoice()) << "drawing changes nothing";
    click_row(6, 0.3F);
    ASSERT_TRUE(choice.range);
    const double level = 0.5 * (choice.range->lo + choice.range->hi);
    EXPECT_GT(level, 100.0);
    EXPECT_LT(level, 200.0);
    EXPECT_NEAR(choice.range->hi - choice.range->lo, 200.0, 1e-9) << "the window stays";
    click_row(7, 0.3F);
    EXPECT_LT(choice.range->hi - choice.range->lo, 200.0);
    EXPECT_NEAR(0.5 * (choice.range->lo + choice.range->hi), level, 1e-9) << "the level stays";
    click_row(5, 0.98F);
    EXPECT_FALSE(choice.range) << "by itself again";
}

TEST_P(ClipSection, HoldsAsManySectionsAsThereMayBe) {
    for (std::size_t i = 0; i < max_sections; ++i)
        click_row(2 + 2 * static_cast<int>(i), 0.5F);
    EXPECT_EQ(sections().size(), max_sections);
    EXPECT_EQ(axis_of(sections()[0]), 0);
    EXPECT_EQ(axis_of(sections()[1]), 1);
    EXPECT_EQ(axis_of(sections()[2]), 2);
}

TEST_P(ClipSection, FitsWithAllItCanHold) {
    state_.edited.layout.edges_open = true;
    state_.edited.document.region.ball = Ball{{-123.456, 0, 1e-7}, 0.001};
    sections() = {make_section({1, 2, 3}, 0.5), make_section({0, -1, 0}, -1e6)};
    draw();
    EXPECT_EQ(sections()[0], make_section({1, 2, 3}, 0.5)) << "drawing changes nothing";
    EXPECT_EQ(sections()[1].offset, -1e6);
}

TEST_P(ClipSection, CutsAwayWhatIsBeforeThePointLookedAt) {
    const Document& document = state_.edited.document;
    const glm::dvec3 eye = document.camera->eye;
    for (int axis = 0; axis <= 3; ++axis) {
        const Section section = section_across(axis, document);
        EXPECT_EQ(axis_of(section), axis);
        EXPECT_GT(glm::dot(section.normal, eye), section.offset);
        EXPECT_NEAR(glm::dot(section.normal, document.camera->look_at), section.offset, 1e-12);
    }
}

TEST_P(ClipSection, SwitchesTheProjectionByItsKey) {
    draw();
    const Camera before = *state_.edited.document.camera;
    OffscreenWindow::type("5");
    draw();
    EXPECT_EQ(state_.edited.document.camera->projection, Projection::Orthographic);
    EXPECT_EQ(state_.edited.document.camera->eye, before.eye);
    OffscreenWindow::type("5");
    draw();
    EXPECT_EQ(*state_.edited.document.camera, before);
}

TEST(Resized, KeepsTheCentreAndTheShape) {
    const Box box = resized({{0, 0, 0}, {2, 4, 8}}, 1.0);
    EXPECT_EQ(box.lo, glm::dvec3(0.75, 1.5, 3));
    EXPECT_EQ(box.hi, glm::dvec3(1.25, 2.5, 5));
}

INSTANTIATE_TEST_SUITE_P(Looks, ClipSection, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::clip_section_test
