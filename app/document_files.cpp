#include "app/document_files.hpp"

#include "app/commands.hpp"

#include "document/document_json.hpp"
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// Larger files are no documents.
constexpr std::uintmax_t largest_file = 64U << 20U;

std::unexpected<std::string> cannot_read(const fs::path& path, const std::string& reason) {
    return std::unexpected("cannot open '" + path.string() + "': " + reason);
}

std::string note_of(const std::vector<std::string>& unknown) {
    if (unknown.empty()) return {};
    std::string note = "not understood, and lost when it is saved:";
    for (const std::string& name : unknown)
        note += " " + name;
    return note;
}

fs::path lock_of(const fs::path& file) {
    fs::path lock = file;
    lock.replace_extension().replace_extension(".lock");
    return lock;
}

/// An open file that this process alone has locked, or -1.
int locked(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
    ::close(file);
    return -1;
}

/// Whether no process has the lock; a missing one is free.
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

bool is_document_name(const std::string& name) { return name.ends_with(document_ending); }

std::expected<LoadedDocument, std::string> load_document(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) return cannot_read(path, "there is no such file");
    if (!fs::is_regular_file(path, error)) return cannot_read(path, "it is no file");
    if (fs::file_size(path, error) > largest_file) return cannot_read(path, "it is too large");
    std::ifstream file(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file) return cannot_read(path, std::generic_category().message(errno));
    auto read = document_from(text);
    if (!read) return cannot_read(path, read.error());
    return LoadedDocument{std::move(read->document), note_of(read->unknown)};
}

std::expected<void, FileError> save_document(const fs::path& path, const Document& document) {
    return write_text(path.string(), text_of(document));
}

RecentFiles::RecentFiles(std::optional<fs::path> folder) {
    if (!folder) return;
    file_ = *folder / "recent";
    std::ifstream file(*file_);
    for (std::string line; paths_.size() < most && std::getline(file, line);) {
        if (!line.empty()) paths_.push_back(line);
    }
}

void RecentFiles::add(const fs::path& path) {
    std::error_code error;
    const std::string name = fs::absolute(path, error).lexically_normal().string();
    if (error || name.contains('\n')) return;
    std::erase(paths_, name);
    paths_.insert(paths_.begin(), name);
    if (paths_.size() > most) paths_.resize(most);
    if (!file_) return;
    fs::create_directories(file_->parent_path(), error);
    std::string text;
    for (const std::string& line : paths_)
        text += line + "\n";
    // Without the list the program works as well.
    (void)write_text(file_->string(), text);
}

Autosave::Autosave(const std::optional<fs::path>& folder) {
    if (!folder) return;
    folder_ = *folder / "autosave";
    std::error_code error;
    fs::create_directories(folder_, error);
    fs::permissions(folder_, fs::perms::owner_all, error);
    // The process's number may be that of a lost session.
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
    // What cannot be kept is no reason to disturb the work.
    if (lock_ >= 0) (void)save_document(file_, document);
}

void Autosave::forget() {
    std::error_code ignored;
    if (lock_ >= 0) fs::remove(file_, ignored);
}

std::optional<LostSession> Autosave::lost() const {
    std::optional<LostSession> newest;
    for (const fs::path& file : documents_in(folder_)) {
        if (file == file_ || !is_free(lock_of(file))) continue;
        std::error_code error;
        const auto saved = fs::last_write_time(file, error);
        if (error || (newest && newest->saved >= saved)) continue;
        if (auto loaded = load_document(file)) {
            newest = LostSession{file, std::move(loaded->document), saved};
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
