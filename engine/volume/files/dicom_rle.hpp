#pragma once

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/samples.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace zeroset {

/// The samples of DICOM's run lengths (dicomstandard.org, part 5, annex G) in little endian:
/// `items` are the slices' fragments with what is before and behind them, `bytes` those of a
/// sample. The error is what is wrong with the file, without its name.
Expected<std::string> unpacked_rle(std::string_view items, const GridSize& size, std::size_t bytes);

}  // namespace zeroset
