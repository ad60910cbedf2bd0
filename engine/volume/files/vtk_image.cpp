// VTI, the image data of VTK in XML
// (docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html).

#include "engine/volume/files/base64.hpp"
#include "engine/volume/files/grid_pieces.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/mapped_file.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The XML of a file, without what is appended to it.
struct VtkText {
    std::string xml;
    std::uint64_t appended = 0;  ///< where the appended data begin in the file; 0: there are none
    bool appended_raw = false;   ///< they are bytes, not base64
};

Expected<VtkText> read_text(const std::filesystem::path& file) {
    constexpr std::size_t usual_header = 1U << 20U;
    constexpr std::string_view tag = "<AppendedData";
    auto text = first_bytes(file, usual_header);
    if (!text) return std::unexpected(text.error());
    std::size_t at = text->find(tag);
    if (at == std::string::npos && text->size() == usual_header) {
        text = first_bytes(file, std::numeric_limits<std::ptrdiff_t>::max());
        if (!text) return std::unexpected(text.error());
        at = text->find(tag);
    }
    if (at == std::string::npos) return VtkText{.xml = std::move(*text)};
    const std::size_t mark = text->find('_', at);
    if (mark == std::string::npos) return std::unexpected("its AppendedData do not begin with '_'");
    VtkText result{.xml = text->substr(0, at) + "</VTKFile>", .appended = mark + 1};
    result.appended_raw = text->substr(at, mark - at).contains("raw");
    return result;
}

/// How an array's bytes are written.
struct Coding {
    bool big_endian = false;
    bool long_header = false;  ///< numbers of 8 bytes
    bool packed = false;       ///< by zlib, in blocks

    [[nodiscard]] std::size_t width() const { return long_header ? 8 : 4; }
    [[nodiscard]] std::uint64_t number(std::string_view bytes, std::size_t index) const {
        if (long_header)
            return static_cast<std::uint64_t>(
                number_at<std::int64_t>(bytes, 8 * index, big_endian));
        return static_cast<std::uint32_t>(number_at<std::int32_t>(bytes, 4 * index, big_endian));
    }
};

constexpr const char* damaged = "its data are damaged or cut off";

/// The bytes of an array of base64, behind the header that tells their length unless that is of
/// packed blocks. The header is encoded with them or apart.
Expected<std::string> decoded(std::string_view text, const Coding& coding) {
    auto bytes = from_base64(text);
    if (!bytes || bytes->size() < coding.width()) return std::unexpected(damaged);
    return coding.packed ? std::move(*bytes) : bytes->substr(coding.width());
}

/// The first and last points along the axes that an attribute tells.
Expected<Extent> extent_in(const pugi::xml_node& node, const char* name) {
    const auto numbers = numbers_in<std::int64_t>(node.attribute(name).value());
    constexpr std::int64_t most = std::int64_t{1} << 40;
    const auto is_place = [](std::int64_t place) { return place > -most && place < most; };
    if (!numbers || numbers->size() != 6 || !std::ranges::all_of(*numbers, is_place)) {
        return std::unexpected(
            wrong_field(name, node.attribute(name).value(), "six whole numbers are wanted"));
    }
    Extent extent{};
    std::ranges::copy(*numbers, extent.begin());
    return extent;
}

class VtkImage {
public:
    VtkImage(std::filesystem::path file, VtkText text)
        : file_(std::move(file)), text_(std::move(text)) {}

    Expected<VolumeFile> read() {
        const auto parsed = document_.load_buffer(text_.xml.data(), text_.xml.size());
        if (!parsed)
            return std::unexpected(std::string("its XML is damaged: ") + parsed.description());
        const pugi::xml_node root = document_.child("VTKFile");
        const pugi::xml_node image = root.child("ImageData");
        if (!image) return std::unexpected("it holds no ImageData");
        coding_.big_endian = std::string_view(root.attribute("byte_order").value()) == "BigEndian";
        coding_.long_header = std::string_view(root.attribute("header_type").value()) == "UInt64";
        const std::string_view compressor = root.attribute("compressor").value();
        coding_.packed = !compressor.empty();
        if (coding_.packed && compressor != "vtkZLibDataCompressor")
            return std::unexpected(wrong_field("compressor", compressor, "only zlib is read"));
        const auto whole = extent_in(image, "WholeExtent");
        if (!whole) return std::unexpected(whole.error());
        const bool in_cells = !array_of(image.child("Piece").child("PointData"));
        std::vector<GridPiece> pieces;
        for (const pugi::xml_node& node : image.children("Piece")) {
            const auto piece = read_piece(node, *whole, in_cells);
            if (!piece) return std::unexpected(piece.error());
            pieces.push_back(*piece);
        }
        if (pieces.empty()) return std::unexpected("it holds no Piece of ImageData");
        const auto all = joined(pieces);
        if (!all) return std::unexpected(all.error());
        auto place = geometry(image, all->extent, in_cells ? 0.5 : 0);
        if (!place) return std::unexpected(place.error());
        return VolumeFile{.samples = all->samples, .geometry = *place};
    }

private:
    /// The array that the file calls its scalars, else the first one of single numbers.
    static pugi::xml_node array_of(const pugi::xml_node& data) {
        const std::string_view wanted = data.attribute("Scalars").value();
        pugi::xml_node first;
        for (const pugi::xml_node& array : data.children("DataArray")) {
            if (array.attribute("NumberOfComponents").as_int(1) != 1) continue;
            if (!first) first = array;
            if (wanted == array.attribute("Name").value()) return array;
        }
        return first;
    }

