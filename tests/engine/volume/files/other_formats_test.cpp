#include "tests/support/volume_files.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

// MGH of FreeSurfer, MRC maps, and VTK's older files.

namespace zeroset::test::other_formats_test {
namespace {

/// Bytes with numbers put into them.
class Header {
public:
    Header(std::size_t size, bool big_endian) : bytes_(size, '\0'), big_endian_(big_endian) {}
    template <class Number>
    Header& put(std::size_t offset, Number number) {
        std::string raw(sizeof number, '\0');
        std::memcpy(raw.data(), &number, sizeof number);
        if (big_endian_) std::reverse(raw.begin(), raw.end());
        bytes_.replace(offset, raw.size(), raw);
        return *this;
    }
    template <class Number>
    Header& put_all(std::size_t offset, const std::vector<Number>& numbers) {
        for (std::size_t i = 0; i < numbers.size(); ++i)
            put(offset + sizeof(Number) * i, numbers[i]);
        return *this;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    bool big_endian_;
};

Header mgh(std::int32_t type) {
    Header header(284, true);
    return header.put_all<std::int32_t>(0, {1, 4, 3, 2, 1, type, 0});
}

TEST_F(VolumeFiles, MghIsReadWithItsPlace) {
    expect_grid(write("a.mgh", mgh(0).bytes() + grid_bytes<std::uint8_t>() + "tags"));
    expect_grid(write("b.mgz", gzipped(mgh(3).bytes() + grid_bytes<float>(true))));
    expect_grid(write("c.mgh.gz", gzipped(mgh(4).bytes() + grid_bytes<std::int16_t>(true))));
    expect_grid(write("d.mgz", mgh(1).bytes() + grid_bytes<std::int32_t>(true)));
    // Without a place: a coronal scan about 0
    EXPECT_EQ(place_of(folder_ / "a.mgh"),
              (Geometry{.world_from_index = {{{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}}},
                        .origin = {2, -1, 1.5}}));
    Header placed = mgh(0);
    placed.put<std::int16_t>(28, 1)
        .put_all<float>(30, {1, 2, 3})
        .put_all<float>(42, {0, 1, 0, 1, 0, 0, 0, 0, -1})
        .put_all<float>(78, {10, 20, 30});
    EXPECT_EQ(place_of(write("e.mgh", placed.bytes() + grid_bytes<std::uint8_t>())),
              (Geometry{.world_from_index = {{{0, 2, 0}, {1, 0, 0}, {0, 0, -3}}},
                        .origin = {7, 18, 33}}));
}

TEST_F(VolumeFiles, DamagedMghGetsItsLine) {
    EXPECT_EQ(error_of(write("a.mgh", "short")), "it does not begin with a header of MGH");
    EXPECT_EQ(error_of(write("a.mgh", mgh(2).bytes())),
              "its samples are of type 2 of the format; only single numbers are read");
    EXPECT_EQ(error_of(write("a.mgh", mgh(0).put<std::int32_t>(16, 9).bytes())),
              "it has 9 volumes; a volume has one number at each point");
    EXPECT_EQ(error_of(write("a.mgh", mgh(0).put<std::int32_t>(4, -4).bytes())),
              "its sizes 0 x 3 x 2 are no grid");
    EXPECT_EQ(error_of(write("a.mgh", mgh(3).bytes() + "1234")),
              "it is too short: 96 bytes of samples are announced, 4 bytes are there");
}

/// A map whose columns, rows and sections lead along z, x and y.
Header mrc(std::int32_t mode, bool big_endian = false) {
    Header header(1024, big_endian);
    header.put_all<std::int32_t>(0, {4, 3, 2, mode, 5, 6, 7, 8, 4, 2})
        .put_all<float>(40, {4, 8, 6, 90, 90, 90})
        .put_all<std::int32_t>(64, {3, 1, 2});
    const std::array<char, 8> stamp{'M', 'A', 'P', ' ', big_endian ? '\x11' : '\x44', '\x44', 0, 0};
    for (std::size_t i = 0; i < stamp.size(); ++i)
        header.put(208 + i, stamp[i]);
    return header;
}

TEST_F(VolumeFiles, MrcIsReadInAnyOrderOfAxes) {
    const auto file = write("a.mrc", mrc(0).bytes() + grid_bytes<std::int8_t>());
    expect_grid(file);
    // Steps of 4/8, 8/4 and 6/2 along x, y and z; columns begin at 5, rows at 6, sections at 7.
    EXPECT_EQ(place_of(file), (Geometry{.world_from_index = {{{0, 0.5, 0}, {0, 0, 2}, {3, 0, 0}}},
                                        .origin = {3, 14, 15}}));
    expect_grid(write("b.map", mrc(1, true).bytes() + grid_bytes<std::int16_t>(true)));
    expect_grid(write("c.map.gz", gzipped(mrc(2).bytes() + grid_bytes<float>())));
    // An origin, and a header that goes on
    const auto placed =
        write("d.ccp4", mrc(6).put_all<float>(196, {-1, -2, -3}).put<std::int32_t>(92, 5).bytes() +
                            "12345" + grid_bytes<std::uint16_t>());
    expect_grid(placed);
    EXPECT_EQ(place_of(placed).origin, (std::array<double, 3>{-1, -2, -3}));
    // A cell of three unequal angles: the vectors have the lengths and angles that it tells.
    const auto oblique = place_of(write(
        "g.mrc", mrc(0).put_all<float>(52, {80, 100, 110}).bytes() + grid_bytes<std::int8_t>()));
    const auto column = [&](std::size_t c) {
        const Matrix3& m = oblique.world_from_index;
        return glm::dvec3(m[0][c], m[1][c], m[2][c]);
    };
    const glm::dvec3 along_x = column(1);
    const glm::dvec3 along_y = column(2);
    const glm::dvec3 along_z = column(0);
    const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::degrees(std::acos(glm::dot(glm::normalize(a), glm::normalize(b))));
    };
    EXPECT_NEAR(glm::length(along_x), 0.5, 1e-12);
    EXPECT_NEAR(glm::length(along_y), 2, 1e-12);
    EXPECT_NEAR(glm::length(along_z), 3, 1e-12);
    EXPECT_NEAR(angle(along_y, along_z), 80, 1e-9);
    EXPECT_NEAR(angle(along_x, along_z), 100, 1e-9);
    EXPECT_NEAR(angle(along_x, along_y), 110, 1e-9);
    // IMOD's bytes have no sign unless it says so.
    Header imod = mrc(0);
    imod.put<std::int32_t>(152, 1146047817);
    const auto bytes = write("e.mrc", imod.bytes() + std::string(24, '\xF0'));
    EXPECT_EQ(sample_at(**open_volume(bytes, {}), 0, 0, 0), 240);
    const auto with_sign =
        write("f.mrc", imod.put<std::int32_t>(156, 1).bytes() + std::string(24, '\xF0'));
    EXPECT_EQ(sample_at(**open_volume(with_sign, {}), 0, 0, 0), -16);
}

TEST_F(VolumeFiles, DamagedMrcGetsItsLine) {
    EXPECT_EQ(error_of(write("a.map", std::string(2000, ' '))),
              "it does not begin with a header of MRC, which has MAP at byte 208");
    EXPECT_TRUE(
        error_of(write("a.mrc", mrc(4).bytes()))
            .starts_with("its samples are of mode 4 of the format; read are 0, 1, 2 and 6"));
    EXPECT_EQ(error_of(write("a.mrc", mrc(0).put<std::int32_t>(64, 1).bytes())),
              "its columns, rows and sections are not those of x, y and z");
    EXPECT_EQ(error_of(write("a.mrc", mrc(0).put(60, 180.0F).bytes() + grid_bytes<char>())),
              "its axes lie in one plane or are no finite numbers");
    EXPECT_EQ(error_of(write("a.mrc", mrc(2).bytes())),
              "it is too short: 96 bytes of samples are announced, 0 bytes are there");
}

std::string vtk(const std::string& encoding, const std::string& more) {
    return "# vtk DataFile Version 3.0\na title\n" + encoding +
           "\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 3 2\nSPACING 1 2 3\nORIGIN 5 6 7\n" + more;
}

TEST_F(VolumeFiles, OlderVtkFilesAreRead) {
    const auto file = write("a.vtk", vtk("BINARY",
                                         "POINT_DATA 24\nSCALARS density unsigned_short 1\n"
                                         "LOOKUP_TABLE default\n") +
                                         grid_bytes<std::uint16_t>(true));
    expect_grid(file);
    EXPECT_EQ(place_of(file), (Geometry{.world_from_index = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}},
                                        .origin = {5, 6, 7}}));
    expect_grid(write("b.vtk", vtk("BINARY", "\nPOINT_DATA 24\nscalars density float\n") +
                                   grid_bytes<float>(true)));
    expect_grid(
        write("c.vtk", vtk("BINARY", "POINT_DATA 24\nFIELD FieldData 1\ndensity 1 24 int\n") +
                           grid_bytes<std::int32_t>(true)));
    std::string numbers;
    for (std::uint64_t n = 0; n < 24; ++n)
        numbers += std::to_string(number_at(n % 4, n / 4 % 3, n / 12)) + (n % 7 == 6 ? "\n" : " ");
    expect_grid(write("d.vtk",
                      vtk("ASCII", "POINT_DATA 24\nSCALARS a double\nLOOKUP_TABLE x\n") + numbers));
    std::string cells = vtk("ASCII", "CELL_DATA 24\nSCALARS a char\nLOOKUP_TABLE x\n") + numbers;
    cells.replace(cells.find("4 3 2"), 5, "5 4 3");
    expect_grid(write("e.vtk", cells));
    EXPECT_EQ(place_of(folder_ / "e.vtk").origin, (std::array<double, 3>{5.5, 7, 8.5}));
}

