#include "engine/volume/files/volume_file.hpp"
#include "tests/support/dicom_slice.hpp"
#include "tests/support/sample_field.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace zeroset::test::dicom_test {
namespace {

using Slice = DicomTestSlice;

class Dicom : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        const auto file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }
    /// Three slices, changed by `change`, whose files' names have another order than the slices.
    std::filesystem::path series(const std::string& folder, auto change) const {
        for (int k = 0; k < 3; ++k) {
            Slice slice{.k = k};
            change(slice);
            write(folder + "/IM" + std::to_string((k + 1) % 3), slice.bytes());
        }
        return folder_ / folder;
    }
    static std::shared_ptr<const VolumeData> open(const std::filesystem::path& path) {
        const auto data = open_volume(path, {});
        EXPECT_TRUE(data.has_value()) << data.error();
        return data.value_or(nullptr);
    }
    static std::string error_of(const std::filesystem::path& path) {
        const auto data = open_volume(path, {});
        return data ? "no error" : data.error();
    }
    /// Checks all samples against factor * (i + 10 j + 100 k) + shift.
    static void expect_samples(const VolumeData& data, double factor, double shift) {
        ASSERT_EQ(data.samples().size, (GridSize{4, 3, 3}));
        for (std::uint64_t k = 0; k < 3; ++k) {
            for (std::uint64_t j = 0; j < 3; ++j) {
                for (std::uint64_t i = 0; i < 4; ++i) {
                    const auto number = static_cast<double>(i + 10 * j + 100 * k);
                    ASSERT_EQ(sample_at(data, i, j, k), factor * number + shift);
                }
            }
        }
    }

    TestFolder folder_;
};

TEST_F(Dicom, ASeriesIsAFolderOrAnyOfItsFiles) {
    const auto folder = series("ct", [](Slice&) {});
    write("ct/readme.txt", "no slice");
    EXPECT_TRUE(is_volume_file(folder));
    EXPECT_TRUE(is_volume_file(folder / "IM0"));
    EXPECT_FALSE(is_volume_file(folder / "readme.txt"));
    for (const auto& path : {folder, folder / "IM0", folder / "IM2"}) {
        const auto data = open(path);
        ASSERT_TRUE(data);
        expect_samples(*data, 1, 0);
        EXPECT_EQ(data->samples().type, SampleType::UInt16);
        // x to the right and y to the front, where the format has left and back
        EXPECT_EQ(data->geometry().world_from_index,
                  (Matrix3{{{-0.5, 0, 0}, {0, -3, 0}, {0, 0, 2}}}));
    }
}

TEST_F(Dicom, TellsHowItIsTurned) {
    // Sagittal: rows run to the back, columns downward, slices from left to right.
    const auto data = open(series("mr", [](Slice& slice) {
        slice.orientation = R"(0\1\0\0\0\-1)";
        slice.position = std::to_string(50 - 4 * slice.k) + R"(\-20\30)";
    }));
    ASSERT_TRUE(data);
    EXPECT_EQ(data->geometry().world_from_index, (Matrix3{{{0, 0, 4}, {-0.5, 0, 0}, {0, -3, 0}}}));
    EXPECT_EQ(data->geometry().origin, (std::array<double, 3>{-50, 20, 30}));
    expect_samples(*data, 1, 0);
}

TEST_F(Dicom, ScalesItsSamplesExactly) {
    const auto hounsfield = open(series("hu", [](Slice& slice) { slice.intercept = "-1024"; }));
    ASSERT_TRUE(hounsfield);
    expect_samples(*hounsfield, 1, -1024);
    EXPECT_EQ(hounsfield->samples().type, SampleType::Float);
    const auto tenths = open(series("tenths", [](Slice& slice) { slice.slope = "0.1"; }));
    ASSERT_TRUE(tenths);
    expect_samples(*tenths, 0.1, 0);
    EXPECT_EQ(tenths->samples().type, SampleType::Double);
    // Slopes of PET: each slice has its own.
    const auto each = open(series("pet", [](Slice& slice) {
        slice.slope = std::to_string(slice.k + 1);
        slice.intercept = std::to_string(-100 * slice.k * slice.k);
        slice.add = -100 * slice.k;
        slice.is_signed = true;
    }));
    ASSERT_TRUE(each);
    EXPECT_EQ(sample_at(*each, 3, 2, 0), 23);
    EXPECT_EQ(sample_at(*each, 3, 2, 1), 2 * 23 - 100);
    EXPECT_EQ(sample_at(*each, 3, 2, 2), 3 * 23 - 400);
}

