// Tests of the command that brings other programs' files into a folder.

#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::test::import_command_test {
namespace {

std::string file_in(const TestFolder& folder, const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder / name;
    std::ofstream(path) << text;
    return path.string();
}

/// The exit code of bringing files into a folder within this one.
int bring(const TestFolder& folder, std::vector<std::string> files) {
    return run_import({.files = std::move(files),
                       .folder = (folder / "out").string(),
                       .size = "16x16",
                       .budget = {},
                       .json = {},
                       .no_pictures = false});
}

TEST(ImportCommand, NothingThatDrawsIsWrongInput) {
    const TestFolder folder;
    const std::string wrong = file_in(folder, "wrong.txt", "foo(");
    const std::string right = file_in(folder, "right.txt", "x^2 + y^2 + z^2 = 1");
    const std::string empty = file_in(folder, "empty.txt", "x^2 + 9 = 0");
    const std::string none = file_in(folder, "none.jsurf", "");
    EXPECT_EQ(bring(folder, {wrong}), exit_wrong_input);
    EXPECT_EQ(bring(folder, {wrong, wrong}), exit_wrong_input);
    EXPECT_EQ(bring(folder, {wrong, right}), exit_ok);
    EXPECT_EQ(bring(folder, {empty}), exit_ok);
    EXPECT_EQ(bring(folder, {right, none}), exit_wrong_input);
    // The session is written all the same, to be mended.
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / "wrong.zeroset.json"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / "right.png"));
}

}  // namespace
}  // namespace zeroset::test::import_command_test
