// Tests of questions and of the file browser.

#include "tests/support/test_folder.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui::dialogs_test {
namespace {

namespace fs = std::filesystem;

class DialogPanels : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        fs::create_directories(folder_ / "sub");
        std::ofstream(folder_ / "a.zeroset.json") << "{}";
        std::ofstream(folder_ / "other.txt") << "no document";
    }

    void ask() {
        state_.pages.dialogs.question =
            Question{"Save the changes?", {"Save", "Don't save", "Cancel"}, {}};
        draw();
    }
    [[nodiscard]] std::optional<std::size_t> answer() const {
        return state_.pages.dialogs.question->chosen;
    }
    void choose(FileChoice::Purpose purpose) {
        state_.pages.dialogs.file = FileChoice{};
        state_.pages.dialogs.file->purpose = purpose;
        state_.pages.dialogs.file->folder = folder_.path().string();
        draw();
    }
    FileChoice& file() { return *state_.pages.dialogs.file; }
    void type(const std::string& text) {
        OffscreenWindow::type(text);
        draw_frame();
    }

    test::TestFolder folder_;
};

TEST_P(DialogPanels, AnswerByKey) {
    for (const auto& [key, expected] : {std::pair(GLFW_KEY_ENTER, 0U), {GLFW_KEY_ESCAPE, 2U}}) {
        ask();
        EXPECT_FALSE(answer());
        press(key);
        EXPECT_EQ(answer(), expected) << key;
    }
    for (const auto& [letter, expected] : {std::pair("d", 1U), {"D", 1U}, {"c", 2U}}) {
        ask();
        type(letter);
        EXPECT_EQ(answer(), expected) << letter;
    }
    for (const char* letter : {"x", "s", " "}) {
        ask();
        type(letter);
        EXPECT_FALSE(answer()) << "no letter saves: " << letter;
    }
    ask();
    press(GLFW_KEY_SPACE);
    EXPECT_FALSE(answer());
}

TEST_P(DialogPanels, AnswerWhatTheArrowsMark) {
    for (const auto& [keys, expected] : {std::pair(std::vector<int>{GLFW_KEY_RIGHT}, 1U),
                                         {{GLFW_KEY_RIGHT, GLFW_KEY_RIGHT}, 2U},
                                         {{GLFW_KEY_LEFT}, 2U},
                                         {{GLFW_KEY_TAB}, 1U},
                                         {{GLFW_KEY_RIGHT, GLFW_KEY_LEFT}, 0U},
                                         {{GLFW_KEY_RIGHT, GLFW_KEY_RIGHT, GLFW_KEY_RIGHT}, 0U}}) {
        ask();
        for (const int key : keys)
            press(key);
        EXPECT_FALSE(answer());
        press(GLFW_KEY_ENTER);
        EXPECT_EQ(answer(), expected);
    }
    ask();
    press(GLFW_KEY_RIGHT);
    press(GLFW_KEY_SPACE);
    EXPECT_EQ(answer(), 1U);
}

TEST_P(DialogPanels, AnswerByMouse) {
    ask();
    const ImRect place = panel("##question").Rect();
    click_at({place.Min.x + static_cast<float>(px(30)), place.Max.y - static_cast<float>(px(26))});
    EXPECT_EQ(answer(), 0U);
}

TEST_P(DialogPanels, KeepTheRowsFromTheKeyboard) {
    state_.wishes.focus = RowFocus{1, RowFocus::Caret::End};
    draw();
    ask();
    type("y");
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(state_.edited.document.statements.size(), 1U);
    EXPECT_EQ(state_.edited.document.statements[0].text, "x^2 + y^2 + z^2 = 1");
}

TEST_P(DialogPanels, CanGiveUpTheDesktopsDialog) {
    choose(FileChoice::Purpose::Save);
    file().elsewhere = true;
    draw();
    type("y");
    EXPECT_FALSE(file().finished);
    press(GLFW_KEY_ESCAPE);
    EXPECT_TRUE(file().finished);
    EXPECT_EQ(file().path, "");
}

TEST_P(DialogPanels, OpenTheFileThatIsTyped) {
    choose(FileChoice::Purpose::Open);
    type("a.zeroset.json");
    press(GLFW_KEY_ENTER);
    ASSERT_TRUE(file().finished);
    EXPECT_EQ(file().path, (folder_ / "a.zeroset.json").string());
}

TEST_P(DialogPanels, OpenTheFileThatIsDoubleClicked) {
    choose(FileChoice::Purpose::Open);
    const ImVec2 list = child("##files/##entries")->Pos;
    // The second line of the list, below the folder.
    const glm::vec2 line(list.x + static_cast<float>(px(60)), list.y + static_cast<float>(px(44)));
    click_at(line);
    EXPECT_EQ(file().name, "a.zeroset.json");
    click_at(line);
    ASSERT_TRUE(file().finished);
    EXPECT_EQ(file().path, (folder_ / "a.zeroset.json").string());
}

TEST_P(DialogPanels, GoIntoFoldersAndOut) {
    choose(FileChoice::Purpose::Open);
    const ImVec2 list = child("##files/##entries")->Pos;
    click_at({list.x + static_cast<float>(px(60)), list.y + static_cast<float>(px(12))});
    EXPECT_EQ(file().folder, (folder_ / "sub").string());
    draw();
    const ImVec2 window = panel("##files").Pos;
    click_at({window.x + static_cast<float>(px(27)), window.y + static_cast<float>(px(47))});
    EXPECT_EQ(file().folder, folder_.path().string());
}

TEST_P(DialogPanels, SaveUnderANameWithItsEnding) {
    choose(FileChoice::Purpose::Save);
    type("new");
    press(GLFW_KEY_ENTER);
    ASSERT_TRUE(file().finished);
    EXPECT_EQ(file().path, (folder_ / "new.zeroset.json").string());
}

TEST_P(DialogPanels, AskBeforeAFileIsReplaced) {
    choose(FileChoice::Purpose::Save);
    type("a");
    press(GLFW_KEY_ENTER);
    EXPECT_FALSE(file().finished);
    EXPECT_TRUE(file().asks_replace);
    draw();
    press(GLFW_KEY_ENTER);
    ASSERT_TRUE(file().finished);
    EXPECT_EQ(file().path, (folder_ / "a.zeroset.json").string());
}

TEST_P(DialogPanels, GiveUpAtEscape) {
    for (const auto purpose : {FileChoice::Purpose::Open, FileChoice::Purpose::Save}) {
        choose(purpose);
        press(GLFW_KEY_ESCAPE);
        EXPECT_TRUE(file().finished);
        EXPECT_EQ(file().path, "");
    }
}

INSTANTIATE_TEST_SUITE_P(Looks, DialogPanels, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::dialogs_test
