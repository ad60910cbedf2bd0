#include "engine/volume/files/volume_file.hpp"
#include "tests/support/dicom_elements.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/sample_field.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

// Files of DICOM with several slices each: enhanced CT and MR, doses; and run lengths, which are
// packed here by the standard's words.

namespace zeroset::test::dicom_frames_test {
namespace {

enum class Lengths : std::uint8_t { Told, Open };

/// A sequence of items, whose lengths are told or left open.
std::string sequence(unsigned group, unsigned number, const std::vector<std::string>& items,
                     Lengths lengths) {
    const std::string open(4, '\xff');
    const std::string none(4, '\0');
    std::string all;
    for (const std::string& item : items) {
        all += tag(0xfffe, 0xe000);
        all += lengths == Lengths::Told ? length_of(item.size()) + item
                                        : open + item + tag(0xfffe, 0xe00d) + none;
    }
    if (lengths == Lengths::Told) return element(group, number, "SQ", all);
    return tag(group, number) + "SQ" + std::string(2, '\0') + open + all + tag(0xfffe, 0xe0dd) +
           none;
}

/// PackBits: runs where three bytes or more are alike, else as they are.
std::string packed_bits(const std::string& bytes) {
    std::string packed;
    for (std::size_t at = 0; at < bytes.size();) {
        std::size_t run = 1;
        while (run < 128 && at + run < bytes.size() && bytes[at + run] == bytes[at])
            ++run;
        if (run >= 3) {
            packed += static_cast<char>(257 - run);
            packed += bytes[at];
        } else {
            packed += static_cast<char>(run - 1);
            packed += bytes.substr(at, run);
        }
        at += run;
    }
    return packed.size() % 2 == 0 ? packed : packed + '\x80';
}

constexpr const char* enhanced_ct = "1.2.840.10008.5.1.4.1.1.2.1";

/// A file of slices of 4 x 3 samples, i + 10 j + 100 k.
struct Frames {
    int frames = 3;
    int told = 3;  ///< slices that the groups tell of
    Lengths lengths = Lengths::Told;
    std::vector<int> heights = {0, 1, 2};  ///< of the slices in the file's order
    bool groups = true, packed = false;
    int bytes = 2;  ///< of a sample
    std::string slope = {};
    std::string offsets = {};
    std::string series = "1.2.3.4";

