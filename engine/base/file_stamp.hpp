#pragma once

#include <cstdint>
#include <filesystem>

namespace zeroset {

/// A file, or a folder's files together, as it was at some time: two stamps that differ tell that
/// it has changed.
struct FileStamp {
    std::filesystem::path file;
    std::filesystem::file_time_type time;
    std::uint64_t size = 0;  ///< in bytes

    /// The file's stamp at this moment; a file that is not there has a stamp, too.
    static FileStamp now(const std::filesystem::path& file);
    [[nodiscard]] bool is_still_so() const { return now(file) == *this; }

    bool operator==(const FileStamp&) const = default;
};

}  // namespace zeroset
