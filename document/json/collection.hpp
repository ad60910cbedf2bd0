#pragma once

#include "document/document.hpp"

#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// Documents to choose from by their pictures: those of a folder, or of a file that holds several.

namespace zeroset {

struct CollectionItem {
    std::string title;
    std::string path;  ///< by which load_document finds it: FILE or FILE#N
    Document document;
    std::string about;  ///< what was not understood of a document of ours; may be empty
};

struct Collection {
    std::string name;
    std::vector<CollectionItem> items;  ///< at least one
    std::size_t unread = 0;             ///< files and documents that could not be read or drawn
};

/// A folder's or file's further documents are left out of a collection.
inline constexpr std::size_t largest_collection = 5000;

/// The documents of a folder, without those in folders inside it, by their names, or of another
/// program's file that holds several, in its order; surfaces that cannot be drawn are left out.
/// Nothing where the path is something else, or chooses one of a file's documents. The error is a
/// predicate: "cannot open 'a': ...". The files are only read.
std::expected<std::optional<Collection>, std::string> collection_at(
    const std::filesystem::path& path);

}  // namespace zeroset
