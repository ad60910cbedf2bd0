#include "engine/volume/files/volume_file.hpp"

#include "engine/volume/files/write_nrrd.hpp"
#include "tests/support/sample_field.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace zeroset::test {
namespace {

/// The sample at (i, j, k) of the grids here, 4 x 3 x 2.
int number_at(std::uint64_t i, std::uint64_t j, std::uint64_t k) {
    return static_cast<int>(i + 10 * j + 100 * k);
}

template <class Sample>
std::string grid_bytes(bool big_endian = false) {
    std::string bytes;
    for (std::uint64_t k = 0; k < 2; ++k) {
        for (std::uint64_t j = 0; j < 3; ++j) {
            for (std::uint64_t i = 0; i < 4; ++i) {
                const auto sample = static_cast<Sample>(number_at(i, j, k));
                std::string raw(sizeof sample, '\0');
                std::memcpy(raw.data(), &sample, sizeof sample);
                if (big_endian) std::reverse(raw.begin(), raw.end());
                bytes += raw;
            }
        }
    }
    return bytes;
}

std::string gzipped(const std::string& bytes) {
    const TestFolder folder;
    const std::string path = (folder / "a.gz").string();
    const gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class VolumeFiles : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    static void expect_grid(const std::filesystem::path& file, const RawLayout& layout = {}) {
        const auto data = open_volume(file, layout);
        ASSERT_TRUE(data.has_value()) << file.filename() << ": " << data.error();
        ASSERT_EQ((*data)->samples().size, (GridSize{4, 3, 2})) << file.filename();
        for (std::uint64_t k = 0; k < 2; ++k) {
            for (std::uint64_t j = 0; j < 3; ++j) {
                for (std::uint64_t i = 0; i < 4; ++i)
                    ASSERT_EQ(sample_at(**data, i, j, k), number_at(i, j, k)) << file.filename();
            }
        }
    }
    static Geometry place_of(const std::filesystem::path& file) {
        const auto data = open_volume(file, {});
        EXPECT_TRUE(data.has_value()) << data.error();
        return data ? (*data)->geometry() : Geometry{};
    }
    static std::string error_of(const std::filesystem::path& file, const RawLayout& layout = {}) {
        const auto data = open_volume(file, layout);
        return data ? "no error" : data.error();
    }

    TestFolder folder_;
};

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

TEST_F(VolumeFiles, DamagedMetaImagesGetTheirLine) {
    const auto error = [&](const std::string& bytes) { return error_of(write("a.mha", bytes)); };
    EXPECT_EQ(error("ObjectType = Image\n"), "its header lacks ElementDataFile");
    EXPECT_EQ(error("what is this\n"), "its header has a line without '='");
    EXPECT_EQ(error("DimSize = 4 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n"),
              "its 'DimSize' is '4 3'; three whole numbers are wanted");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementType = MET_STRING\nElementDataFile = LOCAL\n"),
              "its 'ElementType' is 'MET_STRING'; a number type is wanted");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementNumberOfChannels = 3\nElementType = MET_SHORT\n"
                    "ElementDataFile = LOCAL\n"),
              "it has 3 numbers at each point; a volume has one");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementType = MET_SHORT\nElementDataFile = none.raw\n"),
              "it cannot be read: No such file or directory");
    EXPECT_EQ(error("DimSize = 4 3 2\nElementSpacing = 1 2\nElementType = MET_SHORT\n"
                    "ElementDataFile = LOCAL\n"),
              "its 'elementspacing' is '1 2'; 3 numbers are wanted");
}

