#pragma once

#include <cstddef>
#include <cstdint>

// The function that the program calls in its module zeroset_gdcm.so, which has GDCM behind it. The
// module has nothing else of the program.

namespace zeroset {

enum class GdcmOutcome : std::uint8_t { None, Done, Unreadable, NoNumbers, OtherCount };

/// How unpacking some samples ended.
struct GdcmReport {
    GdcmOutcome outcome = GdcmOutcome::None;
    int bits_allocated = 0, bits_stored = 0;
    bool is_signed = false;
};

/// The module's file: beside the program, or where it is installed in ../lib/zeroset
/// (CMakeLists.txt sets the program's search path).
inline constexpr const char* gdcm_module_file = "zeroset_gdcm.so";
inline constexpr const char* gdcm_module_function = "zeroset_unpack_by_gdcm";

/// Bytes of the widest sample that is unpacked.
inline constexpr std::uint64_t gdcm_widest = 4;

/// Unpacks `count` single numbers of a DICOM file, whose `size` bytes these are, into `samples`,
/// which has room for `count` of the widest. Throws nothing, but GDCM may end the process.
using UnpackByGdcm = void (*)(const char* file, std::size_t size, std::uint64_t count,
                              GdcmReport& report, char* samples);

}  // namespace zeroset
