#pragma once

#include "engine/base/text.hpp"
#include "engine/volume/samples.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Headers of volume files: text and bytes.

namespace zeroset {

/// A value, or what is wrong with a file in one line without its name.
template <class Value>
using Expected = std::expected<Value, std::string>;

/// Headers of text are not looked for beyond this many bytes.
inline constexpr std::size_t longest_text_header = std::size_t{1} << 20U;

/// The first bytes of a file, at most `most`. An error is one line without the file's name.
std::expected<std::string, std::string> first_bytes(const std::filesystem::path& file,
                                                    std::size_t most);

/// The first bytes of a file, at most `most`, unpacked where it begins as gzip's do.
std::expected<std::string, std::string> unpacked_start(const std::filesystem::path& file,
                                                       std::size_t most);

std::string_view without_spaces(std::string_view text);
/// The words between spaces.
std::vector<std::string_view> words_of(std::string_view text);

/// The numbers in a text, one for each word; nothing where a word is none.
template <class Number>
std::optional<std::vector<Number>> numbers_in(std::string_view text) {
    std::vector<Number> numbers;
    for (const std::string_view word : words_of(text)) {
        const auto number = number_from<Number>(word);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

/// The type by its names in files: "unsigned short", "uint16_t", "ushort"; of this program
/// "uint16".
std::optional<SampleType> sample_type(std::string_view name);

/// "its 'NAME' is 'VALUE'; WANTED"
std::string wrong_field(std::string_view name, std::string_view value, std::string_view wanted);

/// Why a grid of these sizes is no volume: a picture, or several numbers at each point.
std::string no_volume(const std::vector<std::uint64_t>& sizes);

/// Whether a file begins as gzip's do, whatever its name says.
bool is_packed(const std::filesystem::path& file);

/// Numbers in a header of bytes.
template <class Number>
Number number_at(std::string_view bytes, std::size_t offset, bool big_endian);

}  // namespace zeroset