/// A header of NIfTI-1 with the numbers that matter.
class NiftiHeader {
public:
    explicit NiftiHeader(std::int16_t datatype, bool big_endian = false)
        : bytes_(352, '\0'), big_endian_(big_endian) {
        put<std::int32_t>(0, 348);
        const std::vector<std::int16_t> dim{3, 4, 3, 2, 1, 1, 1, 1};
        for (std::size_t i = 0; i < dim.size(); ++i)
            put(40 + 2 * i, dim[i]);
        put(70, datatype);
        put(108, 352.0F);
        bytes_.replace(344, 3, "n+1");
    }
    template <class Number>
    NiftiHeader& put(std::size_t offset, Number number) {
        std::string raw(sizeof number, '\0');
        std::memcpy(raw.data(), &number, sizeof number);
        if (big_endian_) std::reverse(raw.begin(), raw.end());
        bytes_.replace(offset, raw.size(), raw);
        return *this;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    bool big_endian_;
};

TEST_F(VolumeFiles, NiftiIsRead) {
    expect_grid(write("a.nii", NiftiHeader(4).bytes() + grid_bytes<std::int16_t>()));
    expect_grid(write("b.nii", NiftiHeader(16, true).bytes() + grid_bytes<float>(true)));
    const std::string whole = NiftiHeader(512).bytes() + grid_bytes<std::uint16_t>();
    expect_grid(write("c.nii.gz", gzipped(whole)));
    std::string header = NiftiHeader(2).put(108, 0.0F).bytes();
    header.replace(344, 3, "ni1");
    write("d.img", grid_bytes<std::uint8_t>());
    expect_grid(write("d.hdr", header));
}

TEST_F(VolumeFiles, NiftiTellsItsPlaceAndScale) {
    NiftiHeader header(4);
    for (std::size_t i = 0; i < 4; ++i)
        header.put(76 + 4 * i, i == 0 ? 1.0F : static_cast<float>(i));
    const auto file = [&](const std::string& name) {
        return write(name, header.bytes() + grid_bytes<std::int16_t>());
    };
    EXPECT_EQ(place_of(file("a.nii")),
              (Geometry{.world_from_index = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}, .origin = {}}));
    // A half turn about z, and the third axis flipped
    header.put<std::int16_t>(252, 1).put(76, -1.0F).put(264, 1.0F).put(268, 5.0F).put(272, 6.0F);
    EXPECT_EQ(place_of(file("b.nii")),
              (Geometry{.world_from_index = {{{-1, 0, 0}, {0, -2, 0}, {0, 0, -3}}},
                        .origin = {5, 6, 0}}));
    const std::vector<float> rows{0, 2, 0, 10, 3, 0, 0, 20, 0, 0, 4, 30};
    header.put<std::int16_t>(254, 1);
    for (std::size_t i = 0; i < rows.size(); ++i)
        header.put(280 + 4 * i, rows[i]);
    EXPECT_EQ(place_of(file("c.nii")),
              (Geometry{.world_from_index = {{{0, 2, 0}, {3, 0, 0}, {0, 0, 4}}},
                        .origin = {10, 20, 30}}));
    header.put(112, 2.0F).put(116, -7.0F);
    const auto data = open_volume(file("d.nii"), {});
    ASSERT_TRUE(data.has_value()) << data.error();
    EXPECT_EQ(sample_at(**data, 3, 2, 1), 2 * 123 - 7);
}

/// Nothing is rounded on the way: to double where floats do not hold what was scaled.
TEST_F(VolumeFiles, ScaledNiftiIsExact) {
    const auto scaled = [&](const std::string& name, float slope, float shift) {
        NiftiHeader header(4);
        header.put(112, slope).put(116, shift);
        return open_volume(write(name, header.bytes() + grid_bytes<std::int16_t>()), {}).value();
    };
    const auto halves = scaled("halves.nii", 0.5F, -1024.0F);
    EXPECT_EQ(halves->samples().type, SampleType::Float);
    EXPECT_EQ(sample_at(*halves, 3, 2, 1), 123 / 2.0 - 1024);
    const auto thirds = scaled("thirds.nii", 1.0F / 3.0F, 0.1F);
    EXPECT_EQ(thirds->samples().type, SampleType::Double);
    EXPECT_EQ(sample_at(*thirds, 3, 2, 1),
              123 * static_cast<double>(1.0F / 3.0F) + static_cast<double>(0.1F));
}

TEST_F(VolumeFiles, DamagedNiftiGetsItsLine) {
    const auto error = [&](const std::string& bytes) { return error_of(write("a.nii", bytes)); };
    EXPECT_EQ(error("no header"), "it does not begin with a header of NIfTI");
    EXPECT_EQ(error(NiftiHeader(128).bytes()),
              "its samples are of type 128 of the format; only single numbers of up to 64 bits are "
              "read");
    EXPECT_EQ(error(NiftiHeader(4).put<std::int16_t>(40, 1).bytes()),
              "it has 1 axes; a volume has three");
    EXPECT_EQ(error(NiftiHeader(4).put<std::int16_t>(40, 4).put<std::int16_t>(48, 2).bytes()),
              "it has several volumes or numbers at each point; a volume has one");
    EXPECT_EQ(error(NiftiHeader(4).put<std::int16_t>(42, -5).bytes()),
              "its sizes 0 x 3 x 2 are no grid");
    EXPECT_EQ(error(NiftiHeader(4).put(108, -1.0F).bytes()), "its 'vox_offset' is no place in it");
    EXPECT_EQ(error(NiftiHeader(4).bytes() + "12"),
              "it is too short: 48 bytes of samples are announced, 2 bytes are there");
}

std::string base64(const std::string& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const char c = at + i < bytes.size() ? bytes[at + i] : '\0';
            bits = bits << 8U | static_cast<unsigned char>(c);
        }
        for (unsigned i = 0; i < 4; ++i)
            text += at + i > bytes.size() ? '=' : digits[bits >> (18 - 6 * i) & 63U];
    }
    return text;
}