    /// A piece by its numbers at the points or in the cells, which are one less along each axis.
    [[nodiscard]] Expected<GridPiece> read_piece(const pugi::xml_node& node, const Extent& whole,
                                                 bool in_cells) const {
        const pugi::xml_node array = array_of(node.child(in_cells ? "CellData" : "PointData"));
        if (!array)
            return std::unexpected(
                "it has no array of single numbers at its points or in its cells");
        auto extent = node.attribute("Extent") ? extent_in(node, "Extent") : whole;
        if (!extent) return std::unexpected(extent.error());
        for (std::size_t c = 0; c < 3 && in_cells; ++c)
            --(*extent)[2 * c + 1];
        const auto samples = samples_of(array, size_of_extent(*extent));
        if (!samples) return std::unexpected(samples.error());
        return GridPiece{.extent = *extent, .samples = *samples};
    }

    /// Where samples lie that are `off` of a step from the first point of the extent.
    static Expected<Geometry> geometry(const pugi::xml_node& image, const Extent& extent,
                                       double off) {
        const auto numbers = [&](const char* name,
                                 std::vector<double> otherwise) -> Expected<std::vector<double>> {
            const pugi::xml_attribute attribute = image.attribute(name);
            if (!attribute) return otherwise;
            const auto found = numbers_in<double>(attribute.value());
            if (found && found->size() == otherwise.size()) return *found;
            return std::unexpected(wrong_field(
                name, attribute.value(), std::to_string(otherwise.size()) + " numbers are wanted"));
        };
        const auto spacing = numbers("Spacing", {1, 1, 1});
        const auto origin = numbers("Origin", {0, 0, 0});
        const auto turn = numbers("Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
        for (const auto* const found : {&spacing, &origin, &turn}) {
            if (!*found) return std::unexpected(found->error());
        }
        Geometry place;
        for (std::size_t r = 0; r < 3; ++r) {
            place.origin[r] = (*origin)[r];
            for (std::size_t c = 0; c < 3; ++c) {
                place.world_from_index[r][c] = (*turn)[3 * r + c] * (*spacing)[c];
                place.origin[r] +=
                    place.world_from_index[r][c] * (static_cast<double>(extent[2 * c]) + off);
            }
        }
        return place;
    }

    [[nodiscard]] Expected<Samples> samples_of(const pugi::xml_node& array,
                                               const GridSize& size) const {
        SampleBlock block{.file = file_, .size = size};
        const auto type = sample_type(array.attribute("type").value());
        if (!type) {
            return std::unexpected(
                wrong_field("type", array.attribute("type").value(), "a number type is wanted"));
        }
        block.type = *type;
        block.big_endian = coding_.big_endian;
        const std::string_view format = array.attribute("format").value();
        if (format == "appended") return appended(array.attribute("offset").as_ullong(), block);
        const std::string_view text = array.text().get();
        if (format == "binary") {
            const auto bytes = decoded(text, coding_);
            if (!bytes) return std::unexpected(bytes.error());
            return coded(*bytes, block);
        }
        block.encoding = SampleEncoding::Ascii;
        return samples_of_bytes(text, block);
    }

    /// Samples behind the XML, `offset` bytes from their beginning.
    [[nodiscard]] Expected<Samples> appended(std::uint64_t offset, SampleBlock block) const {
        if (text_.appended == 0) return std::unexpected("its header announces data that it lacks");
        const auto mapped = MappedFile::open(file_);
        if (!mapped) return std::unexpected(mapped.error());
        const auto all = (*mapped)->bytes();
        if (text_.appended > all.size() || offset > all.size() - text_.appended)
            return std::unexpected(damaged);
        block.offset = text_.appended + offset;
        if (text_.appended_raw && !coding_.packed) {
            block.offset += coding_.width();
            return read_samples(block);
        }
        std::string_view rest(reinterpret_cast<const char*>(all.data()) + block.offset,
                              all.size() - block.offset);
        if (text_.appended_raw) return coded(rest, block);
        rest = rest.substr(0, rest.find('<'));
        const auto plain = decoded(rest, coding_);
        if (!plain) return std::unexpected(plain.error());
        return coded(*plain, block);
    }

    /// Samples from an array's bytes; packed ones begin with their header.
    [[nodiscard]] Expected<Samples> coded(std::string_view bytes, const SampleBlock& block) const {
        if (!coding_.packed) return samples_of_bytes(bytes, block);
        const std::size_t width = coding_.width();
        if (bytes.size() < 3 * width) return std::unexpected(damaged);
        const std::uint64_t blocks = coding_.number(bytes, 0);
        if (blocks > bytes.size() / width - 3) return std::unexpected(damaged);
        std::string plain;
        std::uint64_t at = (3 + blocks) * width;
        for (std::uint64_t n = 0; n < blocks; ++n) {
            const std::uint64_t size = coding_.number(bytes, 3 + n);
            if (size > bytes.size() - at) return std::unexpected(damaged);
            const auto part = unpacked_bytes(bytes.substr(at, size), coding_.number(bytes, 1));
            if (!part) return std::unexpected(damaged);
            plain += *part;
            at += size;
        }
        return samples_of_bytes(plain, block);
    }

    std::filesystem::path file_;
    VtkText text_;
    Coding coding_;
    pugi::xml_document document_;
};

}  // namespace

Expected<VolumeFile> read_vtk_image(const std::filesystem::path& file) {
    auto text = read_text(file);
    if (!text) return std::unexpected(text.error());
    return VtkImage(file, std::move(*text)).read();
}

}  // namespace zeroset
