#pragma once

#include "engine/image/framebuffer.hpp"

#include <expected>
#include <filesystem>
#include <span>
#include <string>

namespace zeroset {

struct FileError {
    std::string message;  ///< names the file and the reason
};

/// Writes all bytes to a new file beside `path`, then renames it: `path` is whole or untouched.
std::expected<void, FileError> write_file(const std::filesystem::path& path,
                                          std::span<const std::byte> bytes);

/// Takes away what write_file has begun, and lets it write no more: before the process ends while
/// other threads may still write. Any thread.
void abandon_files();

/// Whether write_file to this path can work; tried before the work that makes the bytes.
std::expected<void, FileError> check_writable(const std::filesystem::path& path);

/// 8-bit RGB PNG of the colours.
std::expected<void, FileError> write_png(const std::filesystem::path& path,
                                         const Framebuffer& frame);

/// Grayscale PFM of the depths: little endian, rows from the bottom, +inf for a miss.
std::expected<void, FileError> write_pfm(const std::filesystem::path& path,
                                         const Framebuffer& frame);

/// To a file, or to standard output for "-".
std::expected<void, FileError> write_text(const std::string& path, const std::string& text);

}  // namespace zeroset
