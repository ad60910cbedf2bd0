#pragma once

#include "document/document.hpp"
#include "engine/export/file.hpp"

#include <expected>
#include <filesystem>
#include <string>

namespace zeroset {

/// How the names of documents end.
inline constexpr const char* document_ending = ".zeroset.json";
bool is_document_name(const std::string& name);

/// A document's file, read. `note`: what in it was not understood, one sentence; or empty.
struct LoadedDocument {
    Document document;
    std::string note;
};

/// The document in a file, or one sentence that says why there is none; the file is only read.
std::expected<LoadedDocument, std::string> load_document(const std::filesystem::path& path);

/// Written whole or not at all.
std::expected<void, FileError> save_document(const std::filesystem::path& path,
                                             const Document& document);

}  // namespace zeroset
