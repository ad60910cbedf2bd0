#include "engine/export/new_file.hpp"

#include "engine/base/translation.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
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

/// The file that a path means, behind links, though it may not be there yet.
fs::path behind_links(const fs::path& path) {
    constexpr int most_links = 40;
    fs::path target = path;
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(target, error); ++i) {
        const fs::path next = fs::read_symlink(target, error);
        if (error) break;
        target = target.parent_path() / next;
    }
    return target;
}

/// A temporary name in the folder of `path` that no other process uses.
fs::path beside(const fs::path& path) {
    fs::path temporary = path;
    temporary += "." + std::to_string(::getpid()) + ".part";
    return temporary;
}

/// A new file that only the user may read, for what goes to the device `path`.
fs::path apart_from(const fs::path& path) {
    std::error_code ignored;
    std::string name =
        fs::temp_directory_path(ignored) / ("zeroset_" + path.filename().string() + ".XXXXXX");
    if (const int file = ::mkstemp(name.data()); file >= 0) ::close(file);
    return name;
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

NewFile::NewFile(const fs::path& path, Order order)
    : path_(path), is_device_(is_device(path)), target_(is_device_ ? path : behind_links(path)) {
    grows_at_ = is_device_ ? target_ : beside(target_);
    // A device is opened without the mutex, as that of a pipe waits for its reader.
    std::unique_lock lock(unfinished().mutex);
    if (is_device_ && order == Order::Any) grows_at_ = apart_from(target_);
    if (grows_at_ == target_) {
        lock.unlock();
    } else {
        unfinished().files.push_back(grows_at_);
    }
    errno = 0;
    stream_.open(grows_at_, std::ios::binary);
    if (!stream_) error_ = errno;
    // While it is empty: nobody reads it who may not read the file that it replaces.
    std::error_code ignored;
    const fs::file_status before = fs::status(target_, ignored);
    if (!is_device_ && fs::exists(before))
        fs::permissions(grows_at_, before.permissions(), ignored);
}

NewFile::~NewFile() {
    if (grows_at_ == target_) return;
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
    if (grows_at_ == target_) return {};
    if (is_device_) return copy_to_device();
    const std::scoped_lock lock(unfinished().mutex);
    std::error_code error;
    fs::rename(grows_at_, target_, error);
    if (error) return cannot_write(path_, error.message());
    kept_ = true;
    return {};
}

std::expected<void, FileError> NewFile::copy_to_device() {
    errno = 0;
    std::ofstream device(target_, std::ios::binary);
    const std::ifstream grown(grows_at_, std::ios::binary);
    device << grown.rdbuf();
    device.close();
    if (device) return {};
    error_ = errno;
    return error();
}

std::expected<void, FileError> check_writable(const fs::path& path) {
    constexpr fs::perms writers =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if (path.empty()) return cannot_write(path, tr("the name is empty"));
    std::error_code error;
    const fs::file_status found = fs::status(path, error);
    if (found.type() == fs::file_type::none) return cannot_write(path, error.message());
    if (fs::is_directory(found))
        return cannot_write(path, tr("it is a directory; name a file in it"));
    // The system lets root write to what nobody may write to.
    const bool is_protected =
        fs::is_regular_file(found) && (found.permissions() & writers) == fs::perms::none;
    if (is_protected) return cannot_write(path, reason_of(EACCES));
    if (fs::exists(found) && ::access(path.c_str(), W_OK) != 0)
        return cannot_write(path, reason_of(errno));
    if (fs::exists(found) && !fs::is_regular_file(found)) return {};
    const fs::path target = behind_links(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
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
