#include "engine/volume/files/dicom_packed.hpp"

// In place of gdcm_pixels.cpp in a build without GDCM.

namespace zeroset {

std::expected<DicomPixels, std::string> unpacked_pixels(std::string_view, std::uint64_t) {
    return std::unexpected(
        "its samples are packed, and this Zeroset was built without GDCM: unpack them first, as "
        "'gdcmconv --raw' does, or install libgdcm-dev and build again");
}

}  // namespace zeroset
