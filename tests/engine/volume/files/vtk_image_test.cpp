#include "tests/support/volume_files.hpp"

#include <cstdint>
#include <limits>
#include <string>

namespace zeroset::test::vtk_image_test {
namespace {

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

/// Writers encode the header with the samples or apart, and break lines or not.
TEST_F(VolumeFiles, VtkImagesHaveBase64InAnyLayout) {
    const std::string grid = grid_bytes<std::int16_t>();
    const auto in_lines = [](const std::string& text) {
        std::string lines = "\n";
        for (std::size_t at = 0; at < text.size(); at += 10)
            lines += "  " + text.substr(at, 10) + "\r\n";
        return lines;
    };
    const std::string header = numbers_32({grid.size()});
    const std::string apart = base64(header) + base64(grid);
    const std::string together = base64(header + grid);
    const auto appended = [](const std::string& text) {
        return "<AppendedData encoding=\"base64\">\n  _" + text + "\n</AppendedData>";
    };
    int n = 0;
    for (const std::string& text : {apart, together, in_lines(apart), in_lines(together)}) {
        expect_grid(write(std::to_string(n) + "a.vti", vti("format=\"binary\"", text, "")));
        expect_grid(write(std::to_string(n++) + "b.vti",
                          vti("format=\"appended\" offset=\"0\"", "", appended(text))));
    }
    const std::string wide = numbers_32({grid.size(), 0});
    expect_grid(write("wide.vti", vti("format=\"binary\"", base64(wide) + base64(grid), "",
                                      " header_type=\"UInt64\"")));
}

/// A piece of the grid with the numbers in it, x from `first` to `last`.
std::string piece(int first, int last, const std::string& data = "PointData") {
    std::string text = "<Piece Extent=\"" + std::to_string(first) + " " + std::to_string(last) +
                       (data == "PointData" ? " 0 2 0 1" : " 0 3 0 2") + "\"><" + data +
                       "><DataArray type=\"Int16\" format=\"ascii\">";
    const int end = data == "PointData" ? last + 1 : last;
    for (int row = 0; row < 6; ++row) {
        for (int i = first; i < end; ++i)
            text += std::to_string(i + 10 * (row % 3) + 100 * (row / 3)) + " ";
    }
    return text + "</DataArray></" + data + "></Piece>";
}

TEST_F(VolumeFiles, VtkImagesMayLieInPieces) {
    const auto whole = [](const std::string& pieces) {
        return "<VTKFile><ImageData WholeExtent=\"-3 4 0 3 0 2\" Origin=\"5 6 7\" "
               "Spacing=\"1 2 3\">" +
               pieces + "</ImageData></VTKFile>";
    };
    const auto file = write("a.vti", whole(piece(1, 3) + piece(0, 1)));  // x = 1 is in both
    expect_grid(file);
    EXPECT_EQ(place_of(file).origin, (std::array<double, 3>{5, 6, 7}));
    expect_grid(write("b.vti", whole(piece(0, 0) + piece(1, 3))));
    expect_grid(write("c.vti", whole(piece(2, 4, "CellData") + piece(0, 2, "CellData"))));
    EXPECT_EQ(place_of(folder_ / "c.vti").origin, (std::array<double, 3>{5.5, 7, 8.5}));
    // One that is less than the file's whole grid is the grid.
    const auto one = open_volume(write("d.vti", whole(piece(2, 3))), {});
    ASSERT_TRUE(one.has_value()) << one.error();
    EXPECT_EQ((*one)->samples().size, (GridSize{2, 3, 2}));
    EXPECT_EQ((*one)->geometry().origin, (std::array<double, 3>{7, 6, 7}));
    EXPECT_EQ(sample_at(**one, 1, 2, 1), 123);
    EXPECT_EQ(error_of(write("e.vti", whole(piece(0, 1) + piece(3, 4)))),
              "its pieces leave points between them out");
    EXPECT_EQ(error_of(write("f.vti", whole(piece(0, 1) + piece(2, 3, "CellData")))),
              "it has no array of single numbers at its points or in its cells");
    std::string far = piece(2, 3);
    far.replace(far.find("2 3"), 3, "900000002 900000003");
    EXPECT_EQ(error_of(write("g.vti", whole(piece(0, 1) + far))),
              "its pieces leave points between them out");
}

TEST_F(VolumeFiles, VtkImagesMayHaveTheirNumbersInCells) {
    std::string numbers;
    for (std::uint64_t n = 0; n < 24; ++n)
        numbers += std::to_string(number_at(n % 4, n / 4 % 3, n / 12)) + " ";
    const auto file = write(
        "a.vti",
        "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 4 0 3 "
        "2 4\" "
        "Origin=\"5 6 7\" Spacing=\"1 2 4\"><Piece Extent=\"0 4 0 3 2 4\"><PointData/><CellData>"
        "<DataArray type=\"Int16\" Name=\"density\" format=\"ascii\">" +
            numbers + "</DataArray></CellData></Piece></ImageData></VTKFile>");
    expect_grid(file);
    EXPECT_EQ(place_of(file), (Geometry{.world_from_index = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 4}}},
                                        .origin = {5.5, 7, 17}}));
}

TEST_F(VolumeFiles, DamagedVtkImagesGetTheirLine) {
    const auto error = [&](const std::string& bytes) { return error_of(write("a.vti", bytes)); };
    EXPECT_EQ(error("<VTKFile").substr(0, 19), "its XML is damaged:");
    EXPECT_EQ(error("<VTKFile><PolyData/></VTKFile>"), "it holds no ImageData");
    const std::string least = std::to_string(std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(error("<VTKFile><ImageData WholeExtent=\"0 " + least + " 0 1 0 1\"/></VTKFile>"),
              "its 'WholeExtent' is '0 " + least + " 0 1 0 1'; six whole numbers are wanted");
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

}  // namespace
}  // namespace zeroset::test::vtk_image_test