TEST_F(Dicom, ReadsSignedAndShortSamples) {
    const auto below = open(series("signed", [](Slice& slice) {
        slice.is_signed = true;
        slice.add = -150;
    }));
    ASSERT_TRUE(below);
    expect_samples(*below, 1, -150);
    EXPECT_EQ(below->samples().type, SampleType::Int16);
    // Twelve bits are stored; those above may hold anything.
    const auto dirty = open(series("dirty", [](Slice& slice) { slice.add = 0x5000; }));
    ASSERT_TRUE(dirty);
    expect_samples(*dirty, 1, 0);
    const auto bytes = open(series("bytes", [](Slice& slice) { slice.bits = slice.stored = 8; }));
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->samples().type, SampleType::UInt8);
    expect_samples(*bytes, 1, 0);
}

TEST_F(Dicom, FilesOfAnotherSeriesAreLeftOut) {
    const auto folder = series("two", [](Slice&) {});
    write("two/other", Slice{.k = 7, .series = "9.9"}.bytes());
    const auto data = open(folder / "IM0");
    ASSERT_TRUE(data);
    expect_samples(*data, 1, 0);
    EXPECT_TRUE(error_of(folder).starts_with("it holds 2 series: name a file of one of them, as '"))
        << error_of(folder);
}

TEST_F(Dicom, WhatIsNoGridGetsItsLine) {
    EXPECT_EQ(error_of(series("gap",
                              [](Slice& slice) {
                                  if (slice.k == 2) slice.position = R"(0\0\9)";
                              })),
              "its slices are not evenly spaced: below 'IM0' lie 7 mm, elsewhere about 2 mm");
    EXPECT_TRUE(error_of(series("twice", [](Slice& slice) {
                    if (slice.k == 2) slice.position = R"(0\0\2)";
                })).starts_with("two of its slices lie at one place, as 'IM"));
    EXPECT_EQ(error_of(series("turned",
                              [](Slice& slice) {
                                  slice.orientation =
                                      slice.k == 1 ? R"(0\1\0\1\0\0)" : slice.orientation;
                              }))
                  .substr(4),
              "' of the series: it is turned or spaced otherwise than others");
    EXPECT_EQ(error_of(series("nowhere", [](Slice& slice) { slice.position = "none"; })).substr(4),
              "' of the series: it does not say where it lies");
    EXPECT_EQ(error_of(series("many", [](Slice& slice) { slice.frames = "7"; })).substr(4),
              "' of the series: it holds 7 slices, and does not say where each of them lies");
    EXPECT_EQ(error_of(series("halves", [](Slice& slice) { slice.frames = "1.5"; })).substr(4),
              "' of the series: its 'NumberOfFrames' is '1.5'; a whole number from 1 on is wanted");
    EXPECT_EQ(error_of(series("words", [](Slice& slice) { slice.spacing = "near"; })).substr(4),
              "' of the series: its 'PixelSpacing' is 'near'; two numbers are wanted");
    EXPECT_EQ(
        error_of(series("packed", [](Slice& slice) { slice.syntax = "1.2.840.10008.1.2.4.90"; }))
            .substr(4),
        "' of the series: its packed samples are not there (transfer syntax "
        "'1.2.840.10008.1.2.4.90')");
    const std::string damaged =
        error_of(series("damaged", [](Slice& slice) { slice.syntax = "1.2.840\n10008.1.2.4.90"; }));
    EXPECT_TRUE(damaged.ends_with("(transfer syntax '1.2.840\uFFFD10008.1.2.4.90')")) << damaged;
}

