#include "engine/volume/files/volume_file.hpp"

#include "engine/volume/files/write_nrrd.hpp"
#include "tests/support/sample_field.hpp"
#include "tests/support/volume_files.hpp"

#include <bit>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace zeroset::test::volume_file_test {
namespace {

TEST_F(VolumeFiles, WhatIsWrittenIsReadBack) {
    const auto& data = sample_field()->data();
    const auto bytes = nrrd_bytes(data.samples(), data.geometry(), "two\nlines");
    const auto file = write("a.nrrd", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const auto again = open_volume(file, {});
    ASSERT_TRUE(again.has_value()) << again.error();
    EXPECT_EQ((*again)->geometry(), data.geometry());
    ASSERT_EQ((*again)->samples().size, data.samples().size);
    EXPECT_EQ(std::memcmp((*again)->samples().data.get(), data.samples().data.get(),
                          data.samples().count() * sizeof(double)),
              0);
    EXPECT_EQ(std::bit_cast<std::uintptr_t>((*again)->samples().data.get()) % 64, 0);
}

TEST_F(VolumeFiles, RawSamplesTakeTheirLayoutFromElsewhere) {
    RawLayout layout{.size = GridSize{4, 3, 2}, .type = SampleType::UInt16, .big_endian = true};
    layout.skip = 3;
    layout.spacing = {1, 2, 3};
    const auto file = write("a.raw", "abc" + grid_bytes<std::uint16_t>(true));
    expect_grid(file, layout);
    EXPECT_EQ((*open_volume(file, layout))->geometry().world_from_index[2][2], 3);
    layout.size = GridSize{4, 3, 3};
    EXPECT_EQ(error_of(file, layout),
              "it is too short: 72 bytes of samples are announced, 48 bytes are there");
    EXPECT_EQ(error_of(file), "it is read as raw samples only, of sizes that are typed behind it");
}

TEST_F(VolumeFiles, RawSamplesArePackedWhereTheirBytesSaySo) {
    RawLayout layout{.size = GridSize{4, 3, 2}, .type = SampleType::UInt16};
    const std::string grid = grid_bytes<std::uint16_t>();
    expect_grid(write("a.raw.GZ", gzipped(grid)), layout);
    expect_grid(write("b.gz", grid), layout);
    layout.size = GridSize{40, 30, 20};
    const auto large = open_volume(write("c.raw", gzipped(std::string(48000, '\1'))), layout);
    ASSERT_TRUE(large.has_value()) << large.error();
    EXPECT_EQ(sample_at(**large, 39, 29, 19), 257);
    // Samples that begin like a packed file
    layout = {.size = GridSize{4, 3, 2}};
    const auto plain = open_volume(write("d.raw", "\x1f\x8b" + std::string(22, '\0')), layout);
    ASSERT_TRUE(plain.has_value()) << plain.error();
    EXPECT_EQ(sample_at(**plain, 1, 0, 0), 139);
}

TEST_F(VolumeFiles, AnUnchangedFileIsReadOnce) {
    const std::string header =
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nencoding: raw\n\n";
    const auto file = write("a.nrrd", header + grid_bytes<std::uint8_t>());
    const auto first = open_volume(file, {});
    EXPECT_EQ(*open_volume(file, {}), *first);
    std::filesystem::last_write_time(
        file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
    EXPECT_NE(*open_volume(file, {}), *first);
}

TEST_F(VolumeFiles, AHeaderIsReadAgainOnceOneOfItsFilesOfSamplesHasChanged) {
    const auto one_slice = grid_bytes<std::uint8_t>().substr(0, 12);
    write("s0.raw", one_slice);
    const auto changed = write("s1.raw", one_slice);
    const std::string nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nencoding: raw\n";
    const std::string meta =
        "ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\n"
        "ElementType = MET_UCHAR\nElementDataFile = ";
    const std::vector files{write("a.nhdr", nrrd + "data file: LIST\ns0.raw\ns1.raw\n"),
                            write("b.mhd", meta + "s%d.raw 0 1 1\n"),
                            write("c.mhd", meta + "all.raw\n")};
    write("all.raw", one_slice + one_slice);
    for (const auto& file : files) {
        const auto first = open_volume(file, {});
        ASSERT_TRUE(first.has_value()) << first.error();
        EXPECT_EQ(*open_volume(file, {}), *first);
        const std::string name = file == files.back() ? "all.raw" : "s1.raw";
        write(name, name == "all.raw" ? std::string(24, 'a') : std::string(12, 'a'));
        std::filesystem::last_write_time(
            changed.parent_path() / name,
            std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
        EXPECT_NE(*open_volume(file, {}), *first);
        write("s1.raw", one_slice);
    }
}

}  // namespace
}  // namespace zeroset::test::volume_file_test
