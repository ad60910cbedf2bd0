#pragma once

#include "engine/export/file.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <fstream>
#include <span>

namespace zeroset {

/// A file that grows beside its place until keep() renames it: its path is complete or untouched. A
/// link is followed, and a file that is replaced leaves its permissions. A device or a pipe, which
/// a rename would replace, is written into. One thread.
class NewFile {
public:
    /// Whether bytes are only appended, or places before the end are written again, too: then what
    /// goes to a device grows in a folder for temporary files first.
    enum class Order : std::uint8_t { Appended, Any };

    /// Begins a file, which is destroyed unless it is kept. Not if check_writable refuses. Waits
    /// for who reads from a pipe.
    explicit NewFile(const std::filesystem::path& path, Order order = Order::Appended);
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
    /// Copies what has grown to the device.
    std::expected<void, FileError> copy_to_device();

    std::filesystem::path path_;  ///< that was asked for
    bool is_device_;
    std::filesystem::path target_;    ///< behind links
    std::filesystem::path grows_at_;  ///< may be the device
    std::ofstream stream_;
    int error_ = 0;  ///< errno of the first write that failed
    bool kept_ = false;
};

}  // namespace zeroset
