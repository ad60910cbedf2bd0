#include "engine/base/file_stamp.hpp"

#include <algorithm>
#include <system_error>

namespace zeroset {

FileStamp FileStamp::now(const std::filesystem::path& file) {
    std::error_code error;
    FileStamp stamp{.file = file, .time = std::filesystem::last_write_time(file, error)};
    if (!std::filesystem::is_directory(file, error)) {
        const std::uint64_t size = std::filesystem::file_size(file, error);
        if (!error) stamp.size = size;
        return stamp;
    }
    // Not a range-for, whose step throws.
    std::error_code failed;
    for (std::filesystem::directory_iterator at(file, failed);
         !failed && at != std::filesystem::directory_iterator(); at.increment(failed)) {
        const std::filesystem::directory_entry& entry = *at;
        if (!entry.is_regular_file(error)) continue;
        const std::uint64_t size = entry.file_size(error);
        if (error) continue;
        stamp.size += size;
        stamp.time = std::max(stamp.time, entry.last_write_time(error));
    }
    return stamp;
}

bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder) {
    const auto end = std::ranges::mismatch(folder, file).in1;
    return end == folder.end() || end->empty();  // empty behind the '/' at a folder's end
}

}  // namespace zeroset
