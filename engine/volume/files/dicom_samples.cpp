#include "engine/base/text.hpp"
#include "engine/volume/files/dicom_header.hpp"
#include "engine/volume/files/dicom_packed.hpp"
#include "engine/volume/files/dicom_rle.hpp"
#include "engine/volume/files/dicom_slice.hpp"
#include "engine/volume/files/sample_file.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

namespace zeroset {
namespace {

constexpr DicomTag column_count = 0x00280011;
constexpr DicomTag bits_allocated = 0x00280100;
constexpr DicomTag bits_stored = 0x00280101;
constexpr DicomTag high_bit = 0x00280102;
constexpr DicomTag pixel_representation = 0x00280103;

std::optional<SampleType> type_of(int bits, bool is_signed) {
    switch (bits) {
        case 8: return is_signed ? SampleType::Int8 : SampleType::UInt8;
        case 16: return is_signed ? SampleType::Int16 : SampleType::UInt16;
        case 32: return is_signed ? SampleType::Int32 : SampleType::UInt32;
        default: return std::nullopt;
    }
}

/// Which bits of a sample are its number.
struct StoredBits {
    int count = 0;  ///< 0 or less: all
    int high = 0;   ///< the highest of them
};

/// Drops the bits below those that are stored, and clears those above, or fills them with the sign.
template <class Sample>
void keep_bits(Sample* samples, std::uint64_t count, const StoredBits& stored) {
    constexpr int digits = std::numeric_limits<std::make_unsigned_t<Sample>>::digits;
    if (stored.count <= 0 || stored.count >= digits) return;
    const int above = digits - 1 - std::clamp(stored.high, stored.count - 1, digits - 1);
    for (std::uint64_t i = 0; i < count; ++i)
        samples[i] = static_cast<Sample>(static_cast<Sample>(samples[i] << above) >>
                                         (digits - stored.count));
}

bool is_unpacked(const std::string& transfer_syntax) {
    return transfer_syntax == "1.2.840.10008.1.2" || transfer_syntax == "1.2.840.10008.1.2.1" ||
           transfer_syntax == "1.2.840.10008.1.2.2" || transfer_syntax == "1.2.840.10008.1.2.1.99";
}

/// A slice's samples from their bytes.
Expected<Samples> samples_from(std::string_view bytes, const SampleBlock& block,
                               const StoredBits& stored) {
    auto samples = samples_of_bytes(bytes, block);
    if (!samples) return samples;
    visit_samples(*samples, [&](const auto* in) {
        using Sample = std::remove_cvref_t<decltype(*in)>;
        if constexpr (std::is_integral_v<Sample>) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): they are nobody else's yet
            keep_bits(const_cast<Sample*>(in), samples->count(), stored);
        }
    });
    return samples;
}

std::unexpected<std::string> no_numbers() {
    return std::unexpected(
        std::string("its samples are no single whole numbers of 8, 16 or 32 bits"));
}

/// The type that the header tells of.
std::optional<SampleType> told_type(const DicomHeader& header) {
    return type_of(header.number(bits_allocated, 0), header.number(pixel_representation, 0) == 1);
}

StoredBits told_bits(const DicomHeader& header) {
    const int stored = header.number(bits_stored, 0);
    return {.count = stored, .high = header.number(high_bit, stored - 1)};
}

/// From the first sample on, or from what they are packed in.
std::string_view pixels_of(const DicomHeader& header) {
    const auto& pixels = header.elements.elements.at(pixel_data);
    return std::string_view(header.bytes).substr(pixels.offset, pixels.length);
}

Expected<Samples> plain_samples(const DicomHeader& header, const std::filesystem::path& file,
                                const GridSize& size) {
    const auto type = told_type(header);
    if (!type) return no_numbers();
    return samples_from(
        pixels_of(header),
        {.file = file, .type = *type, .big_endian = header.elements.big_endian, .size = size},
        told_bits(header));
}

Expected<Samples> rle_samples(const DicomHeader& header, const std::filesystem::path& file,
                              const GridSize& size) {
    const auto type = told_type(header);
    if (!type) return no_numbers();
    const auto bytes = unpacked_rle(pixels_of(header), size, size_of(*type));
    if (!bytes) return std::unexpected(bytes.error());
    return samples_from(*bytes, {.file = file, .type = *type, .big_endian = false, .size = size},
                        told_bits(header));
}

Expected<Samples> packed_samples(const DicomHeader& header, const std::filesystem::path& file,
                                 const GridSize& size) {
    const auto told = [&](const std::string& problem) {
        return std::unexpected(problem + " (transfer syntax '" +
                               printable(header.elements.transfer_syntax) + "')");
    };
    constexpr std::string_view item("\xfe\xff\x00\xe0", 4);
    if (!pixels_of(header).starts_with(item)) return told("its packed samples are not there");
    if (header.elements.transfer_syntax == "1.2.840.10008.1.2.5")
        return rle_samples(header, file, size);
    const auto pixels = unpacked_pixels(header.bytes, size[0] * size[1] * size[2]);
    if (!pixels) return told(pixels.error());
    const auto type = type_of(pixels->bits_allocated, pixels->is_signed);
    if (!type) return no_numbers();
    return samples_from(pixels->bytes,
                        {.file = file,
                         .type = *type,
                         .big_endian = std::endian::native == std::endian::big,
                         .size = size},
                        {.count = pixels->bits_stored, .high = pixels->bits_stored - 1});
}

}  // namespace

Expected<Samples> read_dicom_samples(const std::filesystem::path& file) {
    const auto header = read_dicom_header(file);
    if (!header.elements.problem.empty()) return std::unexpected(header.elements.problem);
    if (!header.elements.has(pixel_data)) return std::unexpected("it ends before its samples");
    if (header.number(samples_per_pixel, 1) != 1) return no_numbers();
    const auto frames = frames_of(header);
    if (!frames) return std::unexpected(frames.error());
    const GridSize size{static_cast<std::uint64_t>(header.number(column_count, 0)),
                        static_cast<std::uint64_t>(header.number(row_count, 0)), *frames};
    return is_unpacked(header.elements.transfer_syntax) ? plain_samples(header, file, size)
                                                        : packed_samples(header, file, size);
}

}  // namespace zeroset
