#include "engine/volume/files/gdcm_module.hpp"

#include <gdcmImageReader.h>

#include <exception>
#include <span>
#include <spanstream>
#include <type_traits>

namespace zeroset {
namespace {

GdcmOutcome unpack(std::span<const char> file, std::uint64_t count, GdcmReport& report,
                   char* samples) {
    std::ispanstream stream(file);
    gdcm::ImageReader reader;
    reader.SetStream(stream);
    if (!reader.Read()) return GdcmOutcome::Unreadable;
    const gdcm::Image& image = reader.GetImage();
    const gdcm::PixelFormat& format = image.GetPixelFormat();
    if (format.GetSamplesPerPixel() != 1 || format.GetPixelSize() > gdcm_widest)
        return GdcmOutcome::NoNumbers;
    if (image.GetBufferLength() != count * format.GetPixelSize()) return GdcmOutcome::OtherCount;
    report.bits_allocated = format.GetBitsAllocated();
    report.bits_stored = format.GetBitsStored();
    report.is_signed = format.GetPixelRepresentation() == 1;
    return image.GetBuffer(samples) ? GdcmOutcome::Done : GdcmOutcome::Unreadable;
}

}  // namespace
}  // namespace zeroset

extern "C" __attribute__((visibility("default"))) void zeroset_unpack_by_gdcm(
    const char* file, std::size_t size, std::uint64_t count, zeroset::GdcmReport& report,
    char* samples) {
    try {
        report.outcome = zeroset::unpack({file, size}, count, report, samples);
    } catch (const std::exception&) {
        report.outcome = zeroset::GdcmOutcome::Unreadable;
    }
}
static_assert(std::is_same_v<decltype(&zeroset_unpack_by_gdcm), zeroset::UnpackByGdcm>);
