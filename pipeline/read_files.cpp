#include "pipeline/read_files.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace zeroset {
namespace {

/// Something that was read from files.
struct ReadThing {
    std::weak_ptr<const void> what;
    std::vector<FileStamp> told;    ///< as they were when read, or at the last change that was told
    std::vector<FileStamp> latest;  ///< as they were when they were looked at last

    /// Looks at the files.
    bool has_changed() {
        std::vector<FileStamp> now;
        now.reserve(told.size());
        for (const FileStamp& stamp : told)
            now.push_back(FileStamp::now(stamp.file));
        const std::vector<FileStamp> before = std::exchange(latest, std::move(now));
        if (latest == told || latest != before) return false;
        told = latest;
        return true;
    }
};

struct ReadFiles {
    std::mutex mutex;
    std::vector<ReadThing> things;
};

ReadFiles& read_files() {
    static ReadFiles instance;
    return instance;
}

}  // namespace

void note_read_files(const std::shared_ptr<const void>& what, std::vector<FileStamp> files) {
    ReadFiles& known = read_files();
    const std::scoped_lock lock(known.mutex);
    const auto is_known = [&](const ReadThing& thing) {
        return thing.what.lock() == what &&
               std::ranges::equal(thing.told, files, {}, &FileStamp::file, &FileStamp::file);
    };
    if (std::ranges::any_of(known.things, is_known)) return;
    known.things.push_back({.what = what, .told = files, .latest = std::move(files)});
}

bool read_files_have_changed() {
    ReadFiles& known = read_files();
    const std::scoped_lock lock(known.mutex);
    std::erase_if(known.things, [](const ReadThing& thing) { return thing.what.expired(); });
    bool has_changed = false;
    for (ReadThing& thing : known.things)
        has_changed |= thing.has_changed();
    return has_changed;
}

}  // namespace zeroset
