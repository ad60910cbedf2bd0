#include "engine/export/file.hpp"

#include "engine/base/translation.hpp"
#include "engine/export/new_file.hpp"
#include "engine/export/png.hpp"

#include <iostream>
#include <span>
#include <string>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::expected<void, FileError> write_file(const fs::path& path, std::span<const std::byte> bytes) {
    if (auto writable = check_writable(path); !writable) return writable;
    NewFile file(path);
    if (!file.append(bytes)) return file.error();
    return file.keep();
}

std::expected<void, FileError> write_png(const fs::path& path, const Framebuffer& frame) {
    return write_file(path, png_of(frame));
}

std::expected<void, FileError> write_text(const std::string& path, const std::string& text) {
    if (path != "-") return write_file(path, std::as_bytes(std::span(text)));
    std::cout << text << std::flush;
    if (!std::cout) return std::unexpected(FileError{tr("cannot write to standard output")});
    return {};
}

}  // namespace zeroset
