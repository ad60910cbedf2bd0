// Tests of the list of files that were opened last.

#include "app/desktop/recent_files.hpp"

#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::test::recent_files_test {
namespace {

TEST(Recent, KeepsTheNewestFirst) {
    const TestFolder folder;
    RecentFiles recent(folder.path());
    for (int i = 0; i < 12; ++i)
        recent.add("/d/" + std::to_string(i));
    recent.add("/d/7");
    ASSERT_EQ(recent.paths().size(), RecentFiles::most);
    EXPECT_EQ(recent.paths()[0], "/d/7");
    EXPECT_EQ(recent.paths()[1], "/d/11");
    EXPECT_EQ(RecentFiles(folder.path()).paths(), recent.paths());
}

}  // namespace
}  // namespace zeroset::test::recent_files_test
