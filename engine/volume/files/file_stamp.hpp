#pragma once

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace zeroset {

/// A file as it was at some time; two stamps that differ tell that it has changed.
struct FileStamp {
    std::filesystem::path file;
    std::filesystem::file_time_type time;
    std::uint64_t size = 0;  ///< in bytes; of a folder 0

    /// The file as it is now; a file that is not there has a stamp of its own.
    static FileStamp now(const std::filesystem::path& file) {
        std::error_code error;
        FileStamp stamp{.file = file, .time = std::filesystem::last_write_time(file, error)};
        if (std::filesystem::is_regular_file(file, error))
            stamp.size = std::filesystem::file_size(file, error);
        return stamp;
    }
    [[nodiscard]] bool is_still_so() const { return now(file) == *this; }

    bool operator==(const FileStamp&) const = default;
};

}  // namespace zeroset
