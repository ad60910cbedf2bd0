#pragma once

#include "engine/language/vocabulary/field_source.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace zeroset {

/// Which files the texts of a session may name.
struct VolumeFolder {
    std::filesystem::path folder;  ///< relative names start here
    /// Whether only files in it and in the folders below may be read, as the document comes from
    /// elsewhere.
    bool closed = false;

    bool operator==(const VolumeFolder&) const = default;
};

/// Allows a file that someone has chosen, wherever it lies, to all documents of the process.
void allow_volume(const std::filesystem::path& file);

/// Grows whenever texts that name files may read otherwise than before: as a file is allowed, and
/// with look_for_changed_files().
std::uint64_t files_version();

/// Whether a file that a living formula was read from has changed, and is not being written any
/// more: files_version() has grown then. To be called from time to time. Thread-safe.
bool look_for_changed_files();

/// The files that texts have named and were refused for where they lie, since the last call.
std::vector<std::filesystem::path> take_refused_volumes();

/// The volumes of the given folder, for documents' texts (Document::files).
std::shared_ptr<const FieldSource> volume_source(const VolumeFolder& folder);

}  // namespace zeroset
