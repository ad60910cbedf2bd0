// MetaImage files, MHD and MHA (itk.org/Wiki/ITK/MetaIO).

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/sample_pieces.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <vector>

namespace zeroset {
namespace {

struct MetaHeader {
    std::map<std::string, std::string> fields;  ///< names in lower case
    std::string list;                           ///< the lines behind "ElementDataFile = LIST"
    std::size_t end = 0;                        ///< where the header's last line ends

    [[nodiscard]] std::string field(std::initializer_list<const char*> names) const {
        for (const char* const name : names) {
            const auto found = fields.find(name);
            if (found != fields.end()) return found->second;
        }
        return {};
    }
    [[nodiscard]] bool says_true(std::initializer_list<const char*> names) const {
        const std::string value = lower_case(field(names));
        return value == "true" || value == "1" || value == "t";
    }
};

Expected<MetaHeader> read_meta_header(const std::string& text) {
    MetaHeader header;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos && text.size() == longest_text_header) break;
        const std::string_view line =
            std::string_view(text).substr(at, std::min(end, text.size()) - at);
        at = end == std::string::npos ? text.size() : end + 1;
        const std::size_t sign = line.find('=');
        if (sign == std::string_view::npos) {
            if (without_spaces(line).empty()) continue;
            return std::unexpected("its header has a line without '='");
        }
        const std::string name = lower_case(without_spaces(line.substr(0, sign)));
        header.fields[name] = std::string(without_spaces(line.substr(sign + 1)));
        header.end = at;
        if (name != "elementdatafile") continue;
        if (header.fields[name].starts_with("LIST")) header.list = text.substr(at);
        return header;
    }
    return std::unexpected("its header lacks ElementDataFile");
}

/// The numbers of a field for the first three of `axes`, in rows; `otherwise` where it is missing.
Expected<std::vector<double>> numbers_of(const MetaHeader& header, std::size_t axes,
                                         std::initializer_list<const char*> names,
                                         std::vector<double> otherwise) {
    const std::string text = header.field(names);
    if (text.empty()) return otherwise;
    const auto numbers = numbers_in<double>(text);
    const std::size_t wanted = otherwise.size() == 3 ? axes : axes * axes;
    if (!numbers || numbers->size() != wanted) {
        return std::unexpected(
            wrong_field(*names.begin(), text, std::to_string(wanted) + " numbers are wanted"));
    }
    if (wanted == 3) return *numbers;
    for (std::size_t i = 0; i < otherwise.size(); ++i)
        otherwise[i] = (*numbers)[i / 3 * axes + i % 3];
    return otherwise;
}

Expected<Geometry> geometry_of(const MetaHeader& header, std::size_t axes) {
    const auto spacing = numbers_of(header, axes, {"elementspacing", "elementsize"}, {1, 1, 1});
    const auto origin = numbers_of(header, axes, {"offset", "position", "origin"}, {0, 0, 0});
    const auto turn = numbers_of(header, axes, {"transformmatrix", "orientation", "rotation"},
                                 {1, 0, 0, 0, 1, 0, 0, 0, 1});
    for (const auto* const numbers : {&spacing, &origin, &turn}) {
        if (!*numbers) return std::unexpected(numbers->error());
    }
    // Such files tell places in LPS; without an orientation they are no scans of a body.
    const std::string body = header.field({"anatomicalorientation"});
    const bool is_body = !body.empty() && !body.contains('?');
    Geometry geometry;
    for (std::size_t r = 0; r < 3; ++r) {
        const double sign = is_body && r < 2 ? -1.0 : 1.0;
        for (std::size_t c = 0; c < 3; ++c)
            geometry.world_from_index[r][c] = sign * (*turn)[3 * c + r] * (*spacing)[c];
        geometry.origin[r] = sign * (*origin)[r];
    }
    return geometry;
}

