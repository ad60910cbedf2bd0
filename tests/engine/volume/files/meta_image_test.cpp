#include "tests/support/volume_files.hpp"

#include <cstdint>
#include <string>

namespace zeroset::test::meta_image_test {
namespace {

TEST_F(VolumeFiles, MetaImagesAreRead) {
    const std::string start =
        "ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\n"
        "ElementType = MET_SHORT\n";
    const std::string big = "BinaryDataByteOrderMSB = True\n";
    const std::string local = "ElementDataFile = LOCAL\n";
    expect_grid(write("a.mha", start + local + grid_bytes<std::int16_t>()));
    expect_grid(write("b.mha", start + big + local + grid_bytes<std::int16_t>(true)));
    const std::string packed = gzipped(grid_bytes<std::int16_t>());
    expect_grid(write("c.mha", start + "CompressedData = True\n" + local + packed));
    write("d.raw", "xyz" + grid_bytes<std::int16_t>());
    const auto apart = write("d.mhd", start + "HeaderSize = 3\nElementDataFile = d.raw\n");
    expect_grid(apart);
    const std::string place =
        "ElementSpacing = 1 2 3\nOffset = 5 6 7\n"
        "TransformMatrix = 0 1 0 -1 0 0 0 0 1\n";
    EXPECT_EQ(
        place_of(write("e.mha", start + place + local + grid_bytes<std::int16_t>())),
        (Geometry{.world_from_index = {{{0, -2, 0}, {1, 0, 0}, {0, 0, 3}}}, .origin = {5, 6, 7}}));
    EXPECT_EQ(place_of(write("f.mha", start + place + "AnatomicalOrientation = RAI\n" + local +
                                          grid_bytes<std::int16_t>())),
              (Geometry{.world_from_index = {{{0, 2, 0}, {-1, 0, 0}, {0, 0, 3}}},
                        .origin = {-5, -6, 7}}));
}

TEST_F(VolumeFiles, MetaImagesMayHaveMoreAxesOfOneSample) {
    const std::string start =
        "NDims = 5\nDimSize = 4 3 2 1 1\nElementType = MET_SHORT\n"
        "ElementSpacing = 1 2 3 9 9\nOffset = 5 6 7 9 9\n"
        "TransformMatrix = 0 1 0 9 9 -1 0 0 9 9 0 0 1 9 9 9 9 9 1 0 9 9 9 0 1\n";
    const auto file =
        write("a.mha", start + "ElementDataFile = LOCAL\n" + grid_bytes<std::int16_t>());
    expect_grid(file);
    EXPECT_EQ(place_of(file), (Geometry{.world_from_index = {{{0, -2, 0}, {1, 0, 0}, {0, 0, 3}}},
                                        .origin = {5, 6, 7}}));
}

TEST_F(VolumeFiles, MetaImagesMayHaveAnySignsInNames) {
    const std::string start = "DimSize = 4 3 2\nElementType = MET_SHORT\nElementDataFile = ";
    for (const std::string name : {"50% of it.raw", "%d.raw", "a%02d.raw 1 2 1"}) {
        write(name, grid_bytes<std::int16_t>());
        expect_grid(write("a.mhd", start + name + "\n"));
    }
}

TEST_F(VolumeFiles, DamagedMetaImagesGetTheirLine) {
    const auto error = [&](const std::string& bytes) { return error_of(write("a.mha", bytes)); };
    EXPECT_EQ(error("ObjectType = Image\n"), "its header lacks ElementDataFile");
    EXPECT_EQ(error("what is this\n"), "its header has a line without '='");
    EXPECT_EQ(error("DimSize = 4 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n"),
              "it is a picture of 4 x 3 samples, no volume");
    EXPECT_EQ(error("DimSize = 4 3 2 2\nElementType = MET_SHORT\nElementDataFile = LOCAL\n"),
              "it has 4 x 3 x 2 x 2 samples; a volume has three axes and one number at each point");
    EXPECT_EQ(error("DimSize = 4\v3\x1b[2J\nElementType = MET_SHORT\nElementDataFile = LOCAL\n"),
              "its 'DimSize' is '4\uFFFD3\uFFFD[2J'; three whole numbers are wanted");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementType = MET_STRING\nElementDataFile = LOCAL\n"),
              "its 'ElementType' is 'MET_STRING'; a number type is wanted");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementNumberOfChannels = 3\nElementType = MET_SHORT\n"
                    "ElementDataFile = LOCAL\n"),
              "it has 3 numbers at each point; a volume has one");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementType = MET_SHORT\nElementDataFile = none.raw\n"),
              "its file 'none.raw': it cannot be read: No such file or directory");
    EXPECT_EQ(error("DimSize = 4 3 2 1\nElementSpacing = 1 2 3\nElementType = MET_SHORT\n"
                    "ElementDataFile = LOCAL\n"),
              "its 'elementspacing' is '1 2 3'; 4 numbers are wanted");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementSpacing = 1 2\nElementType = MET_SHORT\n"
                    "ElementDataFile = LOCAL\n"),
              "its 'elementspacing' is '1 2'; 3 numbers are wanted");
}

}  // namespace
}  // namespace zeroset::test::meta_image_test
