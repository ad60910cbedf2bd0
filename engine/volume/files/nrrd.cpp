// NRRD and NHDR files (teem.sourceforge.net/nrrd/format.html).

#include "engine/base/text.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/sample_pieces.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

struct NrrdHeader {
    std::map<std::string, std::string> fields;  ///< names in lower case
    std::string list;                           ///< the lines behind "data file: LIST"
    std::size_t end = 0;                        ///< where the header's last line ends

    [[nodiscard]] std::string field(const std::string& name, const std::string& other = {}) const {
        const auto found = fields.find(name);
        if (found != fields.end()) return found->second;
        const auto second = fields.find(other);
        return second == fields.end() ? std::string() : second->second;
    }
};

Expected<NrrdHeader> read_nrrd_header(const std::string& text) {
    if (!text.starts_with("NRRD000")) return std::unexpected("it does not begin with NRRD000");
    NrrdHeader header;
    std::size_t at = text.find('\n');
    if (at == std::string::npos) return std::unexpected("its header ends in its first line");
    ++at;
    while (at < text.size()) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos && text.size() == longest_text_header)
            return std::unexpected("its header does not end within a megabyte");
        const std::string_view line =
            without_spaces(std::string_view(text).substr(at, std::min(end, text.size()) - at));
        at = std::min(end, text.size() - 1) + 1;
        header.end = at;
        if (line.empty()) break;
        const std::size_t colon = line.find(": ");
        if (line.starts_with('#') || line.contains(":=") || colon == std::string_view::npos) {
            continue;
        }
        const std::string name = lower_case(line.substr(0, colon));
        const std::string_view value = without_spaces(line.substr(colon + 2));
        header.fields[name] = std::string(value);
        if ((name == "data file" || name == "datafile") && value.starts_with("LIST")) {
            header.list = text.substr(at);
            break;
        }
    }
    return header;
}

/// "(a,b,c)" as numbers; nothing for "none".
std::optional<std::array<double, 3>> vector_in(std::string_view text) {
    if (!text.starts_with('(') || !text.ends_with(')')) return std::nullopt;
    std::string inside(text.substr(1, text.size() - 2));
    std::ranges::replace(inside, ',', ' ');
    const auto numbers = numbers_in<double>(inside);
    if (!numbers || numbers->size() != 3) return std::nullopt;
    return std::array{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

/// The vectors of a line, with "none" for axes that have none: "(1,0,0) none (0, 1, 0)".
std::vector<std::string> vectors_of(std::string_view text) {
    std::vector<std::string> vectors;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == ' ') {
            ++at;
            continue;
        }
        const char last = text[at] == '(' ? ')' : ' ';
        const std::size_t end = std::min(text.find(last, at), text.size() - 1);
        std::string vector;
        for (const char c : text.substr(at, end + 1 - at)) {
            if (c != ' ') vector += c;
        }
        vectors.push_back(vector);
        at = end + 1;
    }
    return vectors;
}

/// Signs that turn the axes of a space to those of RAS; nothing for a space that is no such one.
std::optional<std::array<double, 3>> signs_of(const std::string& space) {
    const std::string name = lower_case(space);
    if (name.empty() || name == "scanner-xyz" || name == "3d-right-handed" ||
        name == "3d-left-handed" || name == "right-anterior-superior" || name == "ras") {
        return std::array{1.0, 1.0, 1.0};
    }
    if (name == "left-anterior-superior" || name == "las") return std::array{-1.0, 1.0, 1.0};
    if (name == "left-posterior-superior" || name == "lps") return std::array{-1.0, -1.0, 1.0};
    return std::nullopt;
}

/// Which three axes are those of the grid: of more, all but three must have one sample.
Expected<std::array<std::size_t, 3>> grid_axes(const std::vector<std::uint64_t>& sizes) {
    std::vector<std::size_t> axes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes.size() == 3 || sizes[i] != 1) axes.push_back(i);
    }
    if (axes.size() == 3) return std::array{axes[0], axes[1], axes[2]};
    return std::unexpected(no_volume(sizes));
}

