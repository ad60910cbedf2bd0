// Tests of the section of markers: the typed point, labels, and the wish to snap.

#include "tests/ui/panels.hpp"
#include "ui/actions/action_functions.hpp"
#include "ui/actions/actions.hpp"
#include "ui/actions/view_moves.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>

namespace zeroset::ui::marker_section_test {
namespace {

class MarkerSections : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        OffscreenWindow::point({-1, -1}, false);
    }
    /// Draws until the layout has settled; in a small window sections are out of sight.
    void settle() {
        for (int i = 0; i <= 2 * frames_to_settle; ++i)
            draw_frame();
    }
    /// Types a point into the field and presses Enter.
    void go(const char* typed) {
        action_named("Go to a point...").run(state_);
        settle();
        OffscreenWindow::type(typed);
        settle();
        press(GLFW_KEY_ENTER);
        settle();
    }
};

TEST_P(MarkerSections, TakeATypedPoint) {
    state_.edited.layout.folded = true;
    go("0.5, -1, 0.25");
    EXPECT_FALSE(state_.edited.layout.folded);
    ASSERT_EQ(state_.edited.document.markers.size(), 1U);
    EXPECT_EQ(state_.edited.document.markers[0].at, glm::dvec3(0.5, -1, 0.25));
    EXPECT_EQ(state_.edited.selected_marker, 1);
    EXPECT_TRUE(state_.pages.point.typed.empty());
    ASSERT_TRUE(state_.input.move || state_.edited.document.camera);
    for (int frame = 0; frame < 30; ++frame)
        draw_frame();
    EXPECT_EQ(state_.edited.document.camera->look_at, glm::dvec3(0.5, -1, 0.25)) << "looked at";
}

TEST_P(MarkerSections, SayWhatIsNoPoint) {
    go("1, 2");
    EXPECT_TRUE(state_.edited.document.markers.empty());
    EXPECT_TRUE(state_.pages.point.wrong);
    EXPECT_EQ(state_.pages.point.typed, "1, 2") << "stays, to be mended";
}

TEST_P(MarkerSections, GoToAMarkerThatIsThere) {
    state_.edited.document.markers = {{7, {1, 2, 3}}};
    go_to(state_, {1, 2, 3});
    EXPECT_EQ(state_.edited.document.markers.size(), 1U);
    EXPECT_EQ(state_.edited.selected_marker, 7);
}

TEST_P(MarkerSections, SnapTheSelectedMarkerOnly) {
    state_.edited.layout.markers_open = true;
    state_.edited.document.markers = {{1, {0.5, 0.25, 0.75}, "P"}, {2, {-1.0, 0.0, 0.5}}};
    draw();
    OffscreenWindow::type("n");
    draw();
    EXPECT_FALSE(state_.wishes.snap_marker) << "none is selected";
    state_.edited.selected_marker = 1;
    draw();
    OffscreenWindow::type("n");
    draw();
    EXPECT_TRUE(state_.wishes.snap_marker);
}

INSTANTIATE_TEST_SUITE_P(Looks, MarkerSections, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::marker_section_test
