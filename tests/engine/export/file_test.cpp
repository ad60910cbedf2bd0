#include "engine/export/file.hpp"

#include "engine/export/new_file.hpp"
#include "engine/export/pfm_writer.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <thread>

// Files are whole or not there, and their bytes are what the formats say.

namespace zeroset::test::file_test {
namespace {

namespace fs = std::filesystem;

class FileTest : public ::testing::Test {
protected:
    [[nodiscard]] static std::string content(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    [[nodiscard]] long files() const {
        return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
    }
    static std::span<const std::byte> bytes_of(const std::string& text) {
        return std::as_bytes(std::span(text));
    }
    static void expect_refused(const std::expected<void, FileError>& result, const fs::path& path) {
        ASSERT_FALSE(result);
        EXPECT_NE(result.error().message.find(path.string()), std::string::npos)
            << result.error().message;
        EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
    }

    TestFolder folder_;
};

TEST_F(FileTest, WritesAllBytes) {
    const std::string text("a\0b\nc\xff", 6);
    ASSERT_TRUE(write_file(folder_ / "out", bytes_of(text)));
    EXPECT_EQ(content(folder_ / "out"), text);
    ASSERT_TRUE(write_file(folder_ / "out", {}));
    EXPECT_EQ(content(folder_ / "out"), "");
    EXPECT_EQ(files(), 1);
}

/// The file that was begun is taken away, and nothing more is written.
TEST_F(FileTest, LeavesNothingHalfWrittenWhenAbandoned) {
    ::testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const std::string text(3'000'000, 'x');
    const fs::path folder = folder_.path();
    const auto write_and_abandon = [&] {
        std::thread([&] {
            for (int i = 0;; ++i)
                (void)write_file(folder / std::to_string(i % 2), bytes_of(text));
        }).detach();
        while (!fs::exists(folder / "1")) {
        }
        abandon_files();
        std::_Exit(0);
    };
    EXPECT_EXIT(write_and_abandon(), ::testing::ExitedWithCode(0), "");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        EXPECT_EQ(entry.file_size(), text.size()) << entry.path();
}

TEST_F(FileTest, ReplacesALongerFile) {
    ASSERT_TRUE(write_file(folder_ / "out", bytes_of(std::string(100'000, 'x'))));
    ASSERT_TRUE(write_file(folder_ / "out", bytes_of("short")));
    EXPECT_EQ(content(folder_ / "out"), "short");
    EXPECT_EQ(files(), 1);
}

TEST_F(FileTest, RefusesAFolderThatIsNotThere) {
    const fs::path path = folder_ / "none/out";
    expect_refused(check_writable(path), path);
    expect_refused(write_file(path, bytes_of("x")), path);
    EXPECT_EQ(files(), 0);
}

TEST_F(FileTest, RefusesAFolderAsFile) {
    expect_refused(check_writable(folder_.path()), folder_.path());
    expect_refused(write_file(folder_.path(), bytes_of("x")), folder_.path());
    EXPECT_FALSE(check_writable(""));
    EXPECT_EQ(files(), 0);
}

TEST_F(FileTest, RefusesANameThatIsTooLong) {
    const fs::path path = folder_ / std::string(300, 'x');
    expect_refused(check_writable(path), path);
    expect_refused(check_writable(path / "out"), path / "out");
    expect_refused(write_file(path, bytes_of("x")), path);
    EXPECT_EQ(files(), 0);
}

TEST_F(FileTest, LeavesNothingBehindWithoutPermission) {
    if (::geteuid() == 0) GTEST_SKIP() << "permissions do not stop root";
    fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
    expect_refused(write_file(folder_ / "out", bytes_of("x")), folder_ / "out");
    EXPECT_EQ(files(), 0);
    fs::permissions(folder_.path(), fs::perms::owner_all);
}

TEST_F(FileTest, ReportsADeviceWithoutSpace) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    expect_refused(write_file("/dev/full", bytes_of("x")), "/dev/full");
}

TEST_F(FileTest, FollowsLinksAndKeepsPermissions) {
    const auto readers = fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read;
    fs::create_directory(folder_ / "there");
    EXPECT_TRUE(write_file(folder_ / "there/file", bytes_of("old")));
    fs::permissions(folder_ / "there/file", readers);
    fs::create_symlink("there/file", folder_ / "link");
    fs::create_symlink("link", folder_ / "second");
    EXPECT_TRUE(write_file(folder_ / "second", bytes_of("new")));
    EXPECT_TRUE(fs::is_symlink(folder_ / "second"));
    EXPECT_EQ(content(folder_ / "there/file"), "new");
    EXPECT_EQ(fs::status(folder_ / "there/file").permissions(), readers);
    fs::create_symlink(folder_ / "there/next", folder_ / "to be");
    EXPECT_TRUE(write_file(folder_ / "to be", bytes_of("made")));
    EXPECT_EQ(content(folder_ / "there/next"), "made");
    fs::create_symlink("around", folder_ / "around");
    expect_refused(write_file(folder_ / "around", bytes_of("x")), folder_ / "around");
}

TEST_F(FileTest, RefusesAFileThatNobodyMayWrite) {
    EXPECT_TRUE(write_file(folder_ / "file", bytes_of("old")));
    fs::permissions(folder_ / "file", fs::perms::owner_read);
    fs::create_symlink("file", folder_ / "link");
    for (const char* const name : {"file", "link"})
        expect_refused(write_file(folder_ / name, bytes_of("new")), folder_ / name);
    EXPECT_EQ(content(folder_ / "file"), "old");
}

/// Reads a pipe while `write` writes into it.
std::string piped(const fs::path& pipe, const std::function<void()>& write) {
    ::mkfifo(pipe.c_str(), 0600);
    std::string read;
    std::thread reader([&] {
        std::ifstream file(pipe, std::ios::binary);
        read.assign(std::istreambuf_iterator<char>(file), {});
    });
    write();
    reader.join();
    return read;
}

TEST_F(FileTest, WritesIntoPipes) {
    const fs::path pipe = folder_ / "pipe";
    const std::string text(200'000, 'x');
    EXPECT_EQ(piped(pipe, [&] { EXPECT_TRUE(write_file(pipe, bytes_of(text))); }), text);
    const auto write_backwards = [&] {
        NewFile file(pipe, NewFile::Order::Any);
        EXPECT_TRUE(file.append(bytes_of(text)));
        file.stream().seekp(1);
        EXPECT_TRUE(file.append(bytes_of("abc")));
        EXPECT_NE(file.place(), pipe);
        EXPECT_TRUE(file.keep());
    };
    EXPECT_EQ(piped(pipe, write_backwards), "xabc" + text.substr(4));
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(files(), 1);
}

/// A signal ends the program even while nobody reads from the pipe.
TEST_F(FileTest, CanBeAbandonedWhileAPipeHasNoReader) {
    ::testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const fs::path pipe = folder_ / "pipe";
    const auto end = [&] {
        ::mkfifo(pipe.c_str(), 0600);
        std::thread([&] { const NewFile file(pipe); }).detach();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        abandon_files();
        std::_Exit(0);
    };
    EXPECT_EXIT(end(), ::testing::ExitedWithCode(0), "");
}

/// 3 x 2 pixels, all different.
Framebuffer small_frame() {
    Framebuffer frame(3, 2);
    for (std::size_t i = 0; i < 6; ++i) {
        frame.color[i] = 0xFF000000U | static_cast<std::uint32_t>(0x030201U * (i + 1));
        frame.depth[i] = static_cast<float>(i) + 0.5F;
    }
    frame.depth[2] = std::numeric_limits<float>::infinity();
    return frame;
}

TEST_F(FileTest, PfmHasItsRowsFromTheBottom) {
    PfmWriter writer(folder_ / "depth.pfm", 3, 2);
    ASSERT_TRUE(writer.add(small_frame(), 0));
    ASSERT_TRUE(writer.finish());
    const std::string text = content(folder_ / "depth.pfm");
    const std::string header = "Pf\n3 2\n-1.0\n";
    ASSERT_EQ(text.size(), header.size() + 24);
    EXPECT_TRUE(text.starts_with(header));
    std::array<float, 6> depth{};
    std::memcpy(depth.data(), text.data() + header.size(), sizeof depth);
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(depth, (std::array{3.5F, 4.5F, 5.5F, 0.5F, 1.5F, inf}));
}

std::uint32_t big_endian(const std::string& text, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8U | static_cast<unsigned char>(text[at + i]);
    }
    return value;
}

TEST_F(FileTest, PngHasItsSizeAndThreeChannels) {
    ASSERT_TRUE(write_png(folder_ / "picture.png", small_frame()));
    const std::string text = content(folder_ / "picture.png");
    EXPECT_TRUE(text.starts_with("\x89PNG\r\n\x1a\n"));
    ASSERT_GT(text.size(), 45U);
    EXPECT_EQ(text.substr(12, 4), "IHDR");
    EXPECT_EQ(big_endian(text, 16), 3U);
    EXPECT_EQ(big_endian(text, 20), 2U);
    EXPECT_EQ(text.substr(24, 5), std::string("\x08\x02\0\0\0", 5));  // 8 bits, RGB
    EXPECT_EQ(text.substr(text.size() - 8, 4), "IEND");
    EXPECT_EQ(files(), 1);
}

TEST(Framebuffer, StartsAsMisses) {
    const Framebuffer frame(5, 4);
    EXPECT_EQ(frame.color.size(), 20U);
    EXPECT_EQ(frame.index(2, 3), 17U);
    const CertificateCounts counts = count_certificates(frame);
    EXPECT_EQ(counts.miss, 20U);
    EXPECT_EQ(counts.certified + counts.undecided, 0U);
    for (const float depth : frame.depth) {
        EXPECT_EQ(depth, std::numeric_limits<float>::infinity());
    }
}

TEST(CountCertificates, CountsEachKind) {
    Framebuffer frame(3, 2);
    frame.certificate = {Certificate::Miss,      Certificate::Certified, Certificate::Undecided,
                         Certificate::Certified, Certificate::Certified, Certificate::Undecided};
    frame.depth[2] = 1.0F;
    const CertificateCounts counts = count_certificates(frame);
    EXPECT_EQ(counts.miss, 1U);
    EXPECT_EQ(counts.certified, 3U);
    EXPECT_EQ(counts.undecided, 2U);
    EXPECT_EQ(counts.not_drawn, 1U);
}

}  // namespace
}  // namespace zeroset::test::file_test
