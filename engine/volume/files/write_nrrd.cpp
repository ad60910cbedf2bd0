#include "engine/volume/files/write_nrrd.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cstring>

namespace zeroset {
namespace {

/// The shortest text that is read back as this number.
std::string number_text(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string vector_text(double x, double y, double z) {
    return "(" + number_text(x) + "," + number_text(y) + "," + number_text(z) + ")";
}

}  // namespace

std::string nrrd_header(SampleType type, const GridSize& size, const Geometry& geometry,
                        const std::string& content) {
    const Matrix3& m = geometry.world_from_index;
    std::string header =
        "NRRD0004\n# Complete NRRD file format specification at:\n"
        "# http://teem.sourceforge.net/nrrd/format.html\n";
    std::string line = content;
    for (char& c : line) {
        if (c == '\n' || c == '\r' || c == '\v') c = ' ';
    }
    header += "content: " + line + "\n";
    const std::string word(type == SampleType::Float    ? "float"
                           : type == SampleType::Double ? "double"
                                                        : name_of(type));
    header += "type: " + word + "\ndimension: 3\nspace dimension: 3\nsizes:";
    for (const std::uint64_t samples : size)
        header += " " + std::to_string(samples);
    header += "\nspace directions:";
    for (std::size_t c = 0; c < 3; ++c)
        header += " " + vector_text(m[0][c], m[1][c], m[2][c]);
    const auto& o = geometry.origin;
    header += "\nkinds: domain domain domain\nspace origin: " + vector_text(o[0], o[1], o[2]);
    const bool big_endian = std::endian::native == std::endian::big;
    header += std::string("\nendian: ") + (big_endian ? "big" : "little") + "\nencoding: raw\n";
    constexpr std::size_t alignment = 64;
    // A remark fills up the header, which ends in an empty line.
    const std::size_t rest = (header.size() + 3) % alignment;
    return header + "#" + std::string((alignment - rest) % alignment, ' ') + "\n\n";
}

std::vector<std::byte> nrrd_bytes(const Samples& samples, const Geometry& geometry,
                                  const std::string& content) {
    const std::string header = nrrd_header(samples.type, samples.size, geometry, content);
    const std::size_t bytes = samples.count() * size_of(samples.type);
    std::vector<std::byte> file(header.size() + bytes);
    std::memcpy(file.data(), header.data(), header.size());
    std::memcpy(file.data() + header.size(), samples.data.get(), bytes);
    return file;
}

}  // namespace zeroset
