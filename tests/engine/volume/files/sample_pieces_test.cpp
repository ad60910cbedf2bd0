#include "engine/volume/files/sample_pieces.hpp"

#include "tests/support/volume_files.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace zeroset::test::sample_pieces_test {
namespace {

constexpr std::size_t row = 4 * sizeof(std::int16_t);
constexpr std::size_t slice = 3 * row;

class SamplesInSeveralFiles : public VolumeFiles {
protected:
    [[nodiscard]] std::string nrrd(const std::string& data) const {
        return "NRRD0004\ntype: short\ndimension: 3\nsizes: 4 3 2\nendian: little\nencoding: "
               "raw\n" +
               data;
    }
    [[nodiscard]] std::string meta(const std::string& data) const {
        return "NDims = 3\nDimSize = 4 3 2\nElementType = MET_SHORT\nElementDataFile = " + data;
    }
    /// Writes the grid as slices, with `before` in front of each.
    void write_slices(const std::string& first, const std::string& second,
                      const std::string& before = "") {
        write(first, before + bytes_.substr(0, slice));
        write(second, before + bytes_.substr(slice));
    }

    std::string bytes_ = grid_bytes<std::int16_t>();
};

TEST_F(SamplesInSeveralFiles, NamesAreListed) {
    write_slices("one.raw", "two.raw", "xyz");
    expect_grid(write("a.nhdr", nrrd("byte skip: 3\ndata file: LIST\none.raw\ntwo.raw\n")));
    expect_grid(write("b.nhdr", nrrd("byte skip: -1\ndatafile: LIST 2\r\none.raw\r\ntwo.raw")));
    expect_grid(write("c.mhd", "HeaderSize = 3\n" + meta("LIST\none.raw\n two.raw \n")));
    expect_grid(write("d.mhd", "HeaderSize = -1\n" + meta("LIST 2\none.raw\ntwo.raw\n")));
}

TEST_F(SamplesInSeveralFiles, NamesAreCounted) {
    write_slices("s007.raw", "s009.raw");
    expect_grid(write("a.nhdr", nrrd("data file: s%03d.raw 7 9 2\n")));
    expect_grid(write("b.mhd", meta("s%03d.raw 7 10 2\n")));
    expect_grid(write("c.mhd", meta("s00%d.raw 7 9 2 2\n")));
    write_slices("t9.raw", "t 7.raw");
    EXPECT_EQ(error_of(write("d.nhdr", nrrd("data file: t%2u.raw 9 7 -2\n"))),
              "its file 't 9.raw': it cannot be read: No such file or directory");
    write("t 9.raw", bytes_.substr(0, slice));
    expect_grid(write("e.nhdr", nrrd("data file: t%2u.raw 9 7 -2\n")));
    write_slices("u-001.raw", "u0000.raw");
    expect_grid(write("f.mhd", meta("u%04i.raw -1 0 1\n")));
}

TEST_F(SamplesInSeveralFiles, FilesAreRowsOrSlabsToo) {
    std::string names;
    for (std::size_t n = 0; n < 6; ++n) {
        const std::string name = "r" + std::to_string(n);
        write(name, bytes_.substr(n * row, row));
        names += name + "\n";
    }
    expect_grid(write("a.nhdr", nrrd("data file: LIST 1\n" + names)));
    expect_grid(write("b.mhd", meta("r%d 0 5 1 1\n")));
    write("whole", bytes_);
    expect_grid(write("c.nhdr", nrrd("data file: LIST 3\nwhole\n")));
    write_slices("s1", "s2");
    expect_grid(write("d.nhdr", nrrd("data file: s%d 1 2 1 3\n")));
}

TEST_F(SamplesInSeveralFiles, EachMayBePacked) {
    write("one.gz", gzipped(bytes_.substr(0, slice)));
    write("two.gz", gzipped(bytes_.substr(slice)));
    expect_grid(write("a.mhd", "CompressedData = True\n" + meta("LIST\none.gz\ntwo.gz\n")));
}

TEST_F(SamplesInSeveralFiles, WhatIsWrongGetsItsLine) {
    write_slices("s1", "s2");
    const auto error = [&](const std::string& data) {
        return error_of(write("a.nhdr", nrrd("data file: " + data + "\n")));
    };
    EXPECT_EQ(error("LIST\ns1"), "its samples lie in 1 files; 2 are needed");
    EXPECT_EQ(error("LIST 1\ns1\ns2"), "its samples lie in 2 files; 6 are needed");
    EXPECT_EQ(error("LIST 4\ns1\ns2"), "its files have 4 axes each; the volume has 3");
    EXPECT_EQ(error("LIST 3\ns1\ns2\ns1"),
              "its samples lie in 3 files; they do not divide 2 slices evenly");
    EXPECT_EQ(error("s%d 1 2 0"), "its files are counted in steps that never come to the last one");
    EXPECT_EQ(error("s%d 1 2 -1"),
              "its files are counted in steps that never come to the last one");
    EXPECT_EQ(error("s%d 1 9000000000000000000 1"), "its files are counted beyond a million");
    EXPECT_EQ(error("s%d 1 1000000 1"), "its samples lie in 1000000 files; at most 65536 are read");
    EXPECT_EQ(error("s%d 1 3 1"), "its samples lie in 3 files; 2 are needed");
    EXPECT_EQ(error_of(write("a.mhd",
                             "NDims = 3\nDimSize = 4 4 0\nElementType = MET_SHORT\n"
                             "ElementDataFile = LIST\n")),
              "its samples lie in 0 files; 0 are needed");
    for (const std::string wrong : {"s%d", "s%d 1 two 1", "s%s 1 2 1", "s%d%d 1 2 1", "s% 1 2 1",
                                    "s%99999d 1 2 1", "LIST all\ns1\ns2"}) {
        EXPECT_TRUE(error(wrong).ends_with(
            "one name is wanted, LIST, or a name and its numbers: slice%03d.raw FIRST LAST STEP"))
            << error(wrong);
    }
    write("s2", "short");
    EXPECT_EQ(error("s%d 1 2 1"),
              "its file 's2': it is too short: 24 bytes of samples are announced, its 5 bytes "
              "cannot hold them");
}

}  // namespace
}  // namespace zeroset::test::sample_pieces_test
