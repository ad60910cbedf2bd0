#include "app/desktop/autosave.hpp"

#include "document/json/document_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

fs::path lock_of(const fs::path& file) {
    fs::path lock = file;
    lock.replace_extension().replace_extension(".lock");
    return lock;
}

/// Opens a file and locks it for this process alone; -1 if that fails.
int locked(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
    ::close(file);
    return -1;
}

/// True if no process holds the lock; a missing lock file counts as free.
bool is_free(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) return true;
    const bool free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    ::close(file);
    return free;
}

std::vector<fs::path> documents_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (is_document_name(at->path().filename().string())) files.push_back(at->path());
    }
    return files;
}

}  // namespace

Autosave::Autosave(const std::optional<fs::path>& folder) {
    if (!folder) return;
    folder_ = *folder / "autosave";
    std::error_code error;
    fs::create_directories(folder_, error);
    fs::permissions(folder_, fs::perms::owner_all, error);
    // A lost session may have had the same process number.
    for (int i = 0; i < 100 && lock_ < 0; ++i) {
        file_ = folder_ / (std::to_string(::getpid()) + "-" + std::to_string(i) + document_ending);
        if (!fs::exists(file_, error)) lock_ = locked(lock_of(file_));
    }
}

Autosave::~Autosave() {
    if (lock_ < 0) return;
    forget();
    std::error_code ignored;
    fs::remove(lock_of(file_), ignored);
    ::close(lock_);
}

void Autosave::keep(const Document& document) {
    // A failed write must not disturb the user's work.
    if (lock_ >= 0) (void)save_document(file_, document);
}

void Autosave::forget() {
    std::error_code ignored;
    if (lock_ >= 0) fs::remove(file_, ignored);
}

void Autosave::abandon() {
    if (lock_ >= 0) ::close(lock_);
    lock_ = -1;
}

std::optional<LostSession> Autosave::lost() const {
    std::optional<LostSession> newest;
    for (const fs::path& file : documents_in(folder_)) {
        if (file == file_ || !is_free(lock_of(file))) continue;
        std::error_code error;
        const auto saved = fs::last_write_time(file, error);
        if (error || (newest && newest->saved >= saved)) continue;
        if (auto loaded = load_document(file)) {
            newest =
                LostSession{.file = file, .document = std::move(loaded->document), .saved = saved};
        }
    }
    return newest;
}

void Autosave::discard(const LostSession& session) {
    std::error_code ignored;
    fs::remove(session.file, ignored);
    fs::remove(lock_of(session.file), ignored);
}

}  // namespace zeroset
