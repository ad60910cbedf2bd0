#pragma once

#include "engine/base/file_stamp.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

// Grids whose samples lie in several files, as headers of NRRD and MetaImage name them.

namespace zeroset {

/// Whether a header's field names several files in its folder: "LIST", or a name with a number to
/// count; a file of that very name is one.
bool names_several_files(std::string_view field, const std::filesystem::path& folder);

/// Samples, and the files beside the header's that hold them.
struct FoundSamples {
    Samples samples;
    std::vector<FileStamp> files{};
};

/// Reads a block as read_samples does; an error names the block's file where that is not the one of
/// the header.
Expected<FoundSamples> read_samples_of(const std::filesystem::path& header,
                                       const SampleBlock& block);

/// A grid in several files.
struct SeveralFiles {
    /// "LIST", with one name a line in `lines`, or a name and the numbers in it, "slice%03d.raw
    /// FIRST LAST STEP"; a number behind tells how many axes each file has, without it all but the
    /// last.
    std::string_view field;
    std::string_view lines;
    std::filesystem::path folder;      ///< that the names begin in
    std::vector<std::uint64_t> sizes;  ///< of all axes of the header
};

/// Reads files that follow each other as the grid of `block`. `started` tells where the samples
/// begin in the file of the block that it gets. Room is made once all files are there and long
/// enough.
Expected<FoundSamples> read_several(
    const SeveralFiles& files, const SampleBlock& block,
    const std::function<Expected<SampleBlock>(const SampleBlock&)>& started);

}  // namespace zeroset
