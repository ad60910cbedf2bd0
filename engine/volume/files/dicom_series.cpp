// A DICOM series: files of one slice or several each, in a folder (dicomstandard.org, part 3,
// C.7.6).

#include "engine/base/text.hpp"
#include "engine/volume/files/dicom_folder.hpp"
#include "engine/volume/files/dicom_slice.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace zeroset {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool are_near(const Vector& a, const Vector& b) {
    constexpr double most = 1e-3;
    return std::abs(a[0] - b[0]) < most && std::abs(a[1] - b[1]) < most &&
           std::abs(a[2] - b[2]) < most;
}

/// Whether two spacings may be one number that was rounded to two texts; those of few digits are
/// exact rather than rounded by as much as these allow.
bool are_one(double a, double b, double rounding) {
    constexpr double least = 1e-6, most = 0.01;  // of the spacing
    return std::abs(a - b) <= std::clamp(rounding, least * std::abs(a), most * std::abs(a));
}

/// The reason why the slices are no grid, or nothing.
std::string uneven(const std::vector<DicomSlice>& slices) {
    const DicomSlice& first = slices.front();
    for (const DicomSlice& slice : slices) {
        if (!slice.placed) return of_the_series(slice.file) + "it does not say where it lies";
        const double rounding = first.spacing_rounding + slice.spacing_rounding;
        if (!are_near(slice.along_row, first.along_row) ||
            !are_near(slice.down_column, first.down_column) ||
            !are_one(slice.row_spacing, first.row_spacing, rounding) ||
            !are_one(slice.column_spacing, first.column_spacing, rounding))
            return of_the_series(slice.file) + "it is turned or spaced otherwise than others";
    }
    return {};
}

/// How far a difference of heights along the normal may be off by the rounding of positions to
/// their texts. Trailing zeros are left out of texts, so the longest of them tells.
double rounding_of_gaps(const std::vector<DicomSlice>& slices, const Vector& normal) {
    double rounding = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double least = 0;
        for (const DicomSlice& slice : slices) {
            const double own = slice.position_rounding[i];
            if (own > 0 && (least == 0 || own < least)) least = own;
        }
        rounding += 2 * std::abs(normal[i]) * least;
    }
    return rounding;
}

/// Orders the slices along their normal; what keeps them from being evenly spaced, or nothing.
std::string order(std::vector<DicomSlice>& slices) {
    const Vector normal = cross(slices.front().along_row, slices.front().down_column);
    const auto height = [&](const DicomSlice& slice) { return dot(normal, slice.position); };
    std::ranges::sort(slices, {}, height);
    if (slices.size() < 2) return {};
    std::vector<double> gaps;
    for (std::size_t k = 1; k < slices.size(); ++k)
        gaps.push_back(height(slices[k]) - height(slices[k - 1]));
    const auto name = [&](std::size_t k) {
        const DicomSlice& slice = slices[k];
        const std::string file = "'" + printable(slice.file.filename().string()) + "'";
        return slice.frames == 1 ? file
                                 : "slice " + std::to_string(slice.frame + 1) + " of " + file;
    };
    for (std::size_t k = 1; k < slices.size(); ++k) {
        constexpr double least = 1e-4;  // millimetres
        if (gaps[k - 1] < least) {
            return "two of its slices lie at one place, as " + name(k) + " and " + name(k - 1) +
                   ": a volume has one time and one echo";
        }
    }
    std::vector<double> sorted = gaps;
    std::ranges::sort(sorted);
    const double usual = sorted[(sorted.size() - 1) / 2];
    const auto off = [&](double gap) { return std::abs(gap - usual); };
    const auto worst = std::ranges::max_element(gaps, {}, off);
    constexpr double tolerance = 0.01;
    const double rounding = std::min(rounding_of_gaps(slices, normal), usual / 2);
    if (off(*worst) <= tolerance * usual + rounding) return {};
    const auto k = static_cast<std::size_t>(worst - gaps.begin()) + 1;
    return "its slices are not evenly spaced: below " + name(k) + " lie " +
           short_number(*worst, 4) + " mm, elsewhere about " + short_number(usual, 4) + " mm";
}

