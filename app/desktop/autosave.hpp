#pragma once

#include "document/document.hpp"

#include <filesystem>
#include <optional>

namespace zeroset {

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