TEST_F(VolumeFiles, OlderVtkFilesThatAreNoVolumesGetTheirLine) {
    const auto error = [&](const std::string& bytes) { return error_of(write("a.vtk", bytes)); };
    EXPECT_EQ(error("solid"), "it does not begin with '# vtk DataFile Version'");
    EXPECT_EQ(error("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n"),
              "its 'DATASET' is 'POLYDATA'; STRUCTURED_POINTS are read");
    EXPECT_EQ(error(vtk("ASCII", "POINT_DATA 24\nVECTORS v float\n1 2 3")),
              "its first array is one of vectors; a volume has one number at each point");
    EXPECT_EQ(error(vtk("ASCII", "POINT_DATA 24\nSCALARS c float 3\n")),
              "it has 3 numbers at each point; a volume has one");
    EXPECT_EQ(error(vtk("ASCII", "POINT_DATA 24\nSCALARS c bit\n")),
              "its 'type' is 'bit'; a number type is wanted");
    EXPECT_EQ(error(vtk("ASCII", "DIMENSIONS 4 3\n")),
              "its 'dimensions' is '4 3'; three numbers are wanted");
    EXPECT_EQ(error(vtk("ASCII", "POINT_DATA 24\n")),
              "its header lacks SCALARS, or an array of one number at each point");
    EXPECT_EQ(error(vtk("BINARY", "POINT_DATA 24\nSCALARS c short\n") + "1234"),
              "it is too short: 48 bytes of samples are announced, 4 bytes are there");
}

}  // namespace
}  // namespace zeroset::test::other_formats_test
