// Tests of `zeroset dev ui-shot`, which draws the window into a file without a display.

#include "app/cli/report.hpp"
#include "app/dev/dev_commands.hpp"
#include "engine/export/png.hpp"
#include "engine/image/rgba_image.hpp"
#include "tests/support/test_folder.hpp"
#include "ui/window/offscreen_window.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace zeroset::ui_shot_test {
namespace {

namespace fs = std::filesystem;

/// Reads the width or height at `offset` of a PNG's header.
int png_side(const std::string& png, std::size_t offset) {
    int side = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        side = 256 * side + static_cast<unsigned char>(png.at(offset + i));
    }
    return side;
}

class UiShot : public testing::Test {
protected:
    void SetUp() override {
        command_.equation = "x^2 + y^2 + z^2 = 1";
        command_.size = "480x320";
        command_.output = (folder_ / "ui.png").string();
    }

    [[nodiscard]] std::string written() const {
        std::ifstream file(command_.output, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    /// Pixels above the status line; the line itself shows a time, which varies.
    [[nodiscard]] std::vector<std::uint32_t> above_status() const {
        const std::string png = written();
        auto image = image_from_png(std::as_bytes(std::span(png)));
        if (!image) return {};
        image->pixels.resize(static_cast<std::size_t>(image->width) * 280U);
        return image->pixels;
    }

    static bool can_draw() { return ui::make_offscreen_window({480, 320, 1.0F}).has_value(); }

    test::TestFolder folder_;
    UiShotCommand command_;
};

TEST_F(UiShot, WritesThePictureOfTheSizeTimesTheScale) {
    if (!can_draw()) GTEST_SKIP() << "neither EGL nor OSMesa makes a context here";
    command_.scale = "2";
    ASSERT_EQ(run_ui_shot(command_), exit_ok);
    const std::string png = written();
    EXPECT_EQ(png_side(png, 16), 960);
    EXPECT_EQ(png_side(png, 20), 640);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1)
        << "only the picture is left";
}

TEST_F(UiShot, ShowsAnErrorOfTheEquation) {
    if (!can_draw()) GTEST_SKIP() << "neither EGL nor OSMesa makes a context here";
    ASSERT_EQ(run_ui_shot(command_), exit_ok);
    const std::string good = written();
    command_.equation = "x^2 +";
    ASSERT_EQ(run_ui_shot(command_), exit_ok);
    EXPECT_NE(written(), good);
}

TEST_F(UiShot, RefusesWrongInput) {
    const auto refused = [this](std::string UiShotCommand::* option, const char* text) {
        UiShotCommand wrong = command_;
        wrong.*option = text;
        return run_ui_shot(wrong) == exit_wrong_input;
    };
    EXPECT_TRUE(refused(&UiShotCommand::size, "100x100"));
    EXPECT_TRUE(refused(&UiShotCommand::size, "wide"));
    EXPECT_TRUE(refused(&UiShotCommand::scale, "0"));
    EXPECT_TRUE(refused(&UiShotCommand::theme, "red"));
    EXPECT_TRUE(refused(&UiShotCommand::output, "ui.jpg"));
    EXPECT_TRUE(refused(&UiShotCommand::output, ""));
    EXPECT_TRUE(refused(&UiShotCommand::equation, "@no_such_surface"));
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(UiShot, SaysThatAFileCannotBeWritten) {
    command_.output = (folder_ / "missing/ui.png").string();
    EXPECT_EQ(run_ui_shot(command_), exit_run_time);
}

TEST_F(UiShot, TakesOsmesaWhereThereIsNoEgl) {
    ::setenv("ZEROSET_EGL", "libno_such_library.so", 1);
    EXPECT_FALSE(ui::make_egl_context({480, 320}));
    const bool osmesa = ui::make_osmesa_context({480, 320}).has_value();
    const int code = osmesa ? run_ui_shot(command_) : exit_ok;
    ::unsetenv("ZEROSET_EGL");
    if (!osmesa) GTEST_SKIP() << "OSMesa makes no context here";
    EXPECT_EQ(code, exit_ok);
    EXPECT_EQ(png_side(written(), 16), 480);
}

TEST_F(UiShot, RunsActionsByTheirNames) {
    if (!can_draw()) GTEST_SKIP() << "neither EGL nor OSMesa makes a context here";
    ASSERT_EQ(run_ui_shot(command_), exit_ok);
    const auto usual = above_status();
    command_.actions = {"Fold the panel"};
    ASSERT_EQ(run_ui_shot(command_), exit_ok);
    EXPECT_NE(above_status(), usual);
    command_.actions = {"Fold the panel", "Fold the panel"};
    ASSERT_EQ(run_ui_shot(command_), exit_ok);
    EXPECT_EQ(above_status(), usual);
    command_.actions = {"Fold the pannel"};
    EXPECT_EQ(run_ui_shot(command_), exit_wrong_input);
}

}  // namespace
}  // namespace zeroset::ui_shot_test