/// The samples along all axes: three, behind which others have one each.
Expected<std::vector<std::uint64_t>> sizes_of(const MetaHeader& header) {
    const std::string text = header.field({"dimsize"});
    const auto sizes = numbers_in<std::uint64_t>(text);
    if (!sizes || sizes->empty())
        return std::unexpected(wrong_field("DimSize", text, "three whole numbers are wanted"));
    if (sizes->size() < 3) return std::unexpected(no_volume(*sizes));
    const bool one_each = std::ranges::all_of(*sizes | std::views::drop(3),
                                              [](std::uint64_t size) { return size == 1; });
    if (!one_each) return std::unexpected(no_volume(*sizes));
    return *sizes;
}

Expected<SampleBlock> block_of(const MetaHeader& header, const std::vector<std::uint64_t>& sizes,
                               const std::filesystem::path& file) {
    SampleBlock block{.file = file, .offset = header.end};
    block.size = {sizes[0], sizes[1], sizes[2]};
    const std::string channels = header.field({"elementnumberofchannels"});
    if (!channels.empty() && channels != "1") {
        return std::unexpected("it has " + channels + " numbers at each point; a volume has one");
    }
    const std::string type_name = header.field({"elementtype"});
    const auto type = sample_type(type_name);
    if (!type)
        return std::unexpected(wrong_field("ElementType", type_name, "a number type is wanted"));
    block.type = *type;
    block.big_endian = header.says_true({"binarydatabyteordermsb", "elementbyteordermsb"});
    if (header.says_true({"compresseddata"})) block.encoding = SampleEncoding::Gzip;
    const std::string binary = lower_case(header.field({"binarydata"}));
    if (binary == "false") block.encoding = SampleEncoding::Ascii;
    return block;
}

/// Where the samples begin in a file of their own.
Expected<SampleBlock> at_start(const MetaHeader& header, SampleBlock block) {
    block.offset = 0;
    const std::string skip = header.field({"headersize"});
    if (skip.empty()) return block;
    const auto bytes = number_from<std::int64_t>(skip);
    if (!bytes || *bytes < -1)
        return std::unexpected(wrong_field("HeaderSize", skip, "it is a number or -1"));
    block.at_end = *bytes == -1;
    if (*bytes > 0) block.offset = static_cast<std::uint64_t>(*bytes);
    return block;
}

Expected<FoundSamples> samples_of(const MetaHeader& header, const std::filesystem::path& file,
                                  SampleBlock block, const std::vector<std::uint64_t>& sizes) {
    const std::string data = header.field({"elementdatafile"});
    if (lower_case(data) == "local") return read_samples_of(file, block);
    const auto started = [&](const SampleBlock& piece) { return at_start(header, piece); };
    if (names_several_files(data, file.parent_path())) {
        const SeveralFiles files{
            .field = data, .lines = header.list, .folder = file.parent_path(), .sizes = sizes};
        return read_several(files, block, started);
    }
    block.file = file.parent_path() / data;
    const auto whole = started(block);
    if (!whole) return std::unexpected(whole.error());
    return read_samples_of(file, *whole);
}

}  // namespace

Expected<VolumeFile> read_meta_image(const std::filesystem::path& file) {
    const auto text = first_bytes(file, longest_text_header);
    if (!text) return std::unexpected(text.error());
    const auto header = read_meta_header(*text);
    if (!header) return std::unexpected(header.error());
    const auto sizes = sizes_of(*header);
    if (!sizes) return std::unexpected(sizes.error());
    const auto block = block_of(*header, *sizes, file);
    if (!block) return std::unexpected(block.error());
    const auto geometry = geometry_of(*header, sizes->size());
    if (!geometry) return std::unexpected(geometry.error());
    auto found = samples_of(*header, file, *block, *sizes);
    if (!found) return std::unexpected(found.error());
    return VolumeFile{.samples = std::move(found->samples),
                      .geometry = *geometry,
                      .sample_files = std::move(found->files)};
}

}  // namespace zeroset
