#include "document/json/collection.hpp"

#include "document/import/cannot_open.hpp"
#include "document/import/import.hpp"
#include "document/import/import_choice.hpp"
#include "document/json/document_file.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// A file's name without what it ends in: "heart" of "heart.zeroset.json".
std::string title_of(const fs::path& file) {
    const std::string name = file.filename().string();
    if (is_document_name(name))
        return name.substr(0, name.size() - std::string_view(document_ending).size());
    return file.stem().string();
}

bool is_full(const Collection& collection) { return collection.items.size() >= largest_collection; }

/// Adds the documents of another program's file.
void add_imported(const fs::path& file, Imported imported, Collection& collection) {
    const bool alone = imported.documents.size() == 1;
    for (std::size_t i = 0; i < imported.documents.size(); ++i) {
        ImportedDocument& document = imported.documents[i];
        if (!document.refusal.empty() || is_full(collection)) {
            ++collection.unread;
            continue;
        }
        collection.items.push_back(
            {.title = document.name.empty() ? title_of(file) : std::move(document.name),
             .path = alone ? file.string() : file.string() + "#" + std::to_string(i + 1),
             .document = std::move(document.document),
             .about = {}});
    }
}

/// Adds what a file of a folder holds; files that hold no documents are not counted.
void add_file(const fs::path& file, Collection& collection) {
    const std::string name = file.string();
    if (is_import_path(name)) {
        if (auto imported = load_import(file))
            return add_imported(file, std::move(*imported), collection);
        ++collection.unread;
        return;
    }
    auto loaded = load_document(file);
    if (loaded) {
        collection.items.push_back({.title = title_of(file),
                                    .path = name,
                                    .document = std::move(loaded->document),
                                    .about = std::move(loaded->note)});
    } else if (is_document_name(name)) {
        ++collection.unread;
    }
}

/// The files of a folder that may hold documents, by their names; a picture beside a document of
/// its name is that document's.
std::vector<fs::path> files_of(const fs::path& folder, std::error_code& error) {
    std::vector<fs::path> files;
    std::set<std::string> documents;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code ignored;
        const std::string name = at->path().filename().string();
        if (name.starts_with('.') || !at->is_regular_file(ignored)) continue;
        if (is_document_name(name)) documents.insert(title_of(at->path()));
        if (is_document_name(name) || is_picture_name(name) || is_import_name(name))
            files.push_back(at->path());
    }
    std::erase_if(files, [&documents](const fs::path& file) {
        return is_picture_name(file.string()) && documents.contains(title_of(file));
    });
    std::ranges::sort(files);
    return files;
}

std::expected<Collection, std::string> folder_collection(const fs::path& folder) {
    std::error_code error;
    const std::vector<fs::path> files = files_of(folder, error);
    if (error) return cannot_open(folder, error.message());
    const fs::path named = folder.has_filename() ? folder : folder.parent_path();
    Collection collection{.name = named.filename().string(), .items = {}};
    for (const fs::path& file : files) {
        if (is_full(collection)) break;
        add_file(file, collection);
    }
    if (!collection.items.empty()) return collection;
    return cannot_open(folder, tr("there is no document in this folder"));
}

}  // namespace

std::expected<std::optional<Collection>, std::string> collection_at(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) return folder_collection(path);
    const std::string name = path.string();
    if (!is_import_path(name) || !import_place(name).choice.empty()) return std::nullopt;
    auto imported = load_import(path);
    if (!imported) return std::unexpected(imported.error());
    if (imported->documents.size() == 1) return std::nullopt;
    Collection collection{.name = path.filename().string(), .items = {}};
    add_imported(path, std::move(*imported), collection);
    if (!collection.items.empty()) return collection;
    return cannot_open(path, tr("it has no surface that can be drawn"));
}

}  // namespace zeroset
