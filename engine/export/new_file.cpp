#include "engine/export/new_file.hpp"

#include "engine/base/translation.hpp"

#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

std::unexpected<FileError> cannot_write(const fs::path& path, const std::string& reason) {
    return std::unexpected(
        FileError{filled(tr("cannot write {0}: {1}"), {"'" + path.string() + "'", reason})});
}

/// True for what a rename would replace by a file.
bool is_device(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

/// A temporary name in the folder of `path` that no other process uses.
fs::path beside(const fs::path& path) {
    fs::path temporary = path;
    temporary += "." + std::to_string(::getpid()) + ".part";
    return temporary;
}

/// Files that are written but not renamed yet. Holding the mutex keeps all threads from beginning
/// and from renaming one.
struct Unfinished {
    std::mutex mutex;
    std::vector<fs::path> files;
};

Unfinished& unfinished() {
    static Unfinished instance;
    return instance;
}

std::string reason_of(int error) { return std::generic_category().message(error); }

}  // namespace

NewFile::NewFile(const fs::path& path)
    : path_(path), grows_at_(is_device(path) ? path : beside(path)) {
    const std::scoped_lock lock(unfinished().mutex);
    if (grows_at_ != path_) unfinished().files.push_back(grows_at_);
    errno = 0;
    stream_.open(grows_at_, std::ios::binary);
    if (!stream_) error_ = errno;
}

NewFile::~NewFile() {
    if (grows_at_ == path_) return;
    const std::scoped_lock lock(unfinished().mutex);
    std::erase(unfinished().files, grows_at_);
    std::error_code ignored;
    if (!kept_) fs::remove(grows_at_, ignored);
}

bool NewFile::append(std::span<const std::byte> bytes) {
    if (!stream_) return false;
    errno = 0;
    stream_.write(reinterpret_cast<const char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size()));
    if (!stream_) error_ = errno;
    return static_cast<bool>(stream_);
}

std::unexpected<FileError> NewFile::error() const {
    return cannot_write(path_, error_ == 0 ? tr("the system gives no reason") : reason_of(error_));
}

std::expected<void, FileError> NewFile::keep() {
    errno = 0;
    stream_.close();
    if (!stream_ && error_ == 0) error_ = errno;
    if (!stream_) return error();
    if (grows_at_ == path_) return {};
    const std::scoped_lock lock(unfinished().mutex);
    std::error_code error;
    fs::rename(grows_at_, path_, error);
    if (error) return cannot_write(path_, error.message());
    kept_ = true;
    return {};
}

std::expected<void, FileError> check_writable(const fs::path& path) {
    if (path.empty()) return cannot_write(path, tr("the name is empty"));
    std::error_code error;
    const fs::file_status found = fs::status(path, error);
    if (found.type() == fs::file_type::none) return cannot_write(path, error.message());
    if (fs::is_directory(found))
        return cannot_write(path, tr("it is a directory; name a file in it"));
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error)) {
        return cannot_write(
            path, filled(tr("the folder {0} does not exist"), {"'" + folder.string() + "'"}));
    }
    if (::access(folder.c_str(), W_OK) != 0) return cannot_write(path, reason_of(errno));
    return {};
}

void abandon_files() {
    unfinished().mutex.lock();  // never unlocked
    for (const fs::path& file : unfinished().files) {
        std::error_code ignored;
        fs::remove(file, ignored);
    }
}

}  // namespace zeroset