/// Elements without types, in sequences of any length, and of types that none are known of.
TEST_F(Dicom, PassesOverSequences) {
    const std::string open(4, '\xff');
    const std::string none(4, '\0');
    const auto tag = [](int group, int number) {
        return bytes_of(static_cast<std::uint16_t>(group)) +
               bytes_of(static_cast<std::uint16_t>(number));
    };
    const std::string inner = element(0x28, 0x30, "DS", R"(9\9)");
    const std::string sequence =
        tag(8, 0x1140) + "SQ" + std::string(2, '\0') + open + tag(0xfffe, 0xe000) + open + inner +
        tag(8, 0x1199) + "SQ" + std::string(2, '\0') + open + tag(0xfffe, 0xe0dd) + none +
        tag(0xfffe, 0xe00d) + none + tag(0xfffe, 0xe000) +
        bytes_of(static_cast<std::uint32_t>(inner.size())) + inner + tag(0xfffe, 0xe0dd) + none;
    std::string folder;
    for (int k = 0; k < 3; ++k) {
        std::string bytes = Slice{.k = k}.bytes();
        bytes.insert(bytes.find(element(8, 0x60, "CS", "CT")), sequence);
        folder = write("sequence/" + std::to_string(k), bytes).parent_path().string();
    }
    const auto data = open_volume(folder, {});
    ASSERT_TRUE(data.has_value()) << data.error();
    expect_samples(**data, 1, 0);
    EXPECT_EQ((*data)->geometry().world_from_index[0][0], -0.5);
}

/// Any byte may be wrong: what comes is an error of one line or a volume.
TEST_F(Dicom, TakesAnyBytes) {
    const std::string whole = Slice{.k = 1}.bytes();
    const auto folder = series("noise", [](Slice&) {});
    for (std::size_t at = 132; at < whole.size(); ++at) {
        std::string bytes = whole;
        for (const int value : {0, 0xff, 0x41}) {
            bytes[at] = static_cast<char>(value);
            const auto read = read_volume_file(write("noise/IM2", bytes), {});
            EXPECT_TRUE(read || read.error().find('\n') == std::string::npos) << at;
        }
    }
}

/// Wherever a file is cut off, that is told or the samples are whole; and nothing fails.
TEST_F(Dicom, CutOffFilesGetTheirLine) {
    const std::string whole = Slice{.k = 1}.bytes();
    for (std::size_t size = 132; size < whole.size(); size += 7) {
        const auto folder = series("cut" + std::to_string(size), [](Slice&) {});
        write("cut" + std::to_string(size) + "/IM2", whole.substr(0, size));
        const std::string error = error_of(folder);
        EXPECT_NE(error, "no error") << size;
        EXPECT_EQ(error.find('\n'), std::string::npos);
    }
    EXPECT_EQ(error_of(write("empty/a", std::string(128, '\0') + "DICM")).find("it"), 0U);
}

/// A series of five slices, each packed otherwise by gdcmconv (JPEG-LS, JPEG 2000, lossless JPEG)
/// or DCMTK (RLE, deflated).
const std::filesystem::path packed_series = ZEROSET_SOURCE_DIR "/tests/engine/volume/files/packed";

bool lacks_gdcm(const std::string& error) { return error.find("without GDCM") != error.npos; }

TEST_F(Dicom, ReadsSlicesThatOtherProgramsPacked) {
    const auto data = open_volume(packed_series.string(), {});
    if (!data && lacks_gdcm(data.error())) GTEST_SKIP() << data.error();
    ASSERT_TRUE(data.has_value()) << data.error();
    EXPECT_EQ((*data)->samples().size, (GridSize{16, 12, 5}));
    EXPECT_EQ((*data)->geometry().world_from_index,
              (Matrix3{{{-0.5, 0, 0}, {0, -3, 0}, {0, 0, 2}}}));
    for (std::uint64_t k = 0; k < 5; ++k) {
        for (std::uint64_t j = 0; j < 12; ++j) {
            for (std::uint64_t i = 0; i < 16; ++i) {
                const std::uint64_t stored = i * i + 10 * j + 100 * k + 3 * ((7 * i + 5 * j) % 11);
                ASSERT_EQ(sample_at(**data, i, j, k), static_cast<double>(stored) - 1024)
                    << i << "," << j << "," << k;
            }
        }
    }
}

/// A damaged or cut slice gets its line, or its samples; what unpacks it may fail as it likes.
TEST_F(Dicom, DamagedPackedSlicesGetTheirLine) {
    for (const auto& entry : std::filesystem::directory_iterator(packed_series)) {
        std::ifstream stream(entry.path(), std::ios::binary);
        const std::string whole{std::istreambuf_iterator<char>(stream), {}};
        for (std::size_t at = 140; at < whole.size(); at += 61) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
            for (const std::string& bytes : {damaged, whole.substr(0, at)}) {
                const auto read = read_volume_file(write("damaged/a.dcm", bytes), {});
                EXPECT_TRUE(read || read.error().find('\n') == std::string::npos) << at;
            }
        }
    }
}

}  // namespace
}  // namespace zeroset::test::dicom_test
