#pragma once

#include "engine/export/file.hpp"

#include <cstddef>
#include <expected>
#include <filesystem>
#include <fstream>
#include <span>

namespace zeroset {

/// A file that grows beside its place until keep() renames it: its path is complete or untouched. A
/// device such as /dev/stdout, which a rename would replace, is written into. One thread.
class NewFile {
public:
    /// Begins a file, which is destroyed unless it is kept. Not if check_writable refuses.
    explicit NewFile(const std::filesystem::path& path);
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// For libraries that write by themselves; what goes wrong is told by keep().
    std::ofstream& stream() { return stream_; }
    /// Where it grows until keep(): for libraries that open files by their names.
    [[nodiscard]] const std::filesystem::path& place() const { return grows_at_; }
    /// Appends bytes; false where that fails, which keep() tells again.
    bool append(std::span<const std::byte> bytes);
    /// Ends the file and gives it its name; or says why that, or any write before it, failed.
    std::expected<void, FileError> keep();
    /// The error of a write that has failed.
    [[nodiscard]] std::unexpected<FileError> error() const;

private:
    std::filesystem::path path_;
    std::filesystem::path grows_at_;  ///< equal to `path_` for a device
    std::ofstream stream_;
    int error_ = 0;  ///< errno of the first write that failed
    bool kept_ = false;
};

}  // namespace zeroset
