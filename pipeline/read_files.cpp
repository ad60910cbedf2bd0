#include "pipeline/read_files.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace zeroset {
namespace {

struct ReadFile {
    std::weak_ptr<const void> what;
    FileStamp told;    ///< as it was when it was read, or at the last change that was told
    FileStamp latest;  ///< as it was when it was looked at last

    /// Looks at the file.
    bool has_changed() {
        const FileStamp before = std::exchange(latest, FileStamp::now(told.file));
        if (latest == told || latest != before) return false;
        told = latest;
        return true;
    }
};

struct ReadFiles {
    std::mutex mutex;
    std::vector<ReadFile> files;
};

ReadFiles& read_files() {
    static ReadFiles instance;
    return instance;
}

}  // namespace

void note_read_files(const std::shared_ptr<const void>& what, std::vector<FileStamp> files) {
    ReadFiles& known = read_files();
    const std::scoped_lock lock(known.mutex);
    const auto is_known = [&](const ReadFile& file) { return file.what.lock() == what; };
    if (std::ranges::any_of(known.files, is_known)) return;
    for (FileStamp& stamp : files)
        known.files.push_back({.what = what, .told = stamp, .latest = std::move(stamp)});
}

bool read_files_have_changed() {
    ReadFiles& known = read_files();
    const std::scoped_lock lock(known.mutex);
    std::erase_if(known.files, [](const ReadFile& file) { return file.what.expired(); });
    bool has_changed = false;
    for (ReadFile& file : known.files)
        has_changed |= file.has_changed();
    return has_changed;
}

}  // namespace zeroset
