#pragma once

#include "document/document.hpp"
#include "engine/export/file.hpp"

#include <glm/ext/vector_int2.hpp>

#include <expected>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace zeroset {

/// The end of the file names of documents.
inline constexpr const char* document_ending = ".zeroset.json";
bool is_document_name(const std::string& name);
/// Whether a file may be a picture that holds a session.
bool is_picture_name(const std::string& name);

/// A document from a file. `note` is one sentence on what the program did not understand, or empty.
struct LoadedDocument {
    Document document;
    std::string note;
    std::optional<Background> shown_on;  ///< the background it was seen on, if it has none
    /// The file is a picture or another program's, and saving must not replace it.
    bool is_source = false;
};

/// The document in a file, in a PNG of ours or in another program's file, or why there is none, as
/// a predicate: "cannot open 'a.json': ...". The file is only read. `files`: what the document may
/// name (Document::files).
std::expected<LoadedDocument, std::string> load_document(
    const std::filesystem::path& path, const std::shared_ptr<const FieldSource>& files = nullptr);

/// Whether a file is a PNG of this size that holds just this document.
bool holds_picture_of(const std::filesystem::path& path, const Document& document,
                      glm::ivec2 size_px);

/// Writes the file as a whole or not at all. `shown_on`: see text_of.
std::expected<void, FileError> save_document(
    const std::filesystem::path& path, const Document& document,
    const std::optional<Background>& shown_on = std::nullopt);

}  // namespace zeroset