/// From the format's axes to those of RAS.
Geometry geometry_of(const std::vector<DicomSlice>& slices) {
    const DicomSlice& first = slices.front();
    const DicomSlice& last = slices.back();
    const DicomSlice& spaced = *std::ranges::min_element(slices, {}, &DicomSlice::spacing_rounding);
    const double steps = std::max<double>(1, static_cast<double>(slices.size()) - 1);
    Geometry geometry;
    for (std::size_t r = 0; r < 3; ++r) {
        const double sign = r < 2 ? -1 : 1;
        geometry.world_from_index[r] = {sign * first.along_row[r] * spaced.column_spacing,
                                        sign * first.down_column[r] * spaced.row_spacing,
                                        sign * (last.position[r] - first.position[r]) / steps};
        geometry.origin[r] = sign * first.position[r];
    }
    return geometry;
}

/// The samples of all slices as they are stored. Files of several slices are read once.
Expected<Samples> stacked(const std::vector<DicomSlice>& slices) {
    const auto bytes = std::make_shared<std::vector<char>>();
    std::map<std::filesystem::path, Samples> read;
    Samples all;
    for (const DicomSlice& slice : slices) {
        if (!read.contains(slice.file)) {
            if (slice.frames == 1) read.clear();
            auto samples = read_dicom_samples(slice.file);
            if (!samples) return std::unexpected(of_the_series(slice.file) + samples.error());
            read[slice.file] = std::move(*samples);
        }
        const Samples& samples = read[slice.file];
        if (&slice == &slices.front()) all = samples;
        if (samples.type != all.type || samples.size[0] != all.size[0] ||
            samples.size[1] != all.size[1]) {
            return std::unexpected(of_the_series(slice.file) + "it has other sizes than others, " +
                                   std::to_string(samples.size[0]) + " x " +
                                   std::to_string(samples.size[1]) + " samples of " +
                                   std::string(name_of(samples.type)));
        }
        if (slice.frame >= samples.size[2])
            return std::unexpected(of_the_series(slice.file) + "it changed while it was read");
        const std::uint64_t each = samples.size[0] * samples.size[1] * size_of(samples.type);
        const auto* const first = static_cast<const char*>(samples.data.get()) + slice.frame * each;
        bytes->insert(bytes->end(), first, first + each);
    }
    all.size[2] = slices.size();
    all.data = std::shared_ptr<const void>(bytes, bytes->data());
    return all;
}

/// The samples with each slice's own slope and shift, in double.
Samples scaled_by_slice(const Samples& samples, const std::vector<DicomSlice>& slices) {
    const auto numbers = std::make_shared<std::vector<double>>();
    numbers->reserve(samples.count());
    visit_samples(samples, [&](const auto* in) {
        const std::uint64_t each = samples.size[0] * samples.size[1];
        for (std::uint64_t i = 0; i < samples.count(); ++i) {
            const DicomSlice& slice = slices[i / each];
            numbers->push_back(static_cast<double>(in[i]) * slice.slope + slice.shift);
        }
    });
    return {.type = SampleType::Double,
            .size = samples.size,
            .data = std::shared_ptr<const void>(numbers, numbers->data())};
}

Expected<Samples> scaled(const Samples& samples, const std::vector<DicomSlice>& slices) {
    const DicomSlice& first = slices.front();
    const bool alike = std::ranges::all_of(slices, [&](const DicomSlice& slice) {
        return slice.slope == first.slope && slice.shift == first.shift;
    });
    if (!alike) return rescaled(scaled_by_slice(samples, slices), 1, 0);
    if (first.slope == 1 && first.shift == 0) return samples;
    return rescaled(samples, first.slope, first.shift);
}

}  // namespace

Expected<VolumeFile> read_dicom(const std::filesystem::path& path) {
    auto slices = slices_of_series(path);
    if (!slices) return std::unexpected(slices.error());
    if (auto problem = uneven(*slices); !problem.empty()) return std::unexpected(problem);
    if (auto problem = order(*slices); !problem.empty()) return std::unexpected(problem);
    const auto samples = stacked(*slices);
    if (!samples) return std::unexpected(samples.error());
    const auto whole = scaled(*samples, *slices);
    if (!whole) return std::unexpected(whole.error());
    VolumeFile volume{.samples = *whole, .geometry = geometry_of(*slices)};
    // The folder that was asked for has a stamp already.
    std::error_code error;
    const std::filesystem::path folder =
        std::filesystem::is_directory(path, error) ? path : path.parent_path();
    std::set<std::filesystem::path> others;
    for (const DicomSlice& slice : *slices)
        others.insert(slice.file.parent_path());
    others.erase(folder);
    for (const std::filesystem::path& other : others)
        volume.sample_files.push_back(FileStamp::now(other));
    return volume;
}

}  // namespace zeroset
