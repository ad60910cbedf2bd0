#pragma once

#include "engine/volume/files/header_text.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// A tag of DICOM: its group in the upper half.
using DicomTag = std::uint32_t;
inline constexpr DicomTag pixel_data = 0x7fe00010;

/// The elements of a file of DICOM, without sequences, which are passed over but for what several
/// slices in one file say of themselves.
struct DicomElements {
    struct Element {
        std::size_t offset = 0, length = 0;  ///< of its value in the file
    };
    using Elements = std::map<DicomTag, Element>;
    Elements elements;
    Elements shared;               ///< by all slices of the file
    std::vector<Elements> frames;  ///< each slice's own
    std::string transfer_syntax;
    bool big_endian = false;
    std::size_t deflated_from = 0;  ///< where the rest of the file is packed by zlib; 0: nowhere
    std::string problem;  ///< why it was read no further, without the file's name; or nothing

    [[nodiscard]] bool has(DicomTag tag) const { return elements.contains(tag); }
    /// A value's text without what fills it up; empty where it is missing. `bytes` is the file.
    /// `frame`: the slice of which it is asked.
    [[nodiscard]] std::string text(std::string_view bytes, DicomTag tag,
                                   std::optional<std::size_t> frame = {}) const;
    /// A binary number of 16 bits, or `otherwise`.
    [[nodiscard]] int number(std::string_view bytes, DicomTag tag, int otherwise) const;
};

enum class DeflatedPart : std::uint8_t { Packed, Unpacked };

/// Reads the elements of a file up to its samples, up to what is packed, or to its end where it has
/// no samples. Reads no byte beyond `bytes`, whatever they are.
DicomElements read_dicom_elements(std::string_view bytes, DeflatedPart part = DeflatedPart::Packed);

/// Bytes that tell whether a file is one of DICOM.
inline constexpr std::size_t dicom_start = 160;
/// Whether a file that starts with these bytes is one of DICOM: after a preamble or without one.
bool starts_as_dicom(std::string_view start);

}  // namespace zeroset
