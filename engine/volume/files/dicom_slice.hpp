#pragma once

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/samples.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// One file of a DICOM series: of a slice, or of several.

namespace zeroset {

/// A slice by its header, in the format's axes: x to the left, y to the back, z upward,
/// millimetres.
struct DicomSlice {
    std::filesystem::path file;
    std::string instance = {};          ///< SOPInstanceUID of the file
    std::size_t samples_hash = 0;       ///< of the file's samples as they are stored
    std::array<double, 3> position{};   ///< of the first sample
    std::array<double, 3> along_row{};  ///< directions of length 1
    std::array<double, 3> down_column{};
    double row_spacing = 1, column_spacing = 1;  ///< between rows, and between columns
    /// How far the numbers may be from what was rounded to their texts.
    std::array<double, 3> position_rounding{};
    double spacing_rounding = 0;
    double slope = 1, shift = 0;
    std::size_t frame = 0, frames = 1;  ///< which of its file's slices it is
    bool placed = false;                ///< whether it says where it lies
};

/// A file of DICOM by its header.
struct DicomFile {
    std::filesystem::path file;
    std::string series;                   ///< SeriesInstanceUID; empty where it is not told
    std::string modality, description;    ///< as a terminal may show them
    std::string kind;                     ///< SOPClassUID
    bool has_samples = false;             ///< or a size of a picture, which announces them
    std::vector<DicomSlice> slices = {};  ///< in the file's order
    std::string problem = {};             ///< why there are no slices, without the file's name
};
DicomFile read_dicom_file(const std::filesystem::path& file);

/// The samples of a file's slices, one behind the other, before slope and shift.
Expected<Samples> read_dicom_samples(const std::filesystem::path& file);

}  // namespace zeroset
