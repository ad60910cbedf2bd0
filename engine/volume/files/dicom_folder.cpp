#include "engine/volume/files/dicom_folder.hpp"

#include "engine/base/text.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// The files of each series, in the order of their names.
using FilesOfSeries = std::map<std::string, std::vector<DicomFile>>;

/// Adds the files of a folder; the error that its listing ends with.
template <class Iterator>
std::error_code add_files(const fs::path& folder, FilesOfSeries& series) {
    std::error_code error;
    std::error_code ignored;
    std::vector<fs::path> files;
    constexpr auto options = fs::directory_options::skip_permission_denied;
    for (Iterator at(folder, options, error); at != Iterator(); at.increment(error)) {
        if (at->is_regular_file(ignored) && is_dicom_file(at->path())) files.push_back(at->path());
    }
    std::ranges::sort(files);
    for (const fs::path& path : files) {
        DicomFile file = read_dicom_file(path);
        series[file.series].push_back(std::move(file));
    }
    return error;
}

bool has_samples(const std::vector<DicomFile>& files) {
    return std::ranges::any_of(files, &DicomFile::has_samples);
}

Expected<FilesOfSeries> files_in(const fs::path& folder) {
    FilesOfSeries series;
    std::error_code error = add_files<fs::directory_iterator>(folder, series);
    const bool has_slices = std::ranges::any_of(
        series, [](const auto& of_series) { return has_samples(of_series.second); });
    std::error_code ignored;
    if (!error && !has_slices && fs::exists(folder / "DICOMDIR", ignored))
        error = add_files<fs::recursive_directory_iterator>(folder, series);
    if (error) return std::unexpected("its folder cannot be read: " + error.message());
    return series;
}

/// "'ct/IM0' (CT, 'head', 12 slices)"
std::string offer(const std::vector<DicomFile>& files, const fs::path& folder) {
    std::size_t slices = 0;
    for (const DicomFile& file : files)
        slices += std::max<std::size_t>(file.slices.size(), file.has_samples ? 1 : 0);
    const DicomFile& first = *std::ranges::find_if(files, &DicomFile::has_samples);
    std::string text = "'" + printable(first.file.lexically_relative(folder).string()) + "' (";
    if (!first.modality.empty()) text += first.modality + ", ";
    if (!first.description.empty()) text += "'" + first.description + "', ";
    return text + std::to_string(slices) + (slices == 1 ? " slice)" : " slices)");
}

/// The one series in a folder that has samples.
Expected<std::string> only_series(const FilesOfSeries& series, const fs::path& folder) {
    std::vector<const FilesOfSeries::value_type*> found;
    for (const auto& of_series : series) {
        if (has_samples(of_series.second)) found.push_back(&of_series);
    }
    if (found.empty()) return std::unexpected("it holds no slices of DICOM");
    if (found.size() == 1) return found.front()->first;
    constexpr std::size_t most = 8;
    std::string offers;
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i) {
        const bool last = i + 1 == found.size();
        offers += (i == 0 ? "" : last ? " or " : ", ") + offer(found[i]->second, folder);
    }
    if (found.size() > most) offers += ", and " + std::to_string(found.size() - most) + " more";
    return std::unexpected("it holds " + std::to_string(found.size()) +
                           " series: name a file of one of them, as " + offers);
}

/// Whether a file without samples is no slice of a series of these files, but something beside
/// them: a structure set, a presentation, a directory.
bool is_beside(const DicomFile& file, const std::vector<DicomFile>& files) {
    const auto is_alike = [&](const DicomFile& other) {
        return other.has_samples && other.kind == file.kind;
    };
    return !file.has_samples && !file.kind.empty() && std::ranges::none_of(files, is_alike);
}

/// Drops slices that are there twice, as a folder has that was filled twice.
void drop_equal(std::vector<DicomSlice>& slices) {
    const auto key = [](const DicomSlice& slice) {
        return std::tie(slice.instance, slice.frame, slice.samples_hash, slice.position);
    };
    std::ranges::stable_sort(slices, {}, key);
    const auto [first, last] =
        std::ranges::unique(slices, [&](const DicomSlice& a, const DicomSlice& b) {
            return !a.instance.empty() && a.file != b.file && key(a) == key(b);
        });
    slices.erase(first, last);
}

}  // namespace

std::string of_the_series(const fs::path& file) {
    return "'" + printable(file.filename().string()) + "' of the series: ";
}

Expected<std::vector<DicomSlice>> slices_of_series(const fs::path& path) {
    constexpr std::string_view directory = "1.2.840.10008.1.3.10";
    std::error_code error;
    fs::path folder = path;
    Expected<std::string> wanted;
    bool is_folder = fs::is_directory(path, error);
    if (!is_folder) {
        const DicomFile own = read_dicom_file(path);
        folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
        is_folder = own.kind == directory;
        if (!is_folder && !own.problem.empty()) return std::unexpected(own.problem);
        wanted = own.series;
    }
    const auto series = files_in(folder);
    if (!series) return std::unexpected(series.error());
    if (is_folder) wanted = only_series(*series, folder);
    if (!wanted) return std::unexpected(wanted.error());
    const auto found = series->find(*wanted);
    if (found == series->end()) return std::unexpected("it changed while it was read");
    std::vector<DicomSlice> slices;
    for (const auto& [uid, files] : *series) {
        // A damaged file that does not say of which series it is may be a slice.
        if (uid != *wanted && !uid.empty()) continue;
        for (const DicomFile& file : files) {
            if (is_beside(file, found->second) || (uid != *wanted && file.problem.empty()))
                continue;
            if (!file.problem.empty())
                return std::unexpected(of_the_series(file.file) + file.problem);
            std::ranges::copy(file.slices, std::back_inserter(slices));
        }
    }
    drop_equal(slices);
    return slices;
}

}  // namespace zeroset
