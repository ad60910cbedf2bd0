#include "engine/volume/files/header_text.hpp"

#include "engine/base/text.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <utility>

namespace zeroset {

std::expected<std::string, std::string> first_bytes(const std::filesystem::path& file,
                                                    std::size_t most) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::unexpected("there is no such file");
    if (!std::filesystem::is_regular_file(file, error)) return std::unexpected("it is no file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::unexpected("it cannot be read");
    std::string text(std::min<std::size_t>(most, std::filesystem::file_size(file, error)), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

std::expected<std::string, std::string> unpacked_start(const std::filesystem::path& file,
                                                       std::size_t most) {
    const auto there = first_bytes(file, 1);
    if (!there) return there;
    const gzFile stream = gzopen(file.c_str(), "rb");
    if (stream == nullptr) return std::unexpected("it cannot be read");
    std::string bytes(most, '\0');
    const int got = gzread(stream, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(stream);
    bytes.resize(static_cast<std::size_t>(std::max(got, 0)));
    return bytes;
}

std::string_view without_spaces(std::string_view text) {
    constexpr std::string_view spaces = " \t\r\n";
    const std::size_t begin = std::min(text.find_first_not_of(spaces), text.size());
    text.remove_prefix(begin);
    const std::size_t end = text.find_last_not_of(spaces);
    return text.substr(0, end == std::string_view::npos ? 0 : end + 1);
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (text = without_spaces(text); !text.empty(); text = without_spaces(text)) {
        words.push_back(text.substr(0, text.find_first_of(" \t\r\n")));
        text.remove_prefix(words.back().size());
    }
    return words;
}

namespace {

/// Names of types, as the formats write them.
constexpr auto type_names = std::to_array<std::pair<std::string_view, SampleType>>({
    {"int8", SampleType::Int8},
    {"int8_t", SampleType::Int8},
    {"signed char", SampleType::Int8},
    {"met_char", SampleType::Int8},
    {"uint8", SampleType::UInt8},
    {"uint8_t", SampleType::UInt8},
    {"uchar", SampleType::UInt8},
    {"unsigned char", SampleType::UInt8},
    {"met_uchar", SampleType::UInt8},
    {"int16", SampleType::Int16},
    {"int16_t", SampleType::Int16},
    {"short", SampleType::Int16},
    {"short int", SampleType::Int16},
    {"signed short", SampleType::Int16},
    {"signed short int", SampleType::Int16},
    {"met_short", SampleType::Int16},
    {"uint16", SampleType::UInt16},
    {"uint16_t", SampleType::UInt16},
    {"ushort", SampleType::UInt16},
    {"unsigned short", SampleType::UInt16},
    {"unsigned short int", SampleType::UInt16},
    {"met_ushort", SampleType::UInt16},
    {"int32", SampleType::Int32},
    {"int32_t", SampleType::Int32},
    {"int", SampleType::Int32},
    {"signed int", SampleType::Int32},
    {"met_int", SampleType::Int32},
    {"met_long", SampleType::Int32},
    {"uint32", SampleType::UInt32},
    {"uint32_t", SampleType::UInt32},
    {"uint", SampleType::UInt32},
    {"unsigned int", SampleType::UInt32},
    {"met_uint", SampleType::UInt32},
    {"met_ulong", SampleType::UInt32},
    {"int64", SampleType::Int64},
    {"int64_t", SampleType::Int64},
    {"longlong", SampleType::Int64},
    {"long long", SampleType::Int64},
    {"long long int", SampleType::Int64},
    {"signed long long", SampleType::Int64},
    {"signed long long int", SampleType::Int64},
    {"met_long_long", SampleType::Int64},
    {"uint64", SampleType::UInt64},
    {"uint64_t", SampleType::UInt64},
    {"ulonglong", SampleType::UInt64},
    {"unsigned long long", SampleType::UInt64},
    {"unsigned long long int", SampleType::UInt64},
    {"met_ulong_long", SampleType::UInt64},
    {"float", SampleType::Float},
    {"float32", SampleType::Float},
    {"met_float", SampleType::Float},
    {"double", SampleType::Double},
    {"float64", SampleType::Double},
    {"met_double", SampleType::Double},
});

}  // namespace

std::optional<SampleType> sample_type(std::string_view name) {
    const std::string lower = lower_case(without_spaces(name));
    const auto* const found = std::ranges::find(type_names, std::string_view(lower),
                                                &std::pair<std::string_view, SampleType>::first);
    if (found == type_names.end()) return std::nullopt;
    return found->second;
}

std::string wrong_field(std::string_view name, std::string_view value, std::string_view wanted) {
    constexpr std::size_t longest = 40;
    return "its '" + std::string(name) + "' is '" + printable(value.substr(0, longest)) + "'; " +
           std::string(wanted);
}

std::string no_volume(const std::vector<std::uint64_t>& sizes) {
    std::string text;
    for (const std::uint64_t size : sizes)
        text += (text.empty() ? "" : " x ") + std::to_string(size);
    if (sizes.size() < 3) return "it is a picture of " + text + " samples, no volume";
    return "it has " + text + " samples; a volume has three axes and one number at each point";
}

bool is_packed(const std::filesystem::path& file) {
    constexpr std::string_view mark = "\x1f\x8b";
    const auto start = first_bytes(file, mark.size());
    return start && *start == mark;
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t offset, bool big_endian) {
    std::array<char, sizeof(Number)> raw{};
    if (offset + raw.size() <= bytes.size()) std::memcpy(raw.data(), &bytes[offset], raw.size());
    if (big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(raw);
    return std::bit_cast<Number>(raw);
}

template std::int16_t number_at(std::string_view, std::size_t, bool);
template std::uint16_t number_at(std::string_view, std::size_t, bool);
template std::uint32_t number_at(std::string_view, std::size_t, bool);
template std::int32_t number_at(std::string_view, std::size_t, bool);
template std::int64_t number_at(std::string_view, std::size_t, bool);
template float number_at(std::string_view, std::size_t, bool);
template double number_at(std::string_view, std::size_t, bool);

}  // namespace zeroset
