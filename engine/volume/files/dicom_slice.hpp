#pragma once

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/samples.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

// One file of a DICOM series.

namespace zeroset {

/// What its header says, in the format's axes: x to the left, y to the back, z upward, millimetres.
struct DicomSlice {
    std::filesystem::path file;
    std::string series;                 ///< SeriesInstanceUID
    std::array<double, 3> position{};   ///< of the first sample
    std::array<double, 3> along_row{};  ///< directions of length 1
    std::array<double, 3> down_column{};
    double row_spacing = 1, column_spacing = 1;  ///< between rows, and between columns
    double slope = 1, shift = 0;
    bool one_frame = true;
    bool placed = false;  ///< whether it says where it lies
};

/// Reads a header. An error is what is wrong with the file, without its name.
Expected<DicomSlice> read_dicom_header(const std::filesystem::path& file);

/// The samples of a slice, before slope and shift.
Expected<Samples> read_dicom_samples(const std::filesystem::path& file);

}  // namespace zeroset
