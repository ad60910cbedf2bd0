#pragma once

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
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
    std::string series;                 ///< SeriesInstanceUID
    std::array<double, 3> position{};   ///< of the first sample
    std::array<double, 3> along_row{};  ///< directions of length 1
    std::array<double, 3> down_column{};
    double row_spacing = 1, column_spacing = 1;  ///< between rows, and between columns
    double slope = 1, shift = 0;
    std::size_t frame = 0, frames = 1;  ///< which of its file's slices it is
    bool placed = false;                ///< whether it says where it lies
};

/// Reads a header: the file's slices, in its order, at least one. An error is what is wrong with
/// the file, without its name.
Expected<std::vector<DicomSlice>> read_dicom_header(const std::filesystem::path& file);

/// The samples of a file's slices, one behind the other, before slope and shift.
Expected<Samples> read_dicom_samples(const std::filesystem::path& file);

}  // namespace zeroset
