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
