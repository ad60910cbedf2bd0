#pragma once

#include "engine/export/file.hpp"

#include "document/document.hpp"

#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// The documents used last, the newest first; kept in a file of the state folder.
class RecentFiles {
public:
    static constexpr std::size_t most = 10;

    explicit RecentFiles(std::optional<std::filesystem::path> folder);
    [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }
    void add(const std::filesystem::path& path);

private:
    std::optional<std::filesystem::path> file_;
    std::vector<std::string> paths_;
};

/// A session that ended without being closed.
struct LostSession {
    std::filesystem::path file;
    Document document;
    std::filesystem::file_time_type saved;
};

/// Where a session keeps its document against a crash: a file of its own in the state folder, and
/// a lock that ends with the process however that ends.
class Autosave {
public:
    /// Nothing is kept without a folder or where it cannot be written.
    explicit Autosave(const std::optional<std::filesystem::path>& folder);
    /// Closed as it should be: the file is removed.
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    void keep(const Document& document);
    /// There is nothing to restore.
    void forget();
    /// What was kept is left as by a crash; nothing more is kept.
    void abandon();
    /// The newest of the sessions that were lost.
    [[nodiscard]] std::optional<LostSession> lost() const;
    /// Removes what a lost session left.
    void discard(const LostSession& session);

private:
    std::filesystem::path folder_;
    std::filesystem::path file_;
    int lock_ = -1;
};

}  // namespace zeroset
