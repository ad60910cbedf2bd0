#pragma once

#include "engine/image/framebuffer.hpp"

#include <expected>
#include <filesystem>
#include <span>
#include <string>

namespace zeroset {

struct FileError {
    std::string message;  ///< a predicate with the file and the reason: "cannot write 'a.png': ..."
};

/// Writes all bytes to a new file beside `path`, then renames it: `path` is complete or untouched.
std::expected<void, FileError> write_file(const std::filesystem::path& path,
                                          std::span<const std::byte> bytes);

/// Removes the files that write_file has begun, and blocks all further writing; for the end of a
/// process in which other threads may still write. Any thread.
void abandon_files();

/// Checks whether write_file to `path` can work, before the work that makes the bytes.
std::expected<void, FileError> check_writable(const std::filesystem::path& path);

/// Writes the colours as an 8-bit RGB PNG.
std::expected<void, FileError> write_png(const std::filesystem::path& path,
                                         const Framebuffer& frame);

/// Writes the text to a file, or to standard output for "-".
std::expected<void, FileError> write_text(const std::string& path, const std::string& text);

}  // namespace zeroset