/// Why an axis is none of a volume, but holds the numbers at each point; or nothing.
std::string wrong_kind(const NrrdHeader& header, const std::vector<std::uint64_t>& sizes) {
    constexpr std::array in_space{"domain", "space", "time", "none", "???"};
    const std::string text = header.field("kinds");
    const auto kinds = words_of(text);
    for (std::size_t axis = 0; axis < std::min(kinds.size(), sizes.size()); ++axis) {
        const std::string kind = lower_case(kinds[axis]);
        const bool is_in_space = std::ranges::find(in_space, kind) != in_space.end();
        if (is_in_space || (sizes[axis] == 1 && sizes.size() > 3)) continue;
        const bool is_color = kind.contains("color");
        const std::string what = !is_color          ? "its"
                                 : sizes.size() < 4 ? "it is a picture in colors: its"
                                                    : "its samples are colors: its";
        return what + " axis " + std::to_string(axis + 1) + " is of kind '" +
               printable(kinds[axis]) + "'; a volume has one number at each point";
    }
    return {};
}

/// The spacings and first places of axes without directions. Between an axis's two ends lie as many
/// cells as it has samples, which are in their middles, unless its center is said to be "node".
void take_spacings(const NrrdHeader& header, const std::array<std::size_t, 3>& axes,
                   const std::vector<std::uint64_t>& sizes, Geometry& geometry) {
    const std::string spacing_text = header.field("spacings");
    const std::string min_text = header.field("axis mins", "axismins");
    const std::string max_text = header.field("axis maxs", "axismaxs");
    const std::string center_text = lower_case(header.field("centers", "centerings"));
    const auto centers = words_of(center_text);
    const auto number = [&](const std::string& text, std::size_t axis) -> std::optional<double> {
        const auto words = words_of(text);
        if (words.size() != sizes.size()) return std::nullopt;
        const auto value = number_from<double>(words[axis]);
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t axis = axes[i];
        const auto spacing = number(spacing_text, axis);
        const auto min = number(min_text, axis);
        const auto max = number(max_text, axis);
        const std::string_view center = axis < centers.size() ? centers[axis] : std::string_view();
        const auto cells = static_cast<double>(sizes[axis]) - (center == "node" ? 1 : 0);
        const bool by_ends = !spacing && min && max && *min != *max && cells > 0;
        double& step = geometry.world_from_index[i][i];
        step = by_ends ? (*max - *min) / cells : spacing.value_or(1.0);
        const bool in_middle = min && (center == "cell" || (by_ends && center != "node"));
        geometry.origin[i] = min.value_or(0.0) + (in_middle ? step / 2 : 0);
    }
}

/// The axes' directions; false where they are not three vectors.
bool take_directions(const std::string& directions, const std::array<std::size_t, 3>& axes,
                     std::size_t dimension, Geometry& geometry) {
    const auto vectors = vectors_of(directions);
    if (vectors.size() != dimension) return false;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto vector = vector_in(vectors[axes[c]]);
        if (!vector) return false;
        for (std::size_t r = 0; r < 3; ++r)
            geometry.world_from_index[r][c] = (*vector)[r];
    }
    return true;
}

Expected<Geometry> geometry_of(const NrrdHeader& header, const std::array<std::size_t, 3>& axes,
                               const std::vector<std::uint64_t>& sizes) {
    Geometry geometry;
    const std::string directions = header.field("space directions");
    const auto signs = signs_of(header.field("space"));
    if (!signs) {
        return std::unexpected(wrong_field("space", header.field("space"),
                                           "known are right-anterior-superior, "
                                           "left-anterior-superior, left-posterior-superior"));
    }
    if (!directions.contains('(')) {  // Teem writes "none" for each axis that has a spacing
        take_spacings(header, axes, sizes, geometry);
    } else if (!take_directions(directions, axes, sizes.size(), geometry)) {
        return std::unexpected(wrong_field("space directions", directions,
                                           "a volume has three vectors of three numbers"));
    }
    const std::string origin = header.field("space origin");
    if (!origin.empty()) {
        const auto vectors = vectors_of(origin);
        const auto vector = vectors.size() == 1 ? vector_in(vectors[0]) : std::nullopt;
        if (!vector)
            return std::unexpected(wrong_field("space origin", origin, "it is a vector (x,y,z)"));
        geometry.origin = *vector;
    }
    for (std::size_t r = 0; r < 3; ++r) {
        geometry.origin[r] *= (*signs)[r];
        for (double& m : geometry.world_from_index[r])
            m *= (*signs)[r];
    }
    return geometry;
}

Expected<SampleEncoding> encoding_of(const std::string& name) {
    const std::string encoding = lower_case(name);
    if (encoding == "raw") return SampleEncoding::Raw;
    if (encoding == "gzip" || encoding == "gz") return SampleEncoding::Gzip;
    if (encoding == "ascii" || encoding == "text" || encoding == "txt")
        return SampleEncoding::Ascii;
    return std::unexpected(wrong_field("encoding", name, "raw, gzip and ascii are read"));
}

