#pragma once

#include "engine/volume/files/dicom_slice.hpp"

#include <filesystem>
#include <vector>

namespace zeroset {

/// The slices of a series: that which a file is of, or the only one in a folder. Files of the
/// folder without samples or of other series are passed over, whatever is wrong with them. In a
/// folder without slices that has a DICOMDIR those in the folders below it are looked for. An error
/// is one line; of several series it offers a file of each.
Expected<std::vector<DicomSlice>> slices_of_series(const std::filesystem::path& path);

/// "'FILE' of the series: "
std::string of_the_series(const std::filesystem::path& file);

}  // namespace zeroset
