#pragma once

#include "document/import/imported.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

// The door of the room: which files are read, and how.

namespace zeroset {

/// A kind of file.
struct ImportFormat {
    std::string_view name;     ///< of the program or the format, for people
    std::string_view endings;  ///< of its files' names, each with its point, apart by blanks
    ReadImport (*read)(std::string_view bytes, const ImportFiles& files);
    bool is_text = true;                   ///< and may have the encodings of plain_text
    std::size_t largest = largest_script;  ///< of its files, in bytes
};

/// The format of a file of this name; nullptr where it is none of them.
const ImportFormat* import_format(std::string_view file_name);
bool is_import_name(std::string_view file_name);
/// All endings, apart by blanks.
std::string import_endings();

/// Reads a file's bytes. The rows of all documents have been checked, see check_rows; documents
/// without a name have the file's. `files`: what they may name (Document::files).
ReadImport read_import(std::string_view file_name, std::string_view bytes,
                       const std::shared_ptr<const FieldSource>& files = nullptr);

/// Reads a file; the error is a predicate with its name: "cannot open 'a.pov': ...".
ReadImport load_import(const std::filesystem::path& path,
                       const std::shared_ptr<const FieldSource>& files = nullptr);

}  // namespace zeroset
