// Tests of the help: opening, closing and filtering.

#include "engine/image/framebuffer.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <string>

namespace zeroset::ui::help_test {
namespace {

class Help : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.shown.language_help = {
            {"Statements", {{"x^2 + y^2 = 1", "a surface: where both sides are equal"}}},
            {"Functions", {}}};
        for (int i = 0; i < 40; ++i) {
            state_.shown.language_help[1].entries.push_back(
                {"f" + std::to_string(i) + "(x)", "the function number " + std::to_string(i)});
        }
        state_.shown.language_help[1].entries.push_back({"sqrt(x)", "the Square root"});
    }

    static bool is_shown() {
        const ImGuiWindow* help = ImGui::FindWindowByName("Help###help");
        return help != nullptr && help->WasActive;
    }
    static float content_height() { return child("Help###help/##language")->ContentSize.y; }
};

TEST_P(Help, OpensAndClosesWithF1) {
    draw();
    EXPECT_FALSE(is_shown());
    press(GLFW_KEY_F1);
    EXPECT_TRUE(is_shown());
    press(GLFW_KEY_F1);
    EXPECT_FALSE(is_shown());
}

TEST_P(Help, OpensAtItsButtonAndClosesAtItsCross) {
    draw();
    const float edge = side_panel_width(state_.edited.layout);
    click_at({edge - static_cast<float>(px(52)), static_cast<float>(px(22))});
    draw();
    ASSERT_TRUE(is_shown());
    const ImRect title = panel("Help###help").TitleBarRect();
    click_at({title.Max.x - 0.5F * title.GetHeight(), title.GetCenter().y});
    draw();
    EXPECT_FALSE(is_shown());
}

TEST_P(Help, LeavesTheKeyboardToTheFormula) {
    set_rows(state_, {""});
    state_.wishes.focus = RowFocus{1, RowFocus::Caret::All};
    // The notice of an empty document may cover the picture that draw() looks for.
    for (int i = 0; i <= frames_to_settle; ++i)
        draw_frame();
    press(GLFW_KEY_F1);
    OffscreenWindow::type("x + y");
    draw_frame();
    EXPECT_TRUE(is_shown());
    EXPECT_EQ(state_.edited.document.statements[0].text, "x + y");
    press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(is_shown());
    OffscreenWindow::type(" + z");
    draw_frame();
    EXPECT_EQ(state_.edited.document.statements[0].text, "x + y + z")
        << "Escape closed the help and nothing else";
}

TEST_P(Help, FitsItsWindow) {
    state_.pages.help.open = true;
    for (int i = 0; i < frames_to_settle; ++i) {
        draw_frame();
    }
    const ImGuiWindow& help = panel("Help###help");
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    EXPECT_GE(help.Pos.x, 0.0F);
    EXPECT_GE(help.Pos.y, 0.0F);
    EXPECT_LE(help.Rect().Max.x, window.x);
    EXPECT_LE(help.Rect().Max.y, window.y);
    EXPECT_GT(help.Size.y, static_cast<float>(px(280)));
    const ImGuiWindow* list = child("Help###help/##language");
    EXPECT_LE(list->ContentSize.x, list->WorkRect.GetWidth() + 1.0F);
}

TEST_P(Help, ShowsOnlyWhatTheFilterFinds) {
    state_.pages.help.open = true;
    draw_frame();
    draw_frame();
    draw_frame();
    const float all = content_height();
    EXPECT_GT(all, static_cast<float>(px(41 * 14)));
    const auto found = [this](const char* filter) {
        state_.pages.help.filter = filter;
        for (int i = 0; i <= frames_to_settle; ++i) {
            draw_frame();
        }
        return content_height();
    };
    const float one = found("square ROOT");
    EXPECT_LT(one, static_cast<float>(px(60)));
    EXPECT_GT(one, static_cast<float>(px(30)));
    EXPECT_LT(found("no such thing"), one);
    EXPECT_GT(found("functions"), found("number 3"));
}

TEST_P(Help, ForgetsItsFilterWhenItCloses) {
    state_.pages.help.open = true;
    state_.pages.help.filter = "root";
    draw_frame();
    EXPECT_EQ(state_.pages.help.filter, "root");
    press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(state_.pages.help.filter, "");
}

INSTANTIATE_TEST_SUITE_P(Looks, Help, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::help_test
