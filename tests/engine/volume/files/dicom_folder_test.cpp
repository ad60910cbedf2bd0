#include "engine/volume/files/volume_file.hpp"
#include "tests/support/dicom_slice.hpp"
#include "tests/support/sample_field.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

// Folders as archives of hospitals fill them: with files that are no slices, with several series,
// with slices twice or not at all.

namespace zeroset::test::dicom_folder_test {
namespace {

using Slice = DicomTestSlice;

constexpr const char* structures = "1.2.840.10008.5.1.4.1.1.481.3";
constexpr const char* presentation = "1.2.840.10008.5.1.4.1.1.11.1";

/// A file without samples: up to the series' number.
std::string without_samples(const std::string& kind, const std::string& series) {
    const std::string whole = Slice{.k = 8, .series = series, .kind = kind}.bytes();
    return whole.substr(0, whole.find(element(0x20, 0x32, "DS", R"(0\0\16)")));
}

class DicomFolder : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        const auto file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }
    /// Four slices, changed by `change`.
    std::filesystem::path series(const std::string& folder, auto change) const {
        for (int k = 0; k < 4; ++k) {
            Slice slice{.k = k};
            change(slice);
            write(folder + "/" + std::to_string(k) + ".dcm", slice.bytes());
        }
        return folder_ / folder;
    }
    std::filesystem::path series(const std::string& folder) const {
        return series(folder, [](Slice&) {});
    }
    static std::string error_of(const std::filesystem::path& path) {
        const auto data = open_volume(path, {});
        return data ? "no error" : data.error();
    }
    static void expect_volume(const std::filesystem::path& path, double height = 2) {
        const auto data = open_volume(path, {});
        ASSERT_TRUE(data.has_value()) << data.error();
        ASSERT_EQ((*data)->samples().size, (GridSize{4, 3, 4}));
        for (std::uint64_t k = 0; k < 4; ++k)
            ASSERT_EQ(sample_at(**data, 3, 1, k), 13.0 + 100.0 * static_cast<double>(k));
        EXPECT_NEAR((*data)->geometry().world_from_index[2][2], height, 1e-12);
        EXPECT_EQ((*data)->geometry().world_from_index[0][0], -0.5);
    }

    TestFolder folder_;
};

TEST_F(DicomFolder, PassesOverFilesWithoutSamples) {
    const auto folder = series("all");
    write("all/RS", without_samples(structures, "1.2.3.5"));
    write("all/PR", without_samples(presentation, "1.2.3.4"));  // of the series itself
    const std::string directory = element(2, 2, "UI", "1.2.840.10008.1.3.10");
    write("all/DICOMDIR", std::string(128, '\0') + "DICM" + directory +
                              element(4, 0x1130, "CS", "A") + short_element(4, 0x1212, 0));
    for (const auto& path : {folder, folder / "2.dcm", folder / "DICOMDIR"})
        expect_volume(path);
    EXPECT_EQ(error_of(folder / "RS"),
              "it holds no samples: name a file of the series that it belongs to");
}

TEST_F(DicomFolder, IsNotJudgedByFilesOfOtherSeries) {
    const auto folder = series("ct");
    std::string broken = Slice{.k = 1, .series = "7.7", .frames = "many"}.bytes();
    write("ct/broken", broken.substr(0, broken.size() - 90));
    expect_volume(folder / "0.dcm");
    // A slice without its samples, and one that may be of any series
    const std::string whole = Slice{.k = 4}.bytes();
    write("ct/z", whole.substr(0, whole.find(element(0x20, 0x32, "DS", R"(0\0\8)"))));
    EXPECT_EQ(error_of(folder / "0.dcm").substr(0, 20), "'z' of the series: i");
    write("ct/z", whole.substr(0, 132));
    EXPECT_EQ(error_of(folder / "0.dcm").substr(0, 20), "'z' of the series: i");
}

TEST_F(DicomFolder, OffersItsSeries) {
    const auto folder = series("two", [](Slice& slice) { slice.description = "head"; });
    write("two/x", Slice{.k = 7, .series = "9.9"}.bytes());
    EXPECT_EQ(error_of(folder),
              "it holds 2 series: name a file of one of them, as '0.dcm' (CT, 'head', 4 slices) or "
              "'x' (CT, 1 slice)");
    for (int i = 0; i < 12; ++i)
        write("two/y" + std::to_string(i),
              Slice{.k = 9, .series = "9." + std::to_string(10 + i)}.bytes());
    EXPECT_TRUE(error_of(folder).ends_with(", and 6 more")) << error_of(folder);
}

TEST_F(DicomFolder, WithADirectoryHasItsSlicesBelow) {
    series("disk/DICOM/A/B");
    const auto top = write("disk/DICOMDIR", without_samples("1.2.840.10008.1.3.10", ""));
    expect_volume(folder_ / "disk");
    expect_volume(top);
    write("disk/DICOM/C/0", Slice{.k = 7, .series = "9.9"}.bytes());
    EXPECT_EQ(error_of(folder_ / "disk"),
              "it holds 2 series: name a file of one of them, as 'DICOM/A/B/0.dcm' (CT, 4 slices) "
              "or 'DICOM/C/0' (CT, 1 slice)");
}

TEST_F(DicomFolder, CountsAnInstanceOnce) {
    const auto folder = series("twice");
    for (int k = 1; k < 3; ++k)
        write("twice/copy" + std::to_string(k), Slice{.k = k, .description = "again"}.bytes());
    expect_volume(folder);
    // Another instance, or other samples under the number of one, is no copy.
    const std::string error = "two of its slices lie at one place, as ";
    write("twice/copy1", Slice{.k = 1, .instance = "5.5"}.bytes());
    EXPECT_TRUE(error_of(folder).starts_with(error)) << error_of(folder);
    write("twice/copy1", Slice{.k = 1, .add = 1}.bytes());
    EXPECT_TRUE(error_of(folder).starts_with(error)) << error_of(folder);
}