std::string numbers_32(std::initializer_list<std::size_t> numbers) {
    std::string bytes;
    for (const std::size_t number : numbers) {
        for (unsigned i = 0; i < 4; ++i)
            bytes += static_cast<char>(number >> 8 * i & 0xFFU);
    }
    return bytes;
}

/// A VTI file with one array and what stands in it and behind it.
std::string vti(const std::string& array, const std::string& inside, const std::string& appended,
                const std::string& more = "") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"" +
           more +
           ">\n<ImageData WholeExtent=\"1 4 0 2 0 1\" Origin=\"5 6 7\" Spacing=\"1 2 3\">\n"
           "<Piece Extent=\"1 4 0 2 0 1\"><PointData Scalars=\"density\">\n"
           "<DataArray type=\"Float32\" Name=\"v\" NumberOfComponents=\"3\" format=\"ascii\">1 2 3"
           "</DataArray>\n<DataArray type=\"Int16\" Name=\"density\" " +
           array + ">" + inside + "</DataArray></PointData></Piece></ImageData>\n" + appended +
           "</VTKFile>\n";
}

TEST_F(VolumeFiles, VtkImagesAreRead) {
    const std::string grid = grid_bytes<std::int16_t>();
    const std::string headed = numbers_32({grid.size()}) + grid;
    std::string text;
    for (std::uint64_t n = 0; n < 24; ++n)
        text += std::to_string(number_at(n % 4, n / 4 % 3, n / 12)) + " ";
    expect_grid(write("a.vti", vti("format=\"ascii\"", text, "")));
    expect_grid(write("b.vti", vti("format=\"binary\"", "\n" + base64(headed) + "\n", "")));
    const std::string appended = "format=\"appended\" offset=\"3\"";
    expect_grid(write(
        "c.vti",
        vti(appended, "", "<AppendedData encoding=\"raw\">\n_xyz" + headed + "</AppendedData>")));
    expect_grid(write(
        "d.vti", vti("format=\"appended\" offset=\"0\"", "",
                     "<AppendedData encoding=\"base64\">_" + base64(headed) + "</AppendedData>")));
    const auto packed_part = [](const std::string& bytes) {
        std::string packed(compressBound(bytes.size()), '\0');
        uLongf size = packed.size();
        compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
        return packed.substr(0, size);
    };
    const std::string first = packed_part(grid.substr(0, 32));
    const std::string second = packed_part(grid.substr(32));
    const std::string header = numbers_32({2, 32, grid.size() - 32, first.size(), second.size()});
    const std::string zlib = " compressor=\"vtkZLibDataCompressor\"";
    expect_grid(write("e.vti",
                      vti("format=\"binary\"", base64(header) + base64(first + second), "", zlib)));
    const auto file = write("f.vti", vti("format=\"appended\" offset=\"0\"", "",
                                         "<AppendedData encoding=\"raw\">_" + header + first +
                                             second + "</AppendedData>",
                                         zlib));
    expect_grid(file);
    EXPECT_EQ(place_of(file), (Geometry{.world_from_index = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}},
                                        .origin = {6, 6, 7}}));
}

TEST_F(VolumeFiles, DamagedVtkImagesGetTheirLine) {
    const auto error = [&](const std::string& bytes) { return error_of(write("a.vti", bytes)); };
    EXPECT_EQ(error("<VTKFile").substr(0, 19), "its XML is damaged:");
    EXPECT_EQ(error("<VTKFile><PolyData/></VTKFile>"), "it holds no ImageData");
    const std::string headed = numbers_32({48}) + grid_bytes<std::int16_t>();
    EXPECT_EQ(error(vti("format=\"binary\"", base64(headed.substr(0, 20)), "")),
              "it is too short: 48 bytes of samples are announced, 16 bytes are there");
    EXPECT_EQ(error(vti("format=\"binary\"", "?", "")), "its data are damaged or cut off");
    EXPECT_EQ(error(vti("format=\"appended\" offset=\"9\"", "", "")),
              "its header announces data that it lacks");
    EXPECT_EQ(error(vti("format=\"binary\"", base64(numbers_32({4000000000, 8, 8})), "",
                        " compressor=\"vtkZLibDataCompressor\"")),
              "its data are damaged or cut off");
    EXPECT_EQ(error(vti("format=\"binary\"", "", "", " compressor=\"vtkLZ4DataCompressor\"")),
              "its 'compressor' is 'vtkLZ4DataCompressor'; only zlib is read");
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

TEST_F(VolumeFiles, AnUnchangedFileIsReadOnce) {
    const std::string raw = "encoding: raw\n";
    const auto file = write("a.nrrd", nrrd("uchar", raw) + grid_bytes<std::uint8_t>());
    const auto first = open_volume(file, {});
    EXPECT_EQ(*open_volume(file, {}), *first);
    std::filesystem::last_write_time(
        file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
    EXPECT_NE(*open_volume(file, {}), *first);
}

}  // namespace
}  // namespace zeroset::test
