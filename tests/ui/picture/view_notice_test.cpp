// Tests of what is said over a picture that shows nothing.

#include "ui/picture/view_notice.hpp"

#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <string>

namespace zeroset::ui::view_notice_test {
namespace {

class ViewNotice : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.folded = true;  // room also in the smallest window
    }

    /// The notice may cover the picture that draw() looks for.
    void settle() {
        for (int i = 0; i <= frames_to_settle; ++i)
            draw_frame();
    }
    static const ImGuiWindow* notice() { return child("##notice"); }
    void show_nothing() {
        state_.shown.figures.counts = {};
        settle();
    }
    /// Clicks at the notice's line, counted from its bottom, in parts of its width.
    void click_line(float from_bottom, float across) {
        const ImRect place = notice()->Rect();
        const float line = ImGui::GetFrameHeightWithSpacing();
        click_at({place.Min.x + across * place.GetWidth(),
                  place.Max.y - ImGui::GetStyle().WindowPadding.y - (from_bottom + 0.4F) * line});
    }
};

TEST_P(ViewNotice, IsNotThereOverASurface) {
    settle();
    EXPECT_EQ(notice(), nullptr);
    EXPECT_EQ(emptiness_of(state_), Emptiness::None);
}

TEST_P(ViewNotice, OffersTheWaysToASurfaceOutOfView) {
    show_nothing();
    ASSERT_NE(notice(), nullptr);
    EXPECT_EQ(emptiness_of(state_), Emptiness::OutOfView);
    click_line(0.0F, 0.25F);
    EXPECT_TRUE(state_.wishes.frame_surfaces);
    state_.edited.document.clip = {.lo = glm::dvec3(7.9), .hi = glm::dvec3(10.1)};
    settle();
    click_line(0.0F, 0.75F);
    EXPECT_EQ(state_.edited.document.clip, Box());
    EXPECT_TRUE(state_.wishes.frame_box);
}

TEST_P(ViewNotice, FitsBesideThePanelOfASmallWindow) {
    state_.edited.layout.folded = false;
    state_.edited.document.region.ball = Ball{.centre = {0, 0, 0}, .radius = 0.1};
    show_nothing();
    ASSERT_NE(notice(), nullptr);
    EXPECT_GE(notice()->Pos.x, side_panel_width(state_.edited.layout));
    EXPECT_GT(notice()->Pos.y, 0.0F);
}

TEST_P(ViewNotice, OffersToRemoveTheCuts) {
    state_.edited.document.region.ball = Ball{.centre = {0, 0, 0}, .radius = 0.1};
    show_nothing();
    click_line(0.0F, 0.5F);
    EXPECT_TRUE(state_.edited.document.region.is_whole());
}

TEST_P(ViewNotice, TellsOfHiddenSurfaces) {
    state_.edited.document.statements[0].visible = false;
    show_nothing();
    EXPECT_EQ(emptiness_of(state_), Emptiness::AllHidden);
    click_line(0.0F, 0.5F);
    EXPECT_TRUE(state_.edited.document.statements[0].visible);
}

TEST_P(ViewNotice, SaysNothingWhileNoRowCanBeRead) {
    state_.shown.reading.surface_rows = {0};  // an empty stand-in
    show_nothing();
    EXPECT_EQ(emptiness_of(state_), Emptiness::None);
}

TEST_P(ViewNotice, WaitsForThePictureOfTheText) {
    state_.shown.figures.hidden = true;
    show_nothing();
    EXPECT_EQ(notice(), nullptr) << "the figures are of another text";
    state_.shown.figures = {};
    settle();
    EXPECT_EQ(notice(), nullptr) << "there is no full picture yet";
}

TEST_P(ViewNotice, HasThreeExamplesForAnEmptyDocument) {
    set_rows(state_, {""});
    show_nothing();
    ASSERT_NE(notice(), nullptr);
    EXPECT_EQ(emptiness_of(state_), Emptiness::NoText);
    EXPECT_EQ(examples().size(), 3U);
    click_line(1.0F, 0.5F);
    EXPECT_EQ(state_.edited.document.statements[0].text, examples().back().text);
    ASSERT_TRUE(state_.wishes.focus || state_.input.typing_row == 1);
}

TEST_P(ViewNotice, LeadsToTheGallery) {
    set_rows(state_, {" \n"});
    show_nothing();
    click_line(0.0F, 0.5F);
    EXPECT_TRUE(state_.pages.gallery.open);
}

TEST_P(ViewNotice, HasExamplesThatCanBeRead) {
    for (const Example& example : examples()) {
        set_rows(state_, {example.text});
        EXPECT_FALSE(state_.shown.reading.reports.at(1).error) << example.text;
        EXPECT_EQ(state_.shown.reading.surface_rows.size(), 1U) << example.text;
    }
}

TEST_P(ViewNotice, GoesOnWithARecentFile) {
    set_rows(state_, {""});
    settle();
    const float without = child("##notice")->Size.y;
    state_.shown.document.recent = {"/home/ann/torus.zeroset.json"};
    settle();
    EXPECT_GT(child("##notice")->Size.y, without);
    const ImRect notice = child("##notice")->Rect();
    click_at({notice.GetCenter().x, notice.Max.y - static_cast<float>(px(20))});
    EXPECT_EQ(state_.wishes.open_path, "/home/ann/torus.zeroset.json");
}

TEST_P(ViewNotice, SaysWhatFramingFound) {
    settle();
    EXPECT_EQ(child("##news"), nullptr);
    state_.shown.status.framed = "framed the whole surface: clip box x 7.9 to 10.1";
    settle();
    ASSERT_NE(child("##news"), nullptr);
    EXPECT_GE(child("##news")->Pos.x, side_panel_width(state_.edited.layout));
}

TEST_P(ViewNotice, ShowsASavedFile) {
    state_.shown.status.done = "saved a.png";
    settle();
    const ImRect without = child("##news")->Rect();
    click_at({without.GetCenter().x, without.Max.y - static_cast<float>(px(14))});
    EXPECT_FALSE(state_.wishes.show_file);
    state_.shown.status.saved = "/home/ann/a.png";
    settle();
    const ImRect with = child("##news")->Rect();
    EXPECT_GT(with.GetHeight(), without.GetHeight());
    click_at({with.Min.x + static_cast<float>(px(24)), with.Max.y - static_cast<float>(px(20))});
    EXPECT_EQ(state_.wishes.show_file, "/home/ann/a.png");
}

INSTANTIATE_TEST_SUITE_P(Looks, ViewNotice, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::view_notice_test
