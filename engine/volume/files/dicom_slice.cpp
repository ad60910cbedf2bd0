#include "engine/volume/files/dicom_slice.hpp"

#include "engine/base/text.hpp"
#include "engine/volume/files/dicom_elements.hpp"
#include "engine/volume/files/dicom_packed.hpp"
#include "engine/volume/files/dicom_rle.hpp"

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
constexpr DicomTag frame_offsets = 0x3004000c;
constexpr DicomTag dose_scaling = 0x3004000e;

/// The bytes of a file with its elements.
struct SliceHeader {
    std::string bytes;
    DicomElements elements;
    std::optional<std::size_t> frame = {};  ///< the slice of which it is asked

    [[nodiscard]] std::string text(DicomTag tag) const { return elements.text(bytes, tag, frame); }
    [[nodiscard]] int number(DicomTag tag, int otherwise) const {
        return elements.number(bytes, tag, otherwise);
    }
    /// The `count` finite numbers of an element, or nothing where it does not hold just these.
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

Expected<SliceHeader> read_slice_header(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    SliceHeader header{.bytes = {std::istreambuf_iterator<char>(stream), {}}, .elements = {}};
    if (!stream) return std::unexpected("it cannot be read");
    auto elements = read_dicom_elements(header.bytes);
    if (elements && elements->deflated_from != 0) {
        constexpr std::uint64_t most = std::uint64_t{1} << 32U;
        const std::size_t from = elements->deflated_from;
        const auto rest =
            unpacked_bytes(std::string_view(header.bytes).substr(from), most, PackedAs::Deflate);
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

/// How many slices a file has.
Expected<std::uint64_t> frames_of(const SliceHeader& header) {
    constexpr double most = 1U << 24U;
    double frames = 1;
    const std::string problem = header.take(number_of_frames, "NumberOfFrames", frames);
    if (!problem.empty()) return std::unexpected(problem);
    if (!(frames >= 1 && frames <= most && frames == std::floor(frames))) {
        return std::unexpected(wrong_field("NumberOfFrames", header.text(number_of_frames),
                                           "a whole number from 1 on is wanted"));
    }
    return static_cast<std::uint64_t>(frames);
}

Expected<GridSize> grid_size(const SliceHeader& header) {
    const auto frames = frames_of(header);
    if (!frames) return std::unexpected(frames.error());
    return GridSize{static_cast<std::uint64_t>(header.number(column_count, 0)),
                    static_cast<std::uint64_t>(header.number(row_count, 0)), *frames};
}

std::unexpected<std::string> no_numbers() {
    return std::unexpected(
        std::string("its samples are no single whole numbers of 8, 16 or 32 bits"));
}

/// The type that the header tells of.
std::optional<SampleType> told_type(const SliceHeader& header) {
    return type_of(header.number(bits_allocated, 0), header.number(pixel_representation, 0) == 1);
}

/// From the first sample on, or from what they are packed in.
std::string_view pixels_of(const SliceHeader& header) {
    const auto& pixels = header.elements.elements.at(pixel_data);
    return std::string_view(header.bytes).substr(pixels.offset, pixels.length);
}

Expected<Samples> plain_samples(const SliceHeader& header, const std::filesystem::path& file,
                                const GridSize& size) {
    const auto type = told_type(header);
    if (!type) return no_numbers();
    return samples_from(
        pixels_of(header),
        {.file = file, .type = *type, .big_endian = header.elements.big_endian, .size = size},
        header.number(bits_stored, 0));
}

Expected<Samples> rle_samples(const SliceHeader& header, const std::filesystem::path& file,
                              const GridSize& size) {
    const auto type = told_type(header);
    if (!type) return no_numbers();
    const auto bytes = unpacked_rle(pixels_of(header), size, size_of(*type));
    if (!bytes) return std::unexpected(bytes.error());
    return samples_from(*bytes, {.file = file, .type = *type, .big_endian = false, .size = size},
                        header.number(bits_stored, 0));
}

Expected<Samples> packed_samples(const SliceHeader& header, const std::filesystem::path& file,
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
                        pixels->bits_stored);
}

/// Takes what a header says of a slice; what is wrong with it, or nothing.
std::string take_slice(const SliceHeader& header, DicomSlice& slice) {
    std::string problem = header.take(rescale_slope, "RescaleSlope", slice.slope);
    if (problem.empty()) problem = header.take(dose_scaling, "DoseGridScaling", slice.slope);
    if (problem.empty()) problem = header.take(rescale_intercept, "RescaleIntercept", slice.shift);
    if (!problem.empty()) return problem;
    if (const auto spacing = header.numbers(pixel_spacing, 2)) {
        slice.row_spacing = (*spacing)[0];
        slice.column_spacing = (*spacing)[1];
    } else if (!header.text(pixel_spacing).empty()) {
        return wrong_field("PixelSpacing", header.text(pixel_spacing), "two numbers are wanted");
    }
    const auto place = header.numbers(image_position, 3);
    const auto turn = header.numbers(image_orientation, 6);
    if (!place || !turn) return {};
    slice.placed = true;
    for (std::size_t i = 0; i < 3; ++i) {
        slice.position[i] = (*place)[i];
        slice.along_row[i] = (*turn)[i];
        slice.down_column[i] = (*turn)[i + 3];
    }
    return {};
}

/// Moves slices that all lie at the first one's place along their normal, as the offsets say that
/// doses have (part 3, C.8.8.3.2).
void move_by(const std::vector<double>& offsets, std::vector<DicomSlice>& slices) {
    for (std::size_t k = 0; k < slices.size(); ++k) {
        DicomSlice& slice = slices[k];
        const auto& a = slice.along_row;
        const auto& b = slice.down_column;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t l = (i + 2) % 3;
            slice.position[i] += (offsets[k] - offsets.front()) * (a[j] * b[l] - a[l] * b[j]);
        }
    }
}

}  // namespace

Expected<std::vector<DicomSlice>> read_dicom_header(const std::filesystem::path& file) {
    auto header = read_slice_header(file);
    if (!header) return std::unexpected(header.error());
    const auto frames = frames_of(*header);
    if (!frames) return std::unexpected(frames.error());
    const std::size_t told = header->elements.frames.size();
    if (told != 0 && told != *frames) {
        return std::unexpected("it announces " + std::to_string(*frames) +
                               " slices, and tells of " + std::to_string(told));
    }
    const auto offsets = header->numbers(frame_offsets, *frames);
    if (told == 0 && *frames > 1 && !offsets) {
        return std::unexpected("it holds " + std::to_string(*frames) +
                               " slices, and does not say where each of them lies");
    }
    DicomSlice slice{.file = file, .series = header->text(series_instance_uid)};
    slice.frames = *frames;
    std::vector<DicomSlice> slices(*frames, slice);
    for (std::size_t k = 0; k < slices.size(); ++k) {
        header->frame = k;
        slices[k].frame = k;
        if (auto problem = take_slice(*header, slices[k]); !problem.empty())
            return std::unexpected(problem);
    }
    if (told == 0 && offsets) move_by(*offsets, slices);
    return slices;
}

Expected<Samples> read_dicom_samples(const std::filesystem::path& file) {
    const auto header = read_slice_header(file);
    if (!header) return std::unexpected(header.error());
    if (header->number(samples_per_pixel, 1) != 1) return no_numbers();
    const auto size = grid_size(*header);
    if (!size) return std::unexpected(size.error());
    return is_unpacked(header->elements.transfer_syntax) ? plain_samples(*header, file, *size)
                                                         : packed_samples(*header, file, *size);
}

}  // namespace zeroset
