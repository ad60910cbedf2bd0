#include "engine/volume/files/dicom_slice.hpp"

#include "engine/base/text.hpp"
#include "engine/volume/files/dicom_header.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

constexpr DicomTag kind_in_preface = 0x00020002;
constexpr DicomTag kind_uid = 0x00080016;
constexpr DicomTag instance_uid = 0x00080018;
constexpr DicomTag modality = 0x00080060;
constexpr DicomTag series_description = 0x0008103e;
constexpr DicomTag series_instance_uid = 0x0020000e;
constexpr DicomTag image_position = 0x00200032;
constexpr DicomTag image_orientation = 0x00200037;
constexpr DicomTag pixel_spacing = 0x00280030;
constexpr DicomTag rescale_intercept = 0x00281052;
constexpr DicomTag rescale_slope = 0x00281053;
constexpr DicomTag frame_offsets = 0x3004000c;
constexpr DicomTag dose_scaling = 0x3004000e;

/// How far each number of a text may be from what was rounded to it: half a unit of its last
/// decimal; a whole number is taken to be exact.
std::vector<double> roundings_of(std::string_view text) {
    std::vector<double> roundings;
    for (const std::string_view part : split(text, '\\')) {
        const std::size_t exponent = std::min(part.find_first_of("eE"), part.size());
        const std::size_t point = part.substr(0, exponent).find('.');
        if (point == std::string_view::npos) {
            roundings.push_back(0);
            continue;
        }
        const auto power = number_from<int>(part.substr(std::min(exponent + 1, part.size())));
        const auto decimals = static_cast<double>(exponent - point - 1);
        roundings.push_back(0.5 * std::pow(10.0, power.value_or(0) - decimals));
    }
    return roundings;
}

double largest(const std::vector<double>& numbers) { return std::ranges::max(numbers); }

/// Takes what a header says of a slice; what is wrong with it, or nothing.
std::string take_slice(const DicomHeader& header, DicomSlice& slice) {
    std::string problem = header.take(rescale_slope, "RescaleSlope", slice.slope);
    if (problem.empty()) problem = header.take(dose_scaling, "DoseGridScaling", slice.slope);
    if (problem.empty()) problem = header.take(rescale_intercept, "RescaleIntercept", slice.shift);
    if (!problem.empty()) return problem;
    if (const auto spacing = header.numbers(pixel_spacing, 2)) {
        slice.row_spacing = (*spacing)[0];
        slice.column_spacing = (*spacing)[1];
        slice.spacing_rounding = largest(roundings_of(header.text(pixel_spacing)));
    } else if (!header.text(pixel_spacing).empty()) {
        return wrong_field("PixelSpacing", header.text(pixel_spacing), "two numbers are wanted");
    }
    const auto place = header.numbers(image_position, 3);
    const auto turn = header.numbers(image_orientation, 6);
    if (!place || !turn) return {};
    slice.placed = true;
    const std::vector<double> roundings = roundings_of(header.text(image_position));
    for (std::size_t i = 0; i < 3; ++i) {
        slice.position[i] = (*place)[i];
        slice.along_row[i] = (*turn)[i];
        slice.down_column[i] = (*turn)[i + 3];
        slice.position_rounding[i] = roundings[i];
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

Expected<std::vector<DicomSlice>> slices_of(DicomHeader& header, const DicomSlice& usual) {
    const auto frames = frames_of(header);
    if (!frames) return std::unexpected(frames.error());
    const std::size_t told = header.elements.frames.size();
    if (told != 0 && told != *frames) {
        return std::unexpected("it announces " + std::to_string(*frames) +
                               " slices, and tells of " + std::to_string(told));
    }
    const auto offsets = header.numbers(frame_offsets, *frames);
    if (told == 0 && *frames > 1 && !offsets) {
        return std::unexpected("it holds " + std::to_string(*frames) +
                               " slices, and does not say where each of them lies");
    }
    std::vector<DicomSlice> slices(*frames, usual);
    for (std::size_t k = 0; k < slices.size(); ++k) {
        header.frame = k;
        slices[k].frame = k;
        slices[k].frames = *frames;
        if (auto problem = take_slice(header, slices[k]); !problem.empty())
            return std::unexpected(problem);
    }
    if (told == 0 && offsets) move_by(*offsets, slices);
    return slices;
}

}  // namespace

DicomFile read_dicom_file(const std::filesystem::path& file) {
    DicomHeader header = read_dicom_header(file);
    const auto& elements = header.elements;
    DicomFile result{.file = file,
                     .series = header.text(series_instance_uid),
                     .modality = printable(header.text(modality)),
                     .description = printable(header.text(series_description)),
                     .kind = header.text(kind_uid),
                     .has_samples = elements.has(pixel_data) || elements.has(row_count)};
    if (result.kind.empty()) result.kind = header.text(kind_in_preface);
    result.problem = elements.problem;
    if (result.problem.empty() && !result.has_samples) {
        result.problem = "it holds no samples: name a file of the series that it belongs to";
    } else if (result.problem.empty() && !elements.has(pixel_data)) {
        result.problem = "it ends before its samples";
    } else if (result.problem.empty() && header.number(samples_per_pixel, 1) == 3) {
        result.problem = "its samples are colors; a volume has one number at each point";
    }
    if (!result.problem.empty()) return result;
    const auto& pixels = elements.elements.at(pixel_data);
    const std::string_view samples =
        std::string_view(header.bytes).substr(pixels.offset, pixels.length);
    auto slices = slices_of(header, {.file = file,
                                     .instance = header.text(instance_uid),
                                     .samples_hash = std::hash<std::string_view>{}(samples)});
    if (slices) {
        result.slices = *std::move(slices);
    } else {
        result.problem = slices.error();
    }
    return result;
}

}  // namespace zeroset
