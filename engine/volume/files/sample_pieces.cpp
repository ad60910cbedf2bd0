#include "engine/volume/files/sample_pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace zeroset {
namespace {

constexpr std::string_view list_word = "LIST";

/// Names that count: text, a number of at least `width` digits, text.
struct CountedNames {
    std::string before;
    std::string after;
    std::size_t width = 0;
    char fill = ' ';

    [[nodiscard]] std::string name(std::int64_t number) const {
        std::string digits = std::to_string(std::abs(number));
        const std::size_t sign = number < 0 ? 1 : 0;
        const std::string padding(width - std::min(width, digits.size() + sign), fill);
        const std::string minus(sign, '-');
        digits = fill == '0' ? minus + padding + digits : padding + minus + digits;
        return before + digits + after;
    }
};

/// Reads "slice%03d.raw" as printf does; nothing where it has not one whole number in it.
std::optional<CountedNames> counted_names(std::string_view pattern) {
    const std::size_t sign = pattern.find('%');
    const std::size_t end = pattern.find_first_not_of("0123456789", sign + 1);
    if (end == std::string_view::npos || !std::string_view("diu").contains(pattern[end]) ||
        pattern.find('%', end) != std::string_view::npos) {
        return std::nullopt;
    }
    CountedNames names{.before = std::string(pattern.substr(0, sign)),
                       .after = std::string(pattern.substr(end + 1))};
    const std::string_view width = pattern.substr(sign + 1, end - sign - 1);
    if (width.starts_with('0')) names.fill = '0';
    constexpr std::size_t widest = 20;
    if (!width.empty()) names.width = number_from<std::size_t>(width).value_or(widest + 1);
    return names.width > widest ? std::nullopt : std::optional(std::move(names));
}

/// How many files a grid needs whose files have so many axes each; nothing where they cannot.
std::optional<std::uint64_t> files_of(const std::vector<std::uint64_t>& sizes, std::uint64_t axes) {
    if (axes == 0 || axes > sizes.size()) return std::nullopt;
    std::uint64_t count = 1;
    for (std::size_t i = axes; i < sizes.size(); ++i) {
        if (sizes[i] != 0 && count > std::numeric_limits<std::uint64_t>::max() / sizes[i])
            return std::nullopt;
        count *= sizes[i];
    }
    return count;
}

/// Why so many files cannot be the grid's; empty where they can. Files with all its axes are slabs
/// that divide its last one.
std::string wrong_count(std::uint64_t count, const std::vector<std::uint64_t>& sizes,
                        std::uint64_t axes) {
    const auto needed = files_of(sizes, axes);
    if (!needed) {
        return "its files have " + std::to_string(axes) + " axes each; the volume has " +
               std::to_string(sizes.size());
    }
    constexpr std::uint64_t most = 65536;
    if (count > most) {
        return "its samples lie in " + std::to_string(count) + " files; at most " +
               std::to_string(most) + " are read";
    }
    const bool slabs = axes == sizes.size();
    const bool right = count > 0 && (slabs ? sizes.back() % count == 0 : count == *needed);
    if (right) return {};
    return "its samples lie in " + std::to_string(count) + " files; " +
           (slabs ? "they do not divide " + std::to_string(sizes.back()) + " slices evenly"
                  : std::to_string(*needed) + " are needed");
}

using Names = Expected<std::vector<std::string>>;

Names listed(std::string_view lines, const std::vector<std::uint64_t>& sizes, std::uint64_t axes) {
    std::vector<std::string> names;
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find('\n'), lines.size());
        const std::string_view name = without_spaces(lines.substr(0, end));
        if (!name.empty()) names.emplace_back(name);
        lines.remove_prefix(std::min(end + 1, lines.size()));
    }
    if (auto problem = wrong_count(names.size(), sizes, axes); !problem.empty())
        return std::unexpected(std::move(problem));
    return names;
}

Names counted(const CountedNames& pattern, const std::vector<std::int64_t>& numbers,
              const std::vector<std::uint64_t>& sizes, std::uint64_t axes) {
    constexpr std::int64_t most = 1'000'000;
    const auto small = [](std::int64_t number) { return number >= -most && number <= most; };
    if (!std::ranges::all_of(numbers, small))
        return std::unexpected("its files are counted beyond a million");
    const std::int64_t step = numbers[2];
    const std::int64_t way = numbers[1] - numbers[0];
    if (step == 0 || (way != 0 && (way < 0) != (step < 0)))
        return std::unexpected("its files are counted in steps that never come to the last one");
    const std::int64_t count = way / step + 1;
    if (auto problem = wrong_count(static_cast<std::uint64_t>(count), sizes, axes);
        !problem.empty())
        return std::unexpected(std::move(problem));
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(count));
    for (std::int64_t n = 0; n < count; ++n)
        names.push_back(pattern.name(numbers[0] + n * step));
    return names;
}

