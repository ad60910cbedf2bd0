#pragma once

#include "document/document.hpp"

#include <filesystem>
#include <optional>

namespace zeroset {

/// The document of a session that ended without being closed.
struct LostSession {
    std::filesystem::path file;
    Document document;
    std::filesystem::file_time_type saved;
};

/// Keeps a session's document against a crash: in a file of its own in the state folder, with a
/// lock that the system releases however the process ends.
class Autosave {
public:
    /// Without a folder, or with one that cannot be written, nothing is kept.
    explicit Autosave(const std::optional<std::filesystem::path>& folder);
    /// Removes the file: the session was closed properly.
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    void keep(const Document& document);
    /// Removes the kept document: there is nothing to restore.
    void forget();
    /// Leaves the file as a crash would; keeps nothing from then on.
    void abandon();
    /// Returns the newest of the lost sessions, if any.
    [[nodiscard]] std::optional<LostSession> lost() const;
    /// Removes the files of a lost session.
    void discard(const LostSession& session);

private:
    std::filesystem::path folder_;
    std::filesystem::path file_;
    int lock_ = -1;
};

}  // namespace zeroset
