#pragma once

#include "document/import/imported.hpp"

#include <expected>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

// One document of a file that may hold several: FILE, FILE#NAME or FILE#N.

namespace zeroset {

/// A file, and which of its documents.
struct ImportPlace {
    std::filesystem::path file;
    std::string choice;  ///< a name, or a number from 1; empty: the first
};

/// The place that a path names: the file is all of it, or the part before a # where there is no
/// such file.
ImportPlace import_place(const std::string& path);

/// Whether the path is one of a file that is read as an import.
bool is_import_path(const std::string& path);

/// The document of the place, and in `notes` what was not taken over, that it is one of many
/// included. The error is a predicate with the file's name.
/// `files`: what it may name (Document::files).
std::expected<ImportedDocument, std::string> load_imported(
    const ImportPlace& place, const std::shared_ptr<const FieldSource>& files = nullptr);

/// A note as "FILE:LINE: entry: reason".
std::string note_text(std::string_view file, const ImportNote& note);
/// The notes, a line each, and after the first dozen how many more there are; empty where there is
/// none.
std::string notes_listed(const std::vector<ImportNote>& notes);

}  // namespace zeroset
