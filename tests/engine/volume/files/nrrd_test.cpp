#include "tests/support/volume_files.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace zeroset::test::nrrd_test {
namespace {

std::string nrrd(const std::string& type, const std::string& more,
                 const std::string& sizes = "4 3 2") {
    return "NRRD0004\n# a remark\ntype: " + type + "\ndimension: 3\nsizes: " + sizes + "\n" + more +
           "\n";
}

TEST_F(VolumeFiles, NrrdHoldsAllNumberTypes) {
    const std::string raw = "encoding: raw\nendian: little\n";
    expect_grid(write("a.nrrd", nrrd("signed char", raw) + grid_bytes<std::int8_t>()));
    expect_grid(write("b.nrrd", nrrd("uchar", raw) + grid_bytes<std::uint8_t>()));
    expect_grid(write("c.nrrd", nrrd("short", raw) + grid_bytes<std::int16_t>()));
    expect_grid(write("d.nrrd", nrrd("unsigned short", raw) + grid_bytes<std::uint16_t>()));
    expect_grid(write("e.nrrd", nrrd("int32_t", raw) + grid_bytes<std::int32_t>()));
    expect_grid(write("f.nrrd", nrrd("uint", raw) + grid_bytes<std::uint32_t>()));
    expect_grid(write("g.nrrd", nrrd("long long int", raw) + grid_bytes<std::int64_t>()));
    expect_grid(write("h.nrrd", nrrd("uint64", raw) + grid_bytes<std::uint64_t>()));
    expect_grid(write("i.nrrd", nrrd("float", raw) + grid_bytes<float>()));
    expect_grid(write("j.nrrd", nrrd("double", raw) + grid_bytes<double>()));
}

TEST_F(VolumeFiles, NrrdHoldsBothByteOrdersAndAllEncodings) {
    const std::string big = "encoding: raw\nendian: big\n";
    expect_grid(write("a.nrrd", nrrd("short", big) + grid_bytes<std::int16_t>(true)));
    expect_grid(write("b.nrrd", nrrd("double", big) + grid_bytes<double>(true)));
    const std::string packed = "encoding: gzip\nendian: big\n";
    expect_grid(write("c.nrrd", nrrd("float", packed) + gzipped(grid_bytes<float>(true))));
    std::string text;
    for (std::uint64_t n = 0; n < 24; ++n)
        text += std::to_string(number_at(n % 4, n / 4 % 3, n / 12)) + (n % 4 == 3 ? "\n" : " ");
    expect_grid(write("d.nrrd", nrrd("int", "encoding: ascii\n") + text));
}

TEST_F(VolumeFiles, NrrdMayHaveItsSamplesElsewhere) {
    write("samples.raw", "12345" + grid_bytes<std::int16_t>());
    const std::string raw = "encoding: raw\nendian: little\ndata file: samples.raw\n";
    expect_grid(write("a.nhdr", nrrd("short", raw + "byte skip: 5\n")));
    expect_grid(write("b.nhdr", nrrd("short", raw + "byte skip: -1\n")));
    write("lines.raw", "one\ntwo\n" + grid_bytes<std::int16_t>());
    expect_grid(write("c.nhdr", nrrd("short",
                                     "encoding: raw\nendian: little\ndatafile: lines.raw\n"
                                     "line skip: 2\n")));
}

TEST_F(VolumeFiles, NrrdTellsItsPlaceAsRas) {
    const auto with = [&](const std::string& name, const std::string& more) {
        return place_of(
            write(name, nrrd("uchar", "encoding: raw\n" + more) + grid_bytes<std::uint8_t>()));
    };
    EXPECT_EQ(
        with("a.nrrd", "spacings: 2 3 nan\naxis mins: -1 -2 nan\n"),
        (Geometry{.world_from_index = {{{2, 0, 0}, {0, 3, 0}, {0, 0, 1}}}, .origin = {-1, -2, 0}}));
    EXPECT_EQ(with("s.nrrd",
                   "space: 3D-left-handed\nspacings: 2 3 4\nspace directions: none none none\n"),
              (Geometry{.world_from_index = {{{2, 0, 0}, {0, 3, 0}, {0, 0, 4}}}, .origin = {}}));
    // From the ends of its axes: of the cells around samples, or the samples themselves
    const std::string ends = "axis mins: -4 0 10\naxis maxs: 4 6 6\n";
    EXPECT_EQ(
        with("e.nrrd", ends),
        (Geometry{.world_from_index = {{{2, 0, 0}, {0, 2, 0}, {0, 0, -2}}}, .origin = {-3, 1, 9}}));
    EXPECT_EQ(with("f.nrrd", ends + "centers: node node cell\n").world_from_index,
              (Matrix3{{{8.0 / 3, 0, 0}, {0, 3, 0}, {0, 0, -2}}}));
    EXPECT_EQ(with("g.nrrd", ends + "centerings: node node cell\n").origin,
              (std::array<double, 3>{-4, 0, 9}));
    EXPECT_EQ(with("h.nrrd", "spacings: 2 3 4\naxis mins: 0 0 0\ncenters: cell node ???\n").origin,
              (std::array<double, 3>{1, 0, 0}));
    const std::string turned =
        "space directions: (0, 2, 0) (3,0,0) (0,0,4)\nspace origin: (7,8,9)\n";
    EXPECT_EQ(
        with("b.nrrd", "space: right-anterior-superior\n" + turned),
        (Geometry{.world_from_index = {{{0, 3, 0}, {2, 0, 0}, {0, 0, 4}}}, .origin = {7, 8, 9}}));
    EXPECT_EQ(with("c.nrrd", "space: left-posterior-superior\n" + turned),
              (Geometry{.world_from_index = {{{0, -3, 0}, {-2, 0, 0}, {0, 0, 4}}},
                        .origin = {-7, -8, 9}}));
}

TEST_F(VolumeFiles, DamagedNrrdGetsItsLine) {
    const std::string raw = "encoding: raw\nendian: little\n";
    const auto error = [&](const std::string& bytes) { return error_of(write("a.nrrd", bytes)); };
    EXPECT_EQ(error("P6\n"), "it does not begin with NRRD000");
    EXPECT_EQ(error("NRRD0004"), "its header ends in its first line");
    EXPECT_EQ(error(nrrd("short", raw) + "1234"),
              "it is too short: 48 bytes of samples are announced, 4 bytes are there");
    EXPECT_EQ(error(nrrd("short", raw, "999999 999999 999999") + "1234"),
              "it is too short: 1999994000005999998 bytes of samples are announced, 4 bytes are "
              "there");
    EXPECT_EQ(error(nrrd("short", raw, "4294967296 4294967296 4294967296") + "1234"),
              "its sizes 4294967296 x 4294967296 x 4294967296 are no grid");
    EXPECT_EQ(error(nrrd("short", raw, "0 3 2")), "its sizes 0 x 3 x 2 are no grid");
    EXPECT_EQ(error(nrrd("short", raw, "4 -3 2")),
              "its 'sizes' is '4 -3 2'; whole numbers are wanted");
    EXPECT_EQ(error(nrrd("short", raw, "3 4 3 2")),
              "it has 3 x 4 x 3 x 2 samples; a volume has three axes and one number at each point");
    EXPECT_EQ(error(nrrd("uchar", raw + "kinds: domain space vector\n")),
              "its axis 3 is of kind 'vector'; a volume has one number at each point");
    EXPECT_EQ(
        error(nrrd("uchar", raw + "kinds: RGBA-color domain domain\n")),
        "it is a picture in colors: its axis 1 is of kind 'RGBA-color'; a volume has one number "
        "at each point");
    EXPECT_EQ(
        error(nrrd("uchar", raw + "kinds: RGB-color domain domain domain\n", "3 4 3 2")),
        "its samples are colors: its axis 1 is of kind 'RGB-color'; a volume has one number at "
        "each point");
    EXPECT_EQ(error(nrrd("uchar", raw, "4 6")), "it is a picture of 4 x 6 samples, no volume");
    EXPECT_EQ(error(nrrd("block", raw)), "its 'type' is 'block'; a number type is wanted");
    EXPECT_EQ(error(nrrd("short", "encoding: raw\n") + grid_bytes<short>()),
              "its header lacks 'endian: little' or 'endian: big'");
    EXPECT_EQ(error(nrrd("short", "encoding: bzip2\nendian: little\n")),
              "its 'encoding' is 'bzip2'; raw, gzip and ascii are read");
    const std::string packed = gzipped(grid_bytes<short>());
    const std::string gzip = nrrd("short", "encoding: gzip\nendian: little\n");
    EXPECT_EQ(error(gzip + packed.substr(0, packed.size() / 2)).substr(0, 42),
              "its packed data are damaged or cut off: 48");
    EXPECT_EQ(error(nrrd("short", "encoding: gzip\nendian: little\n", "40000 40000 40000") + packed)
                  .substr(0, 21),
              "it is too short: 1280");
    EXPECT_EQ(error(nrrd("int", "encoding: ascii\n") + "1 2 x " + std::string(60, '1')),
              "'x' is no int32");
    EXPECT_EQ(error(nrrd("uchar", "encoding: raw\nspace directions: (1,0,0) (2,0,0) (0,0,1)\n") +
                    grid_bytes<std::uint8_t>()),
              "its axes lie in one plane or are no finite numbers");
    EXPECT_EQ(error_of(folder_ / "missing.nrrd"), "there is no such file");
    EXPECT_EQ(error_of(folder_.path()), "it is no file");
}

}  // namespace
}  // namespace zeroset::test::nrrd_test
