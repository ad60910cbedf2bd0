// What one window leaves to the next.

#include "app/preferences.hpp"

#include "ui/ui_state.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace zeroset::test {
namespace {

namespace fs = std::filesystem;

class PreferencesTest : public testing::Test {
protected:
    void SetUp() override {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = fs::path(testing::TempDir()) / ("zeroset_preferences_" + test) / "deep";
        fs::remove_all(folder_.parent_path());
    }
    void TearDown() override { fs::remove_all(folder_.parent_path()); }
    void write(const std::string& text) const {
        fs::create_directories(folder_);
        std::ofstream(folder_ / "window.json") << text;
    }

    fs::path folder_;
};

TEST_F(PreferencesTest, AreTheSameAfterAFile) {
    Preferences preferences;
    EXPECT_EQ(load_preferences(folder_), preferences) << "as usual without a file";
    preferences.layout = {.panel_em = 31.5F,
                          .folded = true,
                          .view_open = false,
                          .space_open = true,
                          .clip_open = true,
                          .edges_open = true};
    preferences.theme = ui::Theme::Light;
    preferences.last_theme = ui::Theme::Light;
    preferences.window = {1000, 700, true};
    save_preferences(folder_, preferences);
    EXPECT_EQ(load_preferences(folder_), preferences);
    preferences.theme.reset();
    save_preferences(folder_, preferences);
    EXPECT_EQ(load_preferences(folder_), preferences) << "the desktop's theme";
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(PreferencesTest, AreAsUsualWhereTheFileMakesNoSense) {
    for (const char* text : {"", "{", "[1, 2]", "null", "\"x\""}) {
        write(text);
        EXPECT_EQ(load_preferences(folder_), Preferences()) << text;
    }
    write(R"({"theme": "blue", "width": 10, "height": "tall", "panel_em": -3, "folded": 1,
              "maximized": true, "unknown": {}})");
    Preferences expected;
    expected.window.maximized = true;
    EXPECT_EQ(load_preferences(folder_), expected);
}

}  // namespace
}  // namespace zeroset::test
