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

/// Whether a file is in a folder or below it, both as real paths: without links, "." and "..".
bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace zeroset
