#pragma once

#include "tests/support/dicom_elements.hpp"

#include <cstdint>
#include <string>

namespace zeroset::test {

/// A slice of 4 x 3 samples, i + 10 j + 100 k, as a file of its own.
struct DicomTestSlice {
    int k = 0;
    std::string series = "1.2.3.4";
    std::string position = {};  ///< "0\0\(2 k)" where it is empty
    std::string orientation = R"(1\0\0\0\1\0)";
    std::string spacing = R"(3\0.5)";  ///< between rows, between columns
    std::string slope = "1", intercept = "0";
    bool is_signed = false;
    int bits = 16, stored = 12;
    int add = 0;  ///< to all samples
    std::string frames = {};
    std::string syntax = "1.2.840.10008.1.2.1";
    int high_bit = -1;  ///< `stored` - 1 where it is negative
    std::string kind = "1.2.840.10008.5.1.4.1.1.2";
    std::string instance = {};     ///< one of its own where it is empty
    std::string description = {};  ///< of the series

    [[nodiscard]] std::string samples() const {
        std::string bytes;
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 4; ++i) {
                const int number = i + 10 * j + 100 * k + add;
                bytes += bits == 8 ? bytes_of(static_cast<std::uint8_t>(number))
                                   : bytes_of(static_cast<std::uint16_t>(number));
            }
        }
        return bytes;
    }
    [[nodiscard]] std::string uid() const {
        return instance.empty() ? "1.2.3.4.5." + std::to_string(k + 1) : instance;
    }
    [[nodiscard]] std::string bytes() const {
        const std::string meta = element(2, 1, "OB", std::string("\0\1", 2)) +
                                 element(2, 2, "UI", kind) + element(2, 3, "UI", uid()) +
                                 element(2, 0x10, "UI", syntax) + element(2, 0x12, "UI", "1.2.3");
        return std::string(128, '\0') + "DICM" +
               element(2, 0, "UL", bytes_of(static_cast<std::uint32_t>(meta.size()))) + meta +
               data();
    }
    /// All that a file has behind its preamble and its preface.
    [[nodiscard]] std::string data() const {
        const std::string place = position.empty() ? "0\\0\\" + std::to_string(2 * k) : position;
        return element(8, 0x16, "UI", kind) + element(8, 0x18, "UI", uid()) +
               element(8, 0x60, "CS", "CT") +
               (description.empty() ? "" : element(8, 0x103e, "LO", description)) +
               element(0x20, 0xd, "UI", "1.2.3") + element(0x20, 0xe, "UI", series) +
               (place == "none" ? "" : element(0x20, 0x32, "DS", place)) +
               element(0x20, 0x37, "DS", orientation) + short_element(0x28, 2, 1) +
               element(0x28, 4, "CS", "MONOCHROME2") +
               (frames.empty() ? "" : element(0x28, 8, "IS", frames)) +
               short_element(0x28, 0x10, 3) + short_element(0x28, 0x11, 4) +
               element(0x28, 0x30, "DS", spacing) + short_element(0x28, 0x100, bits) +
               short_element(0x28, 0x101, stored) +
               short_element(0x28, 0x102, high_bit < 0 ? stored - 1 : high_bit) +
               short_element(0x28, 0x103, is_signed ? 1 : 0) +
               element(0x28, 0x1052, "DS", intercept) + element(0x28, 0x1053, "DS", slope) +
               element(0x7fe0, 0x10, bits == 8 ? "OB" : "OW", samples());
    }
};

}  // namespace zeroset::test