    [[nodiscard]] std::string sample(int i, int j, int k) const {
        const auto number = static_cast<std::uint32_t>(i + 10 * j + 100 * k);
        return bytes_of(bytes == 4 ? number << 16U | 7U : number)
            .substr(0, static_cast<std::size_t>(bytes));
    }
    [[nodiscard]] std::string slice(int k) const {
        std::string all;
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 4; ++i)
                all += sample(i, j, k);
        }
        return all;
    }
    [[nodiscard]] std::string fragment(int k) const {
        const std::string all = slice(k);
        std::string header = length_of(static_cast<std::size_t>(bytes));
        std::string segments;
        for (int byte = bytes - 1; byte >= 0; --byte) {
            header += length_of(64 + segments.size());
            std::string plane;
            for (auto at = static_cast<std::size_t>(byte); at < all.size();
                 at += static_cast<std::size_t>(bytes))
                plane += all[at];
            segments += packed_bits(plane);
        }
        header.resize(64, '\0');
        return header + segments;
    }
    [[nodiscard]] std::string pixels() const {
        std::string all;
        if (!packed) {
            for (const int k : heights)
                all += slice(k);
            return element(0x7fe0, 0x10, "OW", all);
        }
        all = tag(0xfffe, 0xe000) + length_of(0);
        for (const int k : heights) {
            const std::string item = fragment(k);
            all += tag(0xfffe, 0xe000) + length_of(item.size()) + item;
        }
        return tag(0x7fe0, 0x10) + "OB" + std::string(2, '\0') + std::string(4, '\xff') + all +
               tag(0xfffe, 0xe0dd) + length_of(0);
    }
    [[nodiscard]] std::string shared() const {
        const std::string measures =
            element(0x18, 0x50, "DS", "9") + element(0x28, 0x30, "DS", R"(3\0.5)");
        std::string item =
            sequence(0x28, 0x9110, {measures}, lengths) +
            sequence(0x20, 0x9116, {element(0x20, 0x37, "DS", R"(1\0\0\0\1\0)")}, lengths);
        if (!slope.empty()) {
            item += sequence(
                0x28, 0x9145,
                {element(0x28, 0x1052, "DS", "-5") + element(0x28, 0x1053, "DS", slope)}, lengths);
        }
        return sequence(0x5200, 0x9229, {item}, lengths);
    }
    [[nodiscard]] std::string each() const {
        std::vector<std::string> items;
        for (int n = 0; n < told; ++n) {
            const int height = heights[static_cast<std::size_t>(n) % heights.size()];
            // Another group says something of its own of the same name.
            const std::string other =
                sequence(0x40, 0x9096, {element(0x20, 0x32, "DS", R"(7\7\7)")}, lengths);
            items.push_back(
                other + sequence(0x20, 0x9113,
                                 {element(0x20, 0x32, "DS", "1\\2\\" + std::to_string(2 * height))},
                                 lengths));
        }
        return sequence(0x5200, 0x9230, items, lengths);
    }
    [[nodiscard]] std::string file() const {
        const std::string meta =
            element(2, 1, "OB", std::string("\0\1", 2)) + element(2, 2, "UI", enhanced_ct) +
            element(2, 3, "UI", "1.2.3.4.5") +
            element(2, 0x10, "UI", packed ? "1.2.840.10008.1.2.5" : "1.2.840.10008.1.2.1");
        const std::string place = groups ? ""
                                         : element(0x20, 0x32, "DS", R"(1\2\0)") +
                                               element(0x20, 0x37, "DS", R"(1\0\0\0\1\0)");
        return std::string(128, '\0') + "DICM" + element(2, 0, "UL", length_of(meta.size())) +
               meta + element(8, 0x16, "UI", enhanced_ct) + element(8, 0x18, "UI", "1.2.3.4.5") +
               element(0x20, 0xe, "UI", series) + place + short_element(0x28, 2, 1) +
               element(0x28, 4, "CS", "MONOCHROME2") +
               element(0x28, 8, "IS", std::to_string(frames)) + short_element(0x28, 0x10, 3) +
               short_element(0x28, 0x11, 4) +
               (groups ? "" : element(0x28, 0x30, "DS", R"(3\0.5)")) +
               short_element(0x28, 0x100, 8 * bytes) + short_element(0x28, 0x101, 8 * bytes) +
               short_element(0x28, 0x103, 0) +
               (offsets.empty() ? "" : element(0x3004, 0xc, "DS", offsets)) +
               (offsets.empty() ? "" : element(0x3004, 0xe, "DS", "0.25")) +
               (groups ? shared() + each() : "") + pixels();
    }
};

class DicomFrames : public ::testing::Test {
protected:
    [[nodiscard]] std::filesystem::path write(const std::string& name,
                                              const std::string& bytes) const {
        const auto file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }
    /// Each in a folder of its own.
    std::filesystem::path write(const Frames& frames) {
        return write(std::to_string(++count_) + "/a", frames.file());
    }
    std::string error_of(const Frames& frames) {
        const auto data = open_volume(write(frames), {});
        return data ? "no error" : data.error();
    }
    static void expect_samples(const std::filesystem::path& path, double factor, double shift,
                               std::uint64_t slices = 3) {
        const auto data = open_volume(path, {});
        ASSERT_TRUE(data.has_value()) << data.error();
        ASSERT_EQ((*data)->samples().size, (GridSize{4, 3, slices}));
        EXPECT_EQ((*data)->geometry().world_from_index,
                  (Matrix3{{{-0.5, 0, 0}, {0, -3, 0}, {0, 0, 2}}}));
        EXPECT_EQ((*data)->geometry().origin, (std::array<double, 3>{-1, -2, 0}));
        for (std::uint64_t k = 0; k < slices; ++k) {
            for (std::uint64_t j = 0; j < 3; ++j) {
                for (std::uint64_t i = 0; i < 4; ++i) {
                    const auto number = static_cast<double>(i + 10 * j + 100 * k);
                    ASSERT_EQ(sample_at(**data, i, j, k), factor * number + shift);
                }
            }
        }
    }

