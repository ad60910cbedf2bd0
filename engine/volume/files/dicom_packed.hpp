#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

// Samples of DICOM that are packed as JPEG, JPEG-LS or JPEG 2000. What unpacks them is GDCM, an
// optional part of the build: gdcm_pixels.cpp, or without_gdcm.cpp in its place.

namespace zeroset {

/// The samples of a file as they were before they were packed.
struct DicomPixels {
    std::string bytes;  ///< in this machine's order, rows one behind the other
    int bits_allocated = 0, bits_stored = 0;
    bool is_signed = false;
};

/// Unpacks the samples of a file of `count` single numbers, of one slice or several, whose bytes
/// these are. The
/// error is what is wrong with the file, without its name. Thread-safe.
std::expected<DicomPixels, std::string> unpacked_pixels(std::string_view file, std::uint64_t count);

}  // namespace zeroset
