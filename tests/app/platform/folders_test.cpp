// Tests of the folders that the desktop gives to programs.

#include "app/platform/folders.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace zeroset::test::folders_test {
namespace {

TEST(StateFolder, FollowsTheXdgSpecification) {
    setenv("XDG_STATE_HOME", "/somewhere", 1);
    EXPECT_EQ(state_folder(), "/somewhere/zeroset");
    setenv("XDG_STATE_HOME", "relative", 1);
    setenv("HOME", "/home/someone", 1);
    EXPECT_EQ(state_folder(), "/home/someone/.local/state/zeroset");
}

TEST(CacheAndConfigFolders, FollowTheXdgSpecification) {
    setenv("HOME", "/home/someone", 1);
    setenv("XDG_CACHE_HOME", "/fast", 1);
    setenv("XDG_CONFIG_HOME", "relative", 1);
    EXPECT_EQ(cache_folder(), "/fast/zeroset");
    EXPECT_EQ(config_folder(), "/home/someone/.config/zeroset");
    unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(cache_folder(), "/home/someone/.cache/zeroset");
}

}  // namespace
}  // namespace zeroset::test::folders_test