/// Where the lines to skip end in a file of samples.
Expected<std::uint64_t> after_lines(const std::filesystem::path& file, std::uint64_t from,
                                    std::uint64_t lines) {
    if (lines == 0) return from;
    const auto text = first_bytes(file, longest_text_header);
    if (!text) return std::unexpected(text.error());
    std::size_t at = from;
    for (std::uint64_t line = 0; line < lines; ++line) {
        at = text->find('\n', at);
        if (at == std::string::npos)
            return std::unexpected("its 'line skip' goes beyond the first megabyte");
        ++at;
    }
    return at;
}

/// Where the samples begin in the block's file.
Expected<SampleBlock> at_start(const NrrdHeader& header, SampleBlock block) {
    const std::uint64_t lines =
        number_from<std::uint64_t>(header.field("line skip", "lineskip")).value_or(0);
    const auto start = after_lines(block.file, block.offset, lines);
    if (!start) return std::unexpected(start.error());
    block.offset = *start;
    const std::string skip = header.field("byte skip", "byteskip");
    if (skip.empty()) return block;
    const auto bytes = number_from<std::int64_t>(skip);
    if (!bytes || *bytes < -1)
        return std::unexpected(wrong_field("byte skip", skip, "it is a number or -1"));
    block.at_end = *bytes == -1 && block.encoding == SampleEncoding::Raw;
    const auto forward = static_cast<std::uint64_t>(std::max<std::int64_t>(*bytes, 0));
    (block.encoding == SampleEncoding::Gzip ? block.skip_unpacked : block.offset) += forward;
    return block;
}

/// How the samples are written, wherever they lie.
Expected<SampleBlock> block_of(const NrrdHeader& header, const std::filesystem::path& file) {
    SampleBlock block{.file = file, .offset = header.end};
    const auto encoding = encoding_of(header.field("encoding"));
    if (!encoding) return std::unexpected(encoding.error());
    block.encoding = *encoding;
    const auto type = sample_type(header.field("type"));
    if (!type)
        return std::unexpected(
            wrong_field("type", header.field("type"), "a number type is wanted"));
    block.type = *type;
    const std::string endian = lower_case(header.field("endian"));
    if (endian.empty() && block.encoding != SampleEncoding::Ascii && size_of(block.type) > 1)
        return std::unexpected("its header lacks 'endian: little' or 'endian: big'");
    block.big_endian = endian == "big";
    return block;
}

Expected<FoundSamples> samples_of(const NrrdHeader& header, const std::filesystem::path& file,
                                  SampleBlock block, const std::vector<std::uint64_t>& sizes) {
    const std::string data = header.field("data file", "datafile");
    const auto started = [&](const SampleBlock& piece) { return at_start(header, piece); };
    if (names_several_files(data, file.parent_path())) {
        const SeveralFiles files{
            .field = data, .lines = header.list, .folder = file.parent_path(), .sizes = sizes};
        return read_several(files, block, started);
    }
    if (!data.empty()) {
        block.file = file.parent_path() / data;
        block.offset = 0;
    }
    const auto whole = started(block);
    if (!whole) return std::unexpected(whole.error());
    return read_samples_of(file, *whole);
}

}  // namespace

Expected<VolumeFile> read_nrrd(const std::filesystem::path& file) {
    const auto text = first_bytes(file, longest_text_header);
    if (!text) return std::unexpected(text.error());
    const auto header = read_nrrd_header(*text);
    if (!header) return std::unexpected(header.error());
    const std::string sizes_text = header->field("sizes");
    const auto sizes = numbers_in<std::uint64_t>(sizes_text);
    if (!sizes || sizes->empty())
        return std::unexpected(wrong_field("sizes", sizes_text, "whole numbers are wanted"));
    if (auto problem = wrong_kind(*header, *sizes); !problem.empty())
        return std::unexpected(problem);
    const auto axes = grid_axes(*sizes);
    if (!axes) return std::unexpected(axes.error());
    const auto geometry = geometry_of(*header, *axes, *sizes);
    if (!geometry) return std::unexpected(geometry.error());
    auto block = block_of(*header, file);
    if (!block) return std::unexpected(block.error());
    for (std::size_t i = 0; i < 3; ++i)
        block->size[i] = (*sizes)[(*axes)[i]];
    auto found = samples_of(*header, file, *block, *sizes);
    if (!found) return std::unexpected(found.error());
    return VolumeFile{.samples = std::move(found->samples),
                      .geometry = *geometry,
                      .sample_files = std::move(found->files)};
}

}  // namespace zeroset
