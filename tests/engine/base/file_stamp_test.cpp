#include "engine/base/file_stamp.hpp"

#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

namespace zeroset::test::file_stamp_test {
namespace {

TEST(FileStamps, TellAChangeOfSizeOfTimeAndOfAFolder) {
    const TestFolder folder;
    const auto file = folder / "a.txt";
    const auto absent = FileStamp::now(file);
    EXPECT_TRUE(absent.is_still_so());
    std::ofstream(file) << "one";
    EXPECT_FALSE(absent.is_still_so());
    const auto whole = FileStamp::now(folder.path());
    const auto one = FileStamp::now(file);
    EXPECT_EQ(one.size, 3);
    EXPECT_TRUE(one.is_still_so());
    std::filesystem::last_write_time(file, one.time + std::chrono::seconds(3));
    EXPECT_FALSE(one.is_still_so());
    std::filesystem::last_write_time(file, one.time);
    EXPECT_TRUE(one.is_still_so());
    EXPECT_EQ(FileStamp::now(folder.path()).size, whole.size);
    std::ofstream(file) << "three";
    std::filesystem::last_write_time(file, one.time);
    EXPECT_FALSE(one.is_still_so());
    EXPECT_EQ(FileStamp::now(folder.path()).size, 5);
    std::ofstream(folder / "b.txt") << "four";
    EXPECT_EQ(FileStamp::now(folder.path()).size, 9);
    EXPECT_FALSE(whole.is_still_so());
}

}  // namespace
}  // namespace zeroset::test::file_stamp_test
