#pragma once

#include "engine/export/new_file.hpp"
#include "engine/image/framebuffer.hpp"

#include <expected>
#include <filesystem>

namespace zeroset {

/// Writes depths as a grayscale PFM band by band: little endian, rows from the bottom, +inf for a
/// miss. One thread calls.
class PfmWriter {
public:
    PfmWriter(const std::filesystem::path& path, int width, int height);

    /// Takes rows of the picture from its row `row` on.
    std::expected<void, FileError> add(const Framebuffer& band, int row);
    std::expected<void, FileError> finish() { return file_.keep(); }

private:
    NewFile file_;
    std::streamoff header_ = 0;  ///< bytes before the first number
    int height_;
};

}  // namespace zeroset
