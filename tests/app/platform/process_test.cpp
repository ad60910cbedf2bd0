#include "app/platform/process.hpp"

#include "engine/volume/files/mapped_file.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

// Mapped files that another program makes shorter.

namespace zeroset::test::process_test {
namespace {

/// A mapped file whose second half has been cut off.
class CutFile {
public:
    CutFile() {
        std::ofstream(file_, std::ios::binary) << std::string(size, 'a');
        mapped_ = *MappedFile::open(file_);
        std::filesystem::resize_file(file_, size / 2);
    }
    [[nodiscard]] std::byte last() const { return mapped_->bytes().back(); }

private:
    static constexpr std::size_t size = std::size_t{1} << 20U;

    TestFolder folder_;
    std::filesystem::path file_ = folder_ / "samples.raw";
    std::shared_ptr<const MappedFile> mapped_;
};

/// Exits with the value of the byte that was lost.
[[noreturn]] void read_what_is_lost(bool (*handle)(const void* address)) {
    const CutFile file;
    on_lost_pages(handle);
    std::_Exit(static_cast<int>(file.last()));
}

class LostPagesDeathTest : public testing::Test {
protected:
    LostPagesDeathTest() { ::testing::GTEST_FLAG(death_test_style) = "threadsafe"; }
};

TEST_F(LostPagesDeathTest, AreReadAsZerosWhereTheyAreFilled) {
    EXPECT_EXIT(read_what_is_lost(fill_lost_pages), ::testing::ExitedWithCode(0), "");
}

TEST_F(LostPagesDeathTest, EndTheProcessWithALineWhereThatIsWanted) {
    const auto end = [](const void* address) {
        if (is_mapped(address)) end_on_lost_page();
        return false;
    };
    EXPECT_EXIT(read_what_is_lost(end), ::testing::ExitedWithCode(EXIT_FAILURE),
                "^error: a file of samples has become shorter while it was read; try again");
}

TEST_F(LostPagesDeathTest, EndTheProcessByTheSignalWhereNoOneKnowsThem) {
    const auto refuse = [](const void* /*address*/) { return false; };
    EXPECT_EXIT(read_what_is_lost(refuse), ::testing::KilledBySignal(SIGBUS), "");
}

}  // namespace
}  // namespace zeroset::test::process_test
