#include "engine/volume/files/dicom_slice.hpp"

#include "engine/base/text.hpp"
#include "engine/volume/files/dicom_elements.hpp"
#include "engine/volume/files/dicom_packed.hpp"

#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

namespace zeroset {
namespace {

constexpr DicomTag series_instance_uid = 0x0020000e;
constexpr DicomTag image_position = 0x00200032;
constexpr DicomTag image_orientation = 0x00200037;
constexpr DicomTag samples_per_pixel = 0x00280002;
constexpr DicomTag number_of_frames = 0x00280008;
constexpr DicomTag row_count = 0x00280010;
constexpr DicomTag column_count = 0x00280011;
constexpr DicomTag pixel_spacing = 0x00280030;
constexpr DicomTag bits_allocated = 0x00280100;
constexpr DicomTag bits_stored = 0x00280101;
constexpr DicomTag pixel_representation = 0x00280103;
constexpr DicomTag rescale_intercept = 0x00281052;
constexpr DicomTag rescale_slope = 0x00281053;
constexpr DicomTag pixel_data = 0x7fe00010;

/// The bytes of a file with its elements.
struct Header {
    std::string bytes;
    DicomElements elements;

    [[nodiscard]] std::string text(DicomTag tag) const { return elements.text(bytes, tag); }
    [[nodiscard]] int number(DicomTag tag, int otherwise) const {
        return elements.number(bytes, tag, otherwise);
    }
    /// As many finite numbers as there should be, or nothing.
    [[nodiscard]] std::optional<std::vector<double>> numbers(DicomTag tag,
                                                             std::size_t count) const {
        const std::string all = text(tag);
        std::vector<double> numbers;
        for (const std::string_view part : split(all, '\\')) {
            const auto number = number_from<double>(part);
            if (!number || !std::isfinite(*number)) return std::nullopt;
            numbers.push_back(*number);
        }
        if (numbers.size() != count) return std::nullopt;
        return numbers;
    }
    /// Takes a number where there is one; what is wrong with it, or nothing.
    std::string take(DicomTag tag, const char* name, double& number) const {
        if (text(tag).empty()) return {};
        const auto read = numbers(tag, 1);
        if (!read) return wrong_field(name, text(tag), "a number is wanted");
        number = read->front();
        return {};
    }
};

Expected<Header> read_header(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    Header header{.bytes = {std::istreambuf_iterator<char>(stream), {}}, .elements = {}};
    if (!stream) return std::unexpected("it cannot be read");
    auto elements = read_dicom_elements(header.bytes);
    if (elements && elements->deflated_from != 0) {
        constexpr std::uint64_t most = std::uint64_t{1} << 32U;
        const std::size_t from = elements->deflated_from;
        const auto rest =
            unpacked_bytes(std::string_view(header.bytes).substr(from), most, Packing::Deflate);
        if (!rest) return std::unexpected("what is packed in it is damaged");
        header.bytes = header.bytes.substr(0, from) + *rest;
        elements = read_dicom_elements(header.bytes, DeflatedPart::Unpacked);
    }
    if (!elements) return std::unexpected(elements.error());
    header.elements = std::move(*elements);
    return header;
}

std::optional<SampleType> type_of(int bits, bool is_signed) {
    switch (bits) {
        case 8: return is_signed ? SampleType::Int8 : SampleType::UInt8;
        case 16: return is_signed ? SampleType::Int16 : SampleType::UInt16;
        case 32: return is_signed ? SampleType::Int32 : SampleType::UInt32;
        default: return std::nullopt;
    }
}

/// Clears the bits above those that are stored, or fills them with the sign.
template <class Sample>
void keep_bits(Sample* samples, std::uint64_t count, int stored) {
    const int unused = std::numeric_limits<std::make_unsigned_t<Sample>>::digits - stored;
    if (unused <= 0 || stored <= 0) return;
    for (std::uint64_t i = 0; i < count; ++i)
        samples[i] = static_cast<Sample>(static_cast<Sample>(samples[i] << unused) >> unused);
}

bool is_unpacked(const std::string& transfer_syntax) {
    return transfer_syntax == "1.2.840.10008.1.2" || transfer_syntax == "1.2.840.10008.1.2.1" ||
           transfer_syntax == "1.2.840.10008.1.2.2" || transfer_syntax == "1.2.840.10008.1.2.1.99";
}

/// A slice's samples of `stored` bits each, from their bytes.
Expected<Samples> samples_from(std::string_view bytes, const SampleBlock& block, int stored) {
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

GridSize size_of_slice(const Header& header) {
    return {static_cast<std::uint64_t>(header.number(column_count, 0)),
            static_cast<std::uint64_t>(header.number(row_count, 0)), 1};
}

std::unexpected<std::string> no_numbers() {
    return std::unexpected(
        std::string("its samples are no single whole numbers of 8, 16 or 32 bits"));
}

Expected<Samples> plain_samples(const Header& header, const std::filesystem::path& file) {
    const auto type =
        type_of(header.number(bits_allocated, 0), header.number(pixel_representation, 0) == 1);
    if (!type) return no_numbers();
    const auto& pixels = header.elements.elements.at(pixel_data);
    return samples_from(std::string_view(header.bytes).substr(pixels.offset, pixels.length),
                        {.file = file,
                         .type = *type,
                         .big_endian = header.elements.big_endian,
                         .size = size_of_slice(header)},
                        header.number(bits_stored, 0));
}

Expected<Samples> packed_samples(const Header& header, const std::filesystem::path& file) {
    const GridSize size = size_of_slice(header);
    const auto told = [&](const std::string& problem) {
        return std::unexpected(problem + " (transfer syntax '" + header.elements.transfer_syntax +
                               "')");
    };
    constexpr std::string_view item("\xfe\xff\x00\xe0", 4);
    const std::size_t first = header.elements.elements.at(pixel_data).offset;
    if (!std::string_view(header.bytes).substr(first).starts_with(item))
        return told("its packed samples are not there");
    const auto pixels = unpacked_pixels(header.bytes, size[0] * size[1]);
    if (!pixels) return told(pixels.error());
    const auto type = type_of(pixels->bits_allocated, pixels->is_signed);
    if (!type) return no_numbers();
    return samples_from(pixels->bytes,
                        {.file = file,
                         .type = *type,
                         .big_endian = std::endian::native == std::endian::big,
                         .size = size},
                        pixels->bits_stored);
}

}  // namespace

Expected<DicomSlice> read_dicom_header(const std::filesystem::path& file) {
    const auto header = read_header(file);
    if (!header) return std::unexpected(header.error());
    DicomSlice slice{.file = file, .series = header->text(series_instance_uid)};
    double frames = 1;
    std::string problem = header->take(number_of_frames, "NumberOfFrames", frames);
    if (problem.empty()) problem = header->take(rescale_slope, "RescaleSlope", slice.slope);
    if (problem.empty()) problem = header->take(rescale_intercept, "RescaleIntercept", slice.shift);
    if (!problem.empty()) return std::unexpected(problem);
    slice.one_frame = frames == 1;
    if (const auto spacing = header->numbers(pixel_spacing, 2)) {
        slice.row_spacing = (*spacing)[0];
        slice.column_spacing = (*spacing)[1];
    } else if (!header->text(pixel_spacing).empty()) {
        return std::unexpected(
            wrong_field("PixelSpacing", header->text(pixel_spacing), "two numbers are wanted"));
    }
    const auto place = header->numbers(image_position, 3);
    const auto turn = header->numbers(image_orientation, 6);
    if (!place || !turn) return slice;
    slice.placed = true;
    for (std::size_t i = 0; i < 3; ++i) {
        slice.position[i] = (*place)[i];
        slice.along_row[i] = (*turn)[i];
        slice.down_column[i] = (*turn)[i + 3];
    }
    return slice;
}

Expected<Samples> read_dicom_samples(const std::filesystem::path& file) {
    const auto header = read_header(file);
    if (!header) return std::unexpected(header.error());
    if (header->number(samples_per_pixel, 1) != 1) return no_numbers();
    return is_unpacked(header->elements.transfer_syntax) ? plain_samples(*header, file)
                                                         : packed_samples(*header, file);
}

}  // namespace zeroset
