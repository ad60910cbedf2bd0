#include "engine/volume/files/volume_file.hpp"

#include "engine/volume/files/dicom_elements.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <span>
#include <utility>

namespace zeroset {
namespace {

using ReadFile = std::expected<VolumeFile, std::string>;

struct VolumeFormat {
    std::string_view ending;
    ReadFile (*read)(const std::filesystem::path& file);
};
constexpr std::array formats{VolumeFormat{.ending = ".nrrd", .read = read_nrrd},
                             VolumeFormat{.ending = ".nhdr", .read = read_nrrd},
                             VolumeFormat{.ending = ".mhd", .read = read_meta_image},
                             VolumeFormat{.ending = ".mha", .read = read_meta_image},
                             VolumeFormat{.ending = ".nii", .read = read_nifti},
                             VolumeFormat{.ending = ".nii.gz", .read = read_nifti},
                             VolumeFormat{.ending = ".hdr", .read = read_nifti},
                             VolumeFormat{.ending = ".hdr.gz", .read = read_nifti},
                             VolumeFormat{.ending = ".img", .read = read_nifti},
                             VolumeFormat{.ending = ".img.gz", .read = read_nifti},
                             VolumeFormat{.ending = ".vti", .read = read_vtk_image},
                             VolumeFormat{.ending = ".vtk", .read = read_vtk_legacy},
                             VolumeFormat{.ending = ".tif", .read = read_tiff_stack},
                             VolumeFormat{.ending = ".tiff", .read = read_tiff_stack},
                             VolumeFormat{.ending = ".mgh", .read = read_mgh},
                             VolumeFormat{.ending = ".mgz", .read = read_mgh},
                             VolumeFormat{.ending = ".mgh.gz", .read = read_mgh},
                             VolumeFormat{.ending = ".mrc", .read = read_mrc},
                             VolumeFormat{.ending = ".map", .read = read_mrc},
                             VolumeFormat{.ending = ".ccp4", .read = read_mrc},
                             VolumeFormat{.ending = ".mrc.gz", .read = read_mrc},
                             VolumeFormat{.ending = ".map.gz", .read = read_mrc}};

const VolumeFormat* format_of(const std::filesystem::path& file) {
    const std::string name = lower_case(file.filename().string());
    const auto* const found = std::ranges::find_if(
        formats, [&](const VolumeFormat& format) { return name.ends_with(format.ending); });
    return found == formats.end() ? nullptr : found;
}

ReadFile read_raw(const std::filesystem::path& file, const RawLayout& layout) {
    SampleBlock block{.file = file, .offset = layout.skip};
    block.type = layout.type;
    block.big_endian = layout.big_endian;
    block.size = *layout.size;
    // The first bytes of samples may look like gzip's, but then there are enough of them.
    std::error_code error;
    const auto needed = bytes_of(block.size, block.type);
    if (is_packed(file) && (lower_case(file.extension().string()) == ".gz" || !needed ||
                            std::filesystem::file_size(file, error) < *needed)) {
        block.encoding = SampleEncoding::Gzip;
        block.skip_unpacked = std::exchange(block.offset, 0);
    }
    const auto samples = read_samples(block);
    if (!samples) return std::unexpected(samples.error());
    VolumeFile volume{.samples = *samples, .geometry = {}};
    for (std::size_t i = 0; i < 3; ++i)
        volume.geometry.world_from_index[i][i] = layout.spacing[i];
    volume.geometry.origin = layout.origin;
    return volume;
}

/// A volume that was read, and its files as they were then.
struct KnownFile {
    std::filesystem::path file;  ///< that was asked for
    RawLayout layout;
    std::vector<FileStamp> stamps;
    std::weak_ptr<const VolumeData> data;
};

class KnownFiles {
public:
    std::shared_ptr<const VolumeData> find(const std::filesystem::path& file,
                                           const RawLayout& layout) {
        const std::scoped_lock lock(mutex_);
        std::erase_if(files_, [](const KnownFile& known) { return known.data.expired(); });
        const auto same = std::ranges::find_if(files_, [&](const KnownFile& known) {
            return known.file == file && known.layout == layout &&
                   std::ranges::all_of(known.stamps, &FileStamp::is_still_so);
        });
        return same == files_.end() ? nullptr : same->data.lock();
    }
    std::vector<FileStamp> stamps_of(const VolumeData& data) {
        const std::scoped_lock lock(mutex_);
        const auto same = std::ranges::find_if(
            files_, [&](const KnownFile& known) { return known.data.lock().get() == &data; });
        return same == files_.end() ? std::vector<FileStamp>{} : same->stamps;
    }
    void add(KnownFile file) {
        const std::scoped_lock lock(mutex_);
        files_.push_back(std::move(file));
    }

private:
    std::mutex mutex_;
    std::vector<KnownFile> files_;
};

KnownFiles& known_files() {
    static KnownFiles known;
    return known;
}

/// Whether a folder has a file of DICOM.
bool is_dicom_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error)) return false;
    const std::filesystem::directory_iterator files(folder, error);
    return std::any_of(begin(files), end(files),
                       [](const auto& entry) { return is_dicom_file(entry.path()); });
}

}  // namespace

bool is_dicom_file(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return false;
    const auto start = first_bytes(file, dicom_start);
    return start && starts_as_dicom(*start);
}

std::string known_endings() {
    std::string text;
    for (const VolumeFormat& format : formats)
        text += (text.empty() ? "" : " ") + std::string(format.ending);
    return text;
}

bool is_volume_file(const std::filesystem::path& file) {
    return format_of(file) != nullptr || is_dicom_file(file) || is_dicom_folder(file);
}

ReadFile read_volume_file(const std::filesystem::path& file, const RawLayout& layout) {
    if (layout.size) return read_raw(file, layout);
    const VolumeFormat* const format = format_of(file);
    if (format != nullptr) return format->read(file);
    if (is_dicom_file(file) || is_dicom_folder(file)) return read_dicom(file);
    return std::unexpected("it is read as raw samples only, of sizes that are typed behind it");
}

std::expected<std::shared_ptr<const VolumeData>, std::string> open_volume(
    const std::filesystem::path& file, const RawLayout& layout) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::unexpected("there is no such file");
    const bool is_file = std::filesystem::is_regular_file(file, error);
    if (!is_file && !is_dicom_folder(file)) return std::unexpected("it is no file");
    KnownFile key{.file = std::filesystem::weakly_canonical(file, error),
                  .layout = layout,
                  .stamps = {},
                  .data = {}};
    if (auto data = known_files().find(key.file, layout)) return data;
    // A file of DICOM stands for its series, which is all over its folder.
    key.stamps.push_back(
        FileStamp::now(is_file && is_dicom_file(file) ? key.file.parent_path() : key.file));
    const auto read = read_volume_file(file, layout);
    if (!read) return std::unexpected(read.error());
    std::ranges::copy(read->sample_files, std::back_inserter(key.stamps));
    auto data = VolumeData::make(read->samples, read->geometry);
    if (!data) return std::unexpected(data.error());
    key.data = *data;
    known_files().add(std::move(key));
    return *data;
}

std::vector<FileStamp> files_of(const VolumeData& data) { return known_files().stamps_of(data); }

}  // namespace zeroset
