#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

// Elements of files of DICOM, in explicit little endian.

namespace zeroset::test {

template <class Number>
std::string bytes_of(Number number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
}
inline std::string tag(unsigned group, unsigned number) {
    return bytes_of(static_cast<std::uint16_t>(group)) +
           bytes_of(static_cast<std::uint16_t>(number));
}
inline std::string length_of(std::size_t length) {
    return bytes_of(static_cast<std::uint32_t>(length));
}

/// An element in explicit little endian.
inline std::string element(unsigned group, unsigned number, const std::string& type,
                           std::string value) {
    if (value.size() % 2 != 0) value += type == "UI" || type == "OW" ? '\0' : ' ';
    const bool is_long = type == "OB" || type == "OW" || type == "SQ";
    return tag(group, number) + type +
           (is_long ? std::string(2, '\0') + length_of(value.size())
                    : bytes_of(static_cast<std::uint16_t>(value.size()))) +
           value;
}
inline std::string short_element(unsigned group, unsigned number, int value) {
    return element(group, number, "US", bytes_of(static_cast<std::uint16_t>(value)));
}

}  // namespace zeroset::test
