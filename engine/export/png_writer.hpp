#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace zeroset {

/// Takes the next bytes of a file; false where they cannot be written.
using ByteSink = std::function<bool(std::span<const std::byte>)>;

/// A text within a PNG, which pictures do not show.
struct PngText {
    std::string keyword;  ///< 1 to 79 letters of ASCII
    std::string text;     ///< UTF-8
};

/// The kind of a PNG file.
struct PngFormat {
    int width = 0;
    int height = 0;
    int channels = 3;            ///< 3 (RGB) or 4 (RGBA, not multiplied by alpha)
    int bits = 8;                ///< of a channel: 8 or 16
    double dots_per_inch = 0.0;  ///< 0: not told
    std::vector<PngText> texts;

    [[nodiscard]] std::size_t pixel_bytes() const {
        return static_cast<std::size_t>(channels) * static_cast<std::size_t>(bits) / 8;
    }
    [[nodiscard]] std::size_t row_bytes() const {
        return static_cast<std::size_t>(width) * pixel_bytes();
    }
};

/// Writes a PNG [ISO/IEC 15948] of any height band by band: rows are filtered and deflated on all
/// cores; equal bands make equal files. One thread calls.
class PngWriter {
public:
    PngWriter(PngFormat format, ByteSink sink);

    /// Appends rows from the top to the bottom, each of row_bytes(); numbers of 16 bits have their
    /// high byte first. False where the sink fails.
    bool add_rows(std::span<const std::uint8_t> rows);
    /// Ends the file, after its last row. False where the sink fails.
    bool finish();

private:
    bool write_chunk(const char* type, std::span<const std::uint8_t> data);
    bool write_header();

    PngFormat format_;
    ByteSink sink_;
    std::vector<std::uint8_t> last_row_;  ///< of the band before; zeros before the first
    unsigned long sum_ = 1;               ///< Adler-32 of all filtered rows
    bool begun_ = false;
    bool failed_ = false;
};

}  // namespace zeroset
