// Tests of the settings that one window leaves to the next.

#include "app/desktop/preferences.hpp"

#include "tests/support/test_folder.hpp"
#include "ui/model/edited.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace zeroset::test::preferences_test {
namespace {

namespace fs = std::filesystem;

class PreferencesTest : public testing::Test {
protected:
    void write(const std::string& text) const {
        fs::create_directories(folder_);
        std::ofstream(folder_ / "window.json") << text;
    }

    TestFolder outer_;
    fs::path folder_ = outer_ / "deep";
};

TEST_F(PreferencesTest, AreTheSameAfterAFile) {
    Preferences preferences;
    EXPECT_EQ(load_preferences(folder_), preferences) << "as usual without a file";
    preferences.layout = {.panel_em = 31.5F,
                          .folded = true,
                          .view_open = false,
                          .camera_open = true,
                          .space_open = true,
                          .clip_open = true,
                          .details_open = true,
                          .advanced_open = true,
                          .edges_open = true,
                          .letters = 1.5F,
                          .axes = false,
                          .grid = false,
                          .smooth_edges = false,
                          .wheel = ui::WheelUse::Orbit};
    preferences.theme = ui::Theme::Light;
    preferences.last_theme = ui::Theme::Light;
    preferences.window = {1000, 700, true};
    preferences.tour_seen = true;
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
              "letters": 100, "axes": "on",
              "maximized": true, "wheel": "spin", "unknown": {}})");
    Preferences expected;
    expected.window.maximized = true;
    expected.tour_seen = true;
    EXPECT_EQ(load_preferences(folder_), expected);
}

TEST_F(PreferencesTest, HaveSeenTheTourWhereThereIsAFile) {
    EXPECT_FALSE(load_preferences(folder_).tour_seen) << "a first start";
    write(R"({"theme": "dark"})");
    EXPECT_TRUE(load_preferences(folder_).tour_seen) << "of a version without a tour";
    write(R"({"theme": "dark", "tour_seen": false})");
    EXPECT_FALSE(load_preferences(folder_).tour_seen) << "it was left open";
}

TEST_F(PreferencesTest, AreWrittenAMomentAfterTheyChange) {
    Preferences preferences;
    PreferencesFile file(folder_, preferences);
    EXPECT_EQ(file.due_s(0.0), std::nullopt);
    preferences.theme = ui::Theme::Light;
    file.follow(preferences, 10.0);
    EXPECT_EQ(file.due_s(10.25), 0.75);
    EXPECT_EQ(load_preferences(folder_).theme, std::nullopt);
    file.follow(preferences, 11.0);
    EXPECT_EQ(load_preferences(folder_).theme, ui::Theme::Light);
    EXPECT_EQ(file.due_s(11.0), std::nullopt);
}

TEST_F(PreferencesTest, AreWrittenWhileTheyGoOnChanging) {
    Preferences preferences;
    PreferencesFile file(folder_, preferences);
    for (int step = 0; step <= 10; ++step) {
        preferences.window.width = 600 + step;
        file.follow(preferences, 0.5 * step);
        EXPECT_EQ(load_preferences(folder_).window.width, step < 10 ? 1280 : 610);
    }
    preferences.window.width = 700;
    file.follow(preferences, 5.5);
    EXPECT_EQ(load_preferences(folder_).window.width, 610);
    file.finish();
    EXPECT_EQ(load_preferences(folder_).window.width, 700);
}

TEST_F(PreferencesTest, AreLeftAloneWhereNothingHasChanged) {
    const Preferences preferences;
    PreferencesFile file(folder_, preferences);
    file.follow(preferences, 100.0);
    file.finish();
    EXPECT_FALSE(fs::exists(folder_));
    PreferencesFile nowhere(std::nullopt, preferences);
    Preferences other;
    other.theme = ui::Theme::Light;
    nowhere.follow(other, 0.0);
    nowhere.finish();
    EXPECT_EQ(nowhere.due_s(1.0), std::nullopt);
}

}  // namespace
}  // namespace zeroset::test::preferences_test
