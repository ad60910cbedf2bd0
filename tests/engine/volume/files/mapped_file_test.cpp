#include "engine/volume/files/mapped_file.hpp"

#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace zeroset::test::mapped_file_test {
namespace {

TEST(MappedFiles, PagesThatAreLostAreFilledWithZeros) {
    const TestFolder folder;
    const auto file = folder / "samples.raw";
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    std::ofstream(file, std::ios::binary) << std::string(3 * page, 'a');
    const void* inside = nullptr;
    {
        const auto mapped = MappedFile::open(file);
        ASSERT_TRUE(mapped.has_value()) << mapped.error();
        const auto bytes = (*mapped)->bytes();
        ASSERT_EQ(bytes.size(), 3 * page);
        inside = &bytes[page + 5];
        EXPECT_FALSE(fill_lost_pages(bytes.data() - 1));
        EXPECT_FALSE(fill_lost_pages(bytes.data() + bytes.size()));
        EXPECT_FALSE(fill_lost_pages(nullptr));
        std::filesystem::resize_file(file, page);
        ASSERT_TRUE(fill_lost_pages(inside));
        const auto is = [](char letter) {
            return [letter](std::byte byte) { return byte == static_cast<std::byte>(letter); };
        };
        EXPECT_TRUE(std::ranges::all_of(bytes.first(page), is('a')));
        EXPECT_TRUE(std::ranges::all_of(bytes.subspan(page), is(0)));
    }
    EXPECT_FALSE(fill_lost_pages(inside)) << "it is not mapped any more";
}

TEST(MappedFiles, AnEmptyFileHasNoBytesAndAnAbsentOneItsError) {
    const TestFolder folder;
    std::ofstream(folder / "empty.raw", std::ios::binary).close();
    const auto empty = MappedFile::open(folder / "empty.raw");
    ASSERT_TRUE(empty.has_value()) << empty.error();
    EXPECT_TRUE((*empty)->bytes().empty());
    EXPECT_EQ(MappedFile::open(folder / "none.raw").error(),
              "it cannot be read: No such file or directory");
}

}  // namespace
}  // namespace zeroset::test::mapped_file_test
