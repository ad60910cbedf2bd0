// Tests of the command that brings other programs' files into a folder.

#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace zeroset::test {
namespace {

namespace fs = std::filesystem;

/// A folder of files of formulas that ends with the test.
class ImportCommands : public testing::Test {
protected:
    ImportCommands() { fs::create_directories(folder_); }
    ~ImportCommands() override { fs::remove_all(folder_); }

    std::string file(const std::string& name, const std::string& text) {
        const fs::path path = folder_ / name;
        std::ofstream(path) << text;
        return path.string();
    }

    int bring(std::vector<std::string> files) const {
        return run_import({.files = std::move(files),
                           .folder = (folder_ / "out").string(),
                           .size = "16x16",
                           .budget = {},
                           .json = {},
                           .no_pictures = false});
    }

    fs::path folder_ = fs::temp_directory_path() /
                       ("zeroset_import_" +
                        std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(ImportCommands, NothingThatDrawsIsWrongInput) {
    const std::string wrong = file("wrong.txt", "foo(");
    const std::string right = file("right.txt", "x^2 + y^2 + z^2 = 1");
    const std::string empty = file("empty.txt", "x^2 + 9 = 0");
    EXPECT_EQ(bring({wrong}), exit_wrong_input);
    EXPECT_EQ(bring({wrong, wrong}), exit_wrong_input);
    EXPECT_EQ(bring({wrong, right}), exit_ok);
    EXPECT_EQ(bring({empty}), exit_ok);
    EXPECT_EQ(bring({right, file("none.jsurf", "")}), exit_wrong_input);
    // The session is written all the same, to be mended.
    EXPECT_TRUE(fs::exists(folder_ / "out/wrong.zeroset.json"));
    EXPECT_TRUE(fs::exists(folder_ / "out/right.png"));
}

}  // namespace
}  // namespace zeroset::test