/// Whether the file can hold so many bytes of samples.
std::string lacking(const SampleBlock& piece, std::uint64_t bytes) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(piece.file, error);
    if (error) return "it cannot be read: " + error.message();
    const bool enough = piece.encoding == SampleEncoding::Gzip  ? size >= bytes / best_deflate_ratio
                        : piece.encoding == SampleEncoding::Raw ? size >= bytes
                                                                : size + 1 >= 2 * piece.size[0];
    if (enough) return {};
    return "it is too short: " + std::to_string(bytes) + " bytes of samples are announced, its " +
           std::to_string(size) + " bytes cannot hold them";
}

/// The files' names in their order, as many as grids of these sizes need.
Names names_of(const SeveralFiles& files) {
    const auto words = words_of(files.field);
    const bool is_list = words.front() == list_word;
    const auto pattern = is_list ? std::nullopt : counted_names(words.front());
    const std::size_t wanted = is_list ? 1 : 4;
    const auto numbers = numbers_in<std::int64_t>(
        files.field.substr(files.field.find(words.front()) + words.front().size()));
    if ((!is_list && !pattern) || !numbers ||
        (words.size() != wanted && words.size() != wanted + 1)) {
        return std::unexpected(wrong_field("data file", files.field,
                                           "one name is wanted, LIST, or a name and its numbers: "
                                           "slice%03d.raw FIRST LAST STEP"));
    }
    const auto axes = words.size() > wanted
                          ? static_cast<std::uint64_t>(std::max<std::int64_t>(numbers->back(), 0))
                          : files.sizes.size() - 1;
    return is_list ? listed(files.lines, files.sizes, axes)
                   : counted(*pattern, *numbers, files.sizes, axes);
}

std::unexpected<std::string> named(const SampleBlock& piece, const std::string& problem) {
    return std::unexpected("its file '" + piece.file.filename().string() + "': " + problem);
}

/// The grid of blocks that follow each other, all of one type and size.
Expected<Samples> joined_samples(const std::vector<SampleBlock>& pieces, const GridSize& size) {
    const SampleType type = pieces.front().type;
    const auto whole = bytes_of(size, type);
    if (!whole || *whole == 0 || *whole % pieces.size() != 0)
        return std::unexpected("its sizes are no grid of its files");
    const std::uint64_t each = *whole / pieces.size();
    for (const SampleBlock& piece : pieces) {
        if (auto problem = lacking(piece, each); !problem.empty()) return named(piece, problem);
    }
    std::shared_ptr<std::byte> room;
    std::byte* at = nullptr;
    for (const SampleBlock& piece : pieces) {
        const auto samples = read_samples(piece);
        if (!samples) return named(piece, samples.error());
        if (at == nullptr) {
            room = room_for_samples(*whole);
            if (!room) return no_memory_for_samples(*whole);
            at = room.get();
        }
        std::memcpy(at, samples->data.get(), each);
        at += each;
    }
    return Samples{.type = type, .size = size, .data = room};
}

}  // namespace

bool names_several_files(std::string_view field, const std::filesystem::path& folder) {
    if (field.starts_with(list_word)) return true;
    std::error_code error;
    return field.contains('%') && !std::filesystem::exists(folder / field, error);
}

Expected<FoundSamples> read_samples_of(const std::filesystem::path& header,
                                       const SampleBlock& block) {
    const bool is_header = block.file == header;
    FoundSamples found;
    if (!is_header) found.files.push_back(FileStamp::now(block.file));
    auto samples = read_samples(block);
    if (!samples && is_header) return std::unexpected(samples.error());
    if (!samples) return named(block, samples.error());
    found.samples = *std::move(samples);
    return found;
}

Expected<FoundSamples> read_several(
    const SeveralFiles& files, const SampleBlock& block,
    const std::function<Expected<SampleBlock>(const SampleBlock&)>& started) {
    const auto names = names_of(files);
    if (!names) return std::unexpected(names.error());
    const GridSize& size = block.size;
    std::vector<SampleBlock> pieces;
    FoundSamples all;
    for (const std::string& name : *names) {
        SampleBlock piece = block;
        piece.file = files.folder / name;
        piece.offset = 0;
        piece.size = {size[0] * size[1] * size[2] / names->size(), 1, 1};
        const auto found = started(piece);
        if (!found) return named(piece, found.error());
        pieces.push_back(*found);
        all.files.push_back(FileStamp::now(piece.file));
    }
    auto samples = joined_samples(pieces, size);
    if (!samples) return std::unexpected(samples.error());
    all.samples = *std::move(samples);
    return all;
}

}  // namespace zeroset
