#include "app/cli/terminal_picture.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace zeroset::terminal_picture_test {
namespace {

constexpr std::uint32_t red = 0xFF0000FF;
constexpr std::uint32_t blue = 0xFFFF0000;

TEST(TerminalPicture, ShowsTwoRowsInALine) {
    const RgbaImage image{.width = 1, .height = 2, .pixels = {red, blue}};
    EXPECT_EQ(terminal_lines(image), 1);
    EXPECT_EQ(terminal_picture(image),
              "\x1b[K\x1b[38;2;255;0;0m\x1b[48;2;0;0;255m\xE2\x96\x80\x1b[0m\n");
}

TEST(TerminalPicture, LeavesTransparentPixelsOut) {
    const RgbaImage image{.width = 2, .height = 1, .pixels = {0, red}};
    EXPECT_EQ(terminal_lines(image), 1);
    EXPECT_EQ(terminal_picture(image),
              "\x1b[K\x1b[39m\x1b[49m \x1b[38;2;255;0;0m\x1b[49m\xE2\x96\x80\x1b[0m\n");
}

TEST(TerminalPicture, UsesTheLowerHalfBelowNothing) {
    const RgbaImage image{.width = 1, .height = 2, .pixels = {0, red}};
    EXPECT_EQ(terminal_picture(image), "\x1b[K\x1b[38;2;255;0;0m\x1b[49m\xE2\x96\x84\x1b[0m\n");
}

TEST(TerminalPicture, IsNothingWithoutAPicture) {
    EXPECT_EQ(terminal_picture({}), "");
    EXPECT_EQ(terminal_lines({}), 0);
}

TEST(TerminalPicture, AsksTheEnvironmentForColors) {
    ::setenv("COLORTERM", "truecolor", 1);
    EXPECT_TRUE(has_true_color());
    ::setenv("COLORTERM", "yes", 1);
    EXPECT_FALSE(has_true_color());
    ::unsetenv("COLORTERM");
    EXPECT_FALSE(has_true_color());
}

}  // namespace
}  // namespace zeroset::terminal_picture_test
