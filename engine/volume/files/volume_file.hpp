#pragma once

#include "engine/base/file_stamp.hpp"
#include "engine/volume/geometry.hpp"
#include "engine/volume/samples.hpp"
#include "engine/volume/volume.hpp"

#include <array>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Files of volumes. World axes are those of RAS where a file says what its axes are in a body: x to
// the right, y to the front, z upward, in millimetres; else they are the file's own.

namespace zeroset {

/// The layout of a file without a header.
struct RawLayout {
    std::optional<GridSize> size;  ///< absent: the file tells it
    SampleType type = SampleType::UInt8;
    bool big_endian = false;
    std::uint64_t skip = 0;  ///< bytes before the samples
    std::array<double, 3> spacing{1, 1, 1};
    std::array<double, 3> origin{};

    bool operator==(const RawLayout&) const = default;
};

/// The contents of a file, before its pyramid is built.
struct VolumeFile {
    Samples samples;
    Geometry geometry;
    /// The files that hold the samples, where these are not the file that was asked for.
    std::vector<FileStamp> sample_files{};
};

/// Reads a file by its name's ending; an error is one line without the file's name.
std::expected<VolumeFile, std::string> read_volume_file(const std::filesystem::path& file,
                                                        const RawLayout& layout);

/// Reads a file and builds its pyramid. While the volume of an unchanged file, with unchanged
/// files of samples, lives it is given again. Thread-safe.
std::expected<std::shared_ptr<const VolumeData>, std::string> open_volume(
    const std::filesystem::path& file, const RawLayout& layout);

/// The files that a volume of open_volume was read from, as they were then. Thread-safe.
std::vector<FileStamp> files_of(const VolumeData& data);

/// The endings of the files that are read, with their points, in lower case.
std::string known_endings();
/// Whether a file begins as those of DICOM do.
bool is_dicom_file(const std::filesystem::path& file);
/// Whether the name ends so that it is a volume's, but for raw ones; or it is a file of DICOM, or a
/// folder with such files.
bool is_volume_file(const std::filesystem::path& file);

// Readers of the formats, by what the files' names end in.
std::expected<VolumeFile, std::string> read_nrrd(const std::filesystem::path& file);
std::expected<VolumeFile, std::string> read_meta_image(const std::filesystem::path& file);
std::expected<VolumeFile, std::string> read_nifti(const std::filesystem::path& file);
std::expected<VolumeFile, std::string> read_vtk_image(const std::filesystem::path& file);
std::expected<VolumeFile, std::string> read_vtk_legacy(const std::filesystem::path& file);
std::expected<VolumeFile, std::string> read_mgh(const std::filesystem::path& file);
std::expected<VolumeFile, std::string> read_mrc(const std::filesystem::path& file);
std::expected<VolumeFile, std::string> read_tiff_stack(const std::filesystem::path& file);
/// Reads the series that a file is of, or the one that is in a folder.
std::expected<VolumeFile, std::string> read_dicom(const std::filesystem::path& path);

}  // namespace zeroset
