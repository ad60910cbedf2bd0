#include "pipeline/file_access.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace zeroset {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& file) {
    std::error_code error;
    const fs::path path = fs::weakly_canonical(fs::absolute(file, error), error);
    return error ? file : path;
}

void FileAccess::allow(const fs::path& file) {
    const std::scoped_lock lock(allowed_mutex_);
    allowed_.insert(real_path(file));
    ++version_;
}

bool FileAccess::allows(const fs::path& file) {
    const fs::path real = real_path(file);
    const std::scoped_lock lock(allowed_mutex_);
    const bool may = allowed_.contains(real);
    if (!may) refused_.insert(real);
    return may;
}

std::vector<fs::path> FileAccess::take_refused() {
    const std::scoped_lock lock(allowed_mutex_);
    const std::set<fs::path> refused = std::exchange(refused_, {});
    return {refused.begin(), refused.end()};
}

bool FileAccess::ReadThing::has_changed() {
    std::vector<FileStamp> now;
    now.reserve(told.size());
    for (const FileStamp& stamp : told)
        now.push_back(FileStamp::now(stamp.file));
    const std::vector<FileStamp> before = std::exchange(latest, std::move(now));
    if (latest == told || latest != before) return false;
    told = latest;
    return true;
}

void FileAccess::note_read(const std::shared_ptr<const void>& what, std::vector<FileStamp> files) {
    const std::scoped_lock lock(things_mutex_);
    const auto is_known = [&](const ReadThing& thing) {
        return thing.what.lock() == what &&
               std::ranges::equal(thing.told, files, {}, &FileStamp::file, &FileStamp::file);
    };
    if (std::ranges::any_of(things_, is_known)) return;
    things_.push_back({.what = what, .told = files, .latest = std::move(files)});
}

bool FileAccess::look_for_changes() {
    const std::scoped_lock lock(things_mutex_);
    std::erase_if(things_, [](const ReadThing& thing) { return thing.what.expired(); });
    bool has_changed = false;
    for (ReadThing& thing : things_)
        has_changed |= thing.has_changed();
    if (has_changed) ++version_;
    return has_changed;
}

}  // namespace zeroset