    TestFolder folder_;
    int count_ = 0;
};

TEST_F(DicomFrames, AreTheSlicesOfAFileInAnyOrder) {
    for (const Lengths lengths : {Lengths::Told, Lengths::Open}) {
        expect_samples(write({.lengths = lengths}), 1, 0);
        expect_samples(write({.lengths = lengths, .heights = {2, 0, 1}}), 1, 0);
        expect_samples(write({.lengths = lengths, .slope = "2"}), 2, -5);
    }
}

TEST_F(DicomFrames, OfTwoFilesAreOneVolume) {
    const auto file = write("two/a", Frames{.frames = 2, .told = 2, .heights = {3, 0}}.file());
    static_cast<void>(write("two/b", Frames{.frames = 2, .told = 2, .heights = {1, 2}}.file()));
    static_cast<void>(write("two/c", Frames{.series = "9.9"}.file()));
    expect_samples(file, 1, 0, 4);
}

TEST_F(DicomFrames, OfDosesLieAtOffsets) {
    expect_samples(write({.groups = false, .offsets = R"(0\2\4)"}), 0.25, 0);
    expect_samples(write({.groups = false, .bytes = 2, .offsets = R"(10\12\14)"}), 0.25, 0);
}

TEST_F(DicomFrames, AndSamplesOfAnySizeAreUnpackedFromRunLengths) {
    expect_samples(write({.packed = true}), 1, 0);
    expect_samples(write({.heights = {1, 2, 0}, .packed = true}), 1, 0);
    expect_samples(write({.packed = true, .bytes = 4}), 65536, 7);
}

/// The slices 2, 0, 1, packed by GDCM 3.0 as JPEG-LS and lossless JPEG.
TEST_F(DicomFrames, ThatOtherProgramsPacked) {
    const std::filesystem::path folder = ZEROSET_SOURCE_DIR "/tests/engine/volume/files/frames";
    for (const char* const name : {"jpeg_ls", "jpeg"}) {
        const auto data = open_volume(folder / name, {});
        if (!data && data.error().contains("without GDCM")) GTEST_SKIP() << data.error();
        expect_samples(folder / name, 1, 0);
    }
}

TEST_F(DicomFrames, ThatAreNoGridGetTheirLine) {
    EXPECT_EQ(error_of({.told = 2}), "it announces 3 slices, and tells of 2");
    EXPECT_EQ(error_of({.groups = false}),
              "it holds 3 slices, and does not say where each of them lies");
    EXPECT_EQ(error_of({.groups = false, .offsets = R"(0\2)"}),
              "it holds 3 slices, and does not say where each of them lies");
    EXPECT_TRUE(error_of({.heights = {0, 1, 1}})
                    .starts_with("two of its slices lie at one place, as slice "));
    EXPECT_EQ(error_of({.frames = 4, .groups = false, .offsets = R"(0\2\4\6)"}),
              "'a' of the series: it is too short: 96 bytes of samples are announced, 72 bytes are "
              "there");
    EXPECT_EQ(error_of({.frames = 2, .told = 2, .heights = {0, 1, 2}, .packed = true}),
              "'a' of the series: it announces 2 slices, but has 3 packed ones");
    EXPECT_EQ(error_of({.frames = 0}),
              "its 'NumberOfFrames' is '0'; a whole number from 1 on is wanted");
}

/// Any byte may be wrong, and a file may end anywhere: what comes is an error of one line or a
/// volume. In a short run every fourth place is tried.
TEST_F(DicomFrames, MayBeDamaged) {
    for (const Frames& frames : {Frames{}, Frames{.lengths = Lengths::Open, .packed = true}}) {
        const std::string whole = frames.file();
        for (std::size_t at = 132; at < whole.size(); at += is_long_run() ? 1U : 4U) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(at % 3 == 0 ? 0xff : damaged[at] ^ 0x41);
            for (const std::string& bytes : {damaged, whole.substr(0, at)}) {
                const auto read = read_volume_file(write("damaged/a", bytes), {});
                EXPECT_TRUE(read || !read.error().contains('\n')) << at;
            }
        }
    }
}

}  // namespace
}  // namespace zeroset::test::dicom_frames_test
