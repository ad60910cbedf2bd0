#pragma once

#include "engine/language/vocabulary/field_source.hpp"
#include "pipeline/file_access.hpp"

#include <filesystem>
#include <memory>

namespace zeroset {

/// Which files the texts of a session may name.
struct VolumeFolder {
    std::filesystem::path folder;  ///< relative names start here
    /// Whether only files in it and in the folders below may be read, as the document comes from
    /// elsewhere.
    bool closed = false;

    bool operator==(const VolumeFolder&) const = default;
};

/// The volumes of the given folder, for documents' texts (Document::files). `access`: of the window
/// or the command that reads them.
std::shared_ptr<const FieldSource> volume_source(
    const VolumeFolder& folder,
    std::shared_ptr<FileAccess> access = std::make_shared<FileAccess>());

}  // namespace zeroset
