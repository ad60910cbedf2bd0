#pragma once

#include "document/document.hpp"
#include "engine/export/file.hpp"

#include <expected>
#include <filesystem>
#include <string>

namespace zeroset {

/// The end of the file names of documents.
inline constexpr const char* document_ending = ".zeroset.json";
bool is_document_name(const std::string& name);

/// A document from a file. `note` is one sentence on what the program did not understand, or empty.
struct LoadedDocument {
    Document document;
    std::string note;
};

/// The document in a file, or why there is none, as a predicate: "cannot open 'a.json': ...". The
/// file is only read.
std::expected<LoadedDocument, std::string> load_document(const std::filesystem::path& path);

/// Writes the file as a whole or not at all.
std::expected<void, FileError> save_document(const std::filesystem::path& path,
                                             const Document& document);

}  // namespace zeroset