TEST_F(DicomFolder, ComparesNumbersWithinTheRoundingOfTheirTexts) {
    constexpr std::array places{"0", "0.67", "1.33", "2"};  // 2/3 mm apart
    constexpr std::array spacings{R"(3.0\0.5)", R"(3.000\0.500)", R"(3\0.5)", R"(2.98\0.50)"};
    expect_volume(series("rounded",
                         [&](Slice& slice) {
                             const auto k = static_cast<std::size_t>(slice.k);
                             slice.position = R"(0\0\)" + std::string(places[k]);
                             slice.spacing = spacings[k];
                         }),
                  2.0 / 3);
    // Numbers in steps of a power of ten
    expect_volume(series("powers",
                         [&](Slice& slice) {
                             constexpr std::array heights{"0", "3.3e1", "6.7e+1", "1.00E2"};
                             slice.position =
                                 R"(0\0\)" +
                                 std::string(heights[static_cast<std::size_t>(slice.k)]);
                         }),
                  100.0 / 3);
    const std::string problem = "it is turned or spaced otherwise than others";
    EXPECT_TRUE(error_of(series("spaced", [](Slice& slice) {
                    if (slice.k == 2) slice.spacing = R"(3\0.6)";
                })).ends_with(problem));
}

TEST_F(DicomFolder, NamesTheGap) {
    constexpr std::array heights{0, 2, 4, 8};
    EXPECT_EQ(error_of(series("gap",
                              [&](Slice& slice) {
                                  slice.position =
                                      R"(0\0\)" +
                                      std::to_string(heights[static_cast<std::size_t>(slice.k)]);
                              })),
              "its slices are not evenly spaced: below '3.dcm' lie 4 mm, elsewhere about 2 mm");
}

TEST_F(DicomFolder, ReadsFilesWithoutAPreamble) {
    for (int k = 0; k < 4; ++k)
        write("bare/" + std::to_string(k), Slice{.k = k}.data());
    expect_volume(folder_ / "bare");
    for (int k = 0; k < 4; ++k)
        write("bare/" + std::to_string(k), Slice{.k = k}.bytes().substr(132));
    expect_volume(folder_ / "bare");
    EXPECT_FALSE(is_volume_file(write("text", "no slice, but a text of some length")));
    EXPECT_FALSE(is_volume_file(write("zeros", std::string(200, '\0'))));
}

/// Elements without types, as older archives write them.
TEST_F(DicomFolder, ReadsFilesWithoutPreambleAndTypes) {
    const auto plain = [](unsigned group, unsigned number, std::string value) {
        if (value.size() % 2 != 0) value += ' ';
        return tag(group, number) + length_of(value.size()) + value;
    };
    const auto number = [](int value) { return bytes_of(static_cast<std::uint16_t>(value)); };
    for (int k = 0; k < 4; ++k) {
        const Slice slice{.k = k};
        // With a preface, in every second file, that says otherwise
        const std::string preface =
            std::string(128, '\0') + "DICM" + element(2, 0x10, "UI", "1.2.840.10008.1.2.1");
        write("old/" + std::to_string(k),
              (k % 2 == 0 ? "" : preface) + plain(8, 5, "ISO_IR 100") + plain(8, 0x16, slice.kind) +
                  plain(0x20, 0xe, slice.series) +
                  plain(0x20, 0x32, R"(0\0\)" + std::to_string(2 * k)) +
                  plain(0x20, 0x37, slice.orientation) + plain(0x28, 0x10, number(3)) +
                  plain(0x28, 0x11, number(4)) + plain(0x28, 0x30, slice.spacing) +
                  plain(0x28, 0x100, number(16)) + plain(0x28, 0x101, number(16)) +
                  plain(0x28, 0x103, number(0)) + plain(0x7fe0, 0x10, slice.samples()));
    }
    expect_volume(folder_ / "old");
}

TEST_F(DicomFolder, TakesTheBitsThatAreStored) {
    // Samples times 4, with three in the bits below, of 14 bits from bit 2 on
    const auto folder = series("high", [](Slice& slice) {
        slice.stored = 14;
        slice.high_bit = 15;
    });
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
        file.seekg(-24, std::ios::end);
        std::array<std::uint16_t, 12> samples{};
        file.read(reinterpret_cast<char*>(samples.data()), 24);
        for (std::uint16_t& sample : samples)
            sample = static_cast<std::uint16_t>(4 * sample + 3);
        file.seekp(-24, std::ios::end);
        file.write(reinterpret_cast<const char*>(samples.data()), 24);
    }
    expect_volume(folder);
}

TEST_F(DicomFolder, SaysThatSamplesAreColors) {
    const auto folder = series("colors");
    std::string bytes = Slice{.k = 1}.bytes();
    const std::string one = short_element(0x28, 2, 1);
    bytes.replace(bytes.find(one), one.size(), short_element(0x28, 2, 3));
    bytes.erase(bytes.find(element(0x20, 0x32, "DS", R"(0\0\2)")), 14);
    write("colors/1.dcm", bytes);
    EXPECT_EQ(error_of(folder),
              "'1.dcm' of the series: its samples are colors; a volume has one number at each "
              "point");
}

}  // namespace
}  // namespace zeroset::test::dicom_folder_test
