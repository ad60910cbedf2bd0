#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace zeroset {

/// A file's bytes, mapped while this lives. Where another program makes the file shorter meanwhile,
/// reading beyond its new end raises SIGBUS.
class MappedFile {
public:
    static std::expected<std::shared_ptr<const MappedFile>, std::string> open(
        const std::filesystem::path& path);

    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

private:
    explicit MappedFile(std::span<const std::byte> bytes);

    std::span<const std::byte> bytes_;
    std::size_t slot_;  ///< in the table of mapped files
};

/// Whether a mapped file has the address. For a handler of SIGBUS.
bool is_mapped(const void* address) noexcept;

/// Puts zeros from the page of `address` up to the end of the mapped file that has it, whose file
/// has become shorter; false if no mapped file has it. For a handler of SIGBUS.
bool fill_lost_pages(const void* address) noexcept;

}  // namespace zeroset
