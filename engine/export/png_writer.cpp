#include "engine/export/png_writer.hpp"

#include "engine/base/parallel.hpp"
#include "engine/export/packed.hpp"

#include <isa-l/igzip_lib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

namespace zeroset {
namespace {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

/// Filtered bytes that are deflated at once, about: smaller pieces make larger files, larger ones
/// leave the processor's caches.
constexpr std::size_t piece_size = std::size_t{1} << 18U;
constexpr double inch_in_metres = 0.0254;

enum class RowFilter : std::uint8_t { Sub = 1, Up = 2 };

void append_number(Bytes& to, std::uint32_t number) {
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        to.push_back(static_cast<std::uint8_t>(number >> shift & 0xFFU));
}

void append_text(Bytes& to, const std::string& text) {
    to.insert(to.end(), text.begin(), text.end());
}

/// Sum of the absolute differences of bytes: small ones deflate best.
std::uint32_t distance(const std::uint8_t* a, const std::uint8_t* b, std::size_t count) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += static_cast<std::uint32_t>(std::abs(a[i] - b[i]));
    return sum;
}

/// Writes the differences of bytes; none of the ranges overlap.
void subtract(const std::uint8_t* __restrict a, const std::uint8_t* __restrict b, std::size_t count,
              std::uint8_t* __restrict out) {
    for (std::size_t i = 0; i < count; ++i)
        out[i] = static_cast<std::uint8_t>(a[i] - b[i]);
}

/// Writes a row as it is deflated: as differences from the pixel before or from the row above,
/// whichever are smaller, behind a byte for the filter.
void filter_row(const std::uint8_t* row, const std::uint8_t* above, const PngFormat& format,
                std::uint8_t* out) {
    const std::size_t bytes = format.row_bytes();
    const std::size_t pixel = format.pixel_bytes();
    const std::uint32_t from_above = distance(row, above, bytes);
    // Equal rows are frequent: there is nothing smaller to look for.
    if (from_above == 0 || from_above <= distance(row + pixel, row, bytes - pixel)) {
        *out = static_cast<std::uint8_t>(RowFilter::Up);
        return subtract(row, above, bytes, out + 1);
    }
    *out = static_cast<std::uint8_t>(RowFilter::Sub);
    std::copy_n(row, pixel, out + 1);
    subtract(row + pixel, row, bytes - pixel, out + 1 + pixel);
}

/// Deflates pieces of a stream, one after the other, with room that is kept between them. One for
/// each thread.
class Deflater {
public:
    Deflater() : room_(ISAL_DEF_LVL1_LARGE) {}

    /// The piece, which may stand before and behind others; empty where that fails.
    Bytes operator()(ByteSpan data) {
        // A byte of a block that does not get smaller, and what stands around the blocks.
        out_.resize(std::max(out_.size(), data.size() + data.size() / 8 + 1024));
        isal_deflate_stateless_init(&stream_);
        stream_.level = 1;
        stream_.level_buf = room_.data();
        stream_.level_buf_size = static_cast<std::uint32_t>(room_.size());
        // Filtered pictures of surfaces are runs of equal bytes between numbers that do not repeat:
        // other matches than with the bytes just before make files larger by a third.
        stream_.hist_bits = 1;
        stream_.flush = FULL_FLUSH;
        stream_.next_in = const_cast<std::uint8_t*>(data.data());  // it is only read
        stream_.avail_in = static_cast<std::uint32_t>(data.size());
        stream_.next_out = out_.data();
        stream_.avail_out = static_cast<std::uint32_t>(out_.size());
        if (isal_deflate_stateless(&stream_) != COMP_OK || stream_.avail_in != 0) return {};
        return {out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(stream_.total_out)};
    }

private:
    isal_zstream stream_{};
    Bytes room_, out_;
};

/// Part of the deflated stream.
struct Piece {
    Bytes bytes;                 ///< empty: it could not be deflated
    std::uint32_t sum = 1;       ///< Adler-32 of what was deflated
    std::size_t plain_size = 0;  ///< bytes of that
};

/// Filters rows and deflates them. `above`: the row before the first one.
Piece piece_of(ByteSpan rows, const std::uint8_t* above, const PngFormat& format) {
    thread_local const auto kept = std::make_unique<Deflater>();
    Deflater& deflated = *kept;
    thread_local Bytes filtered;
    const std::size_t row = format.row_bytes();
    const std::size_t count = rows.size() / row;
    filtered.resize(count * (row + 1));
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* const own = rows.data() + i * row;
        filter_row(own, i == 0 ? above : own - row, format, filtered.data() + i * (row + 1));
    }
    return {.bytes = deflated(filtered),
            .sum = isal_adler32(1, filtered.data(), filtered.size()),
            .plain_size = filtered.size()};
}

Bytes header_of(const PngFormat& format) {
    Bytes header;
    append_number(header, static_cast<std::uint32_t>(format.width));
    append_number(header, static_cast<std::uint32_t>(format.height));
    constexpr int rgb = 2;
    constexpr int rgba = 6;
    for (const int byte : {format.bits, format.channels == 4 ? rgba : rgb, 0, 0, 0})
        header.push_back(static_cast<std::uint8_t>(byte));
    return header;
}

Bytes density_of(double dots_per_inch) {
    const auto per_metre = static_cast<std::uint32_t>(std::lround(dots_per_inch / inch_in_metres));
    Bytes density;
    append_number(density, per_metre);
    append_number(density, per_metre);
    density.push_back(1);  // the unit is the metre
    return density;
}

/// The contents of iTXt, compressed.
Bytes text_chunk(const PngText& text) {
    Bytes chunk;
    append_text(chunk, text.keyword);
    // end of the keyword, compressed, by zlib, no language, no translated keyword
    for (const int byte : {0, 1, 0, 0, 0})
        chunk.push_back(static_cast<std::uint8_t>(byte));
    const Bytes bytes = packed(text.text);
    chunk.insert(chunk.end(), bytes.begin(), bytes.end());
    return chunk;
}

}  // namespace

PngWriter::PngWriter(PngFormat format, ByteSink sink)
    : format_(std::move(format)), sink_(std::move(sink)), last_row_(format_.row_bytes()) {}

bool PngWriter::write_chunk(const char* type, ByteSpan data) {
    Bytes head;
    append_number(head, static_cast<std::uint32_t>(data.size()));
    append_text(head, type);
    uLong sum = crc32_z(0, head.data() + 4, 4);
    // With a null pointer zlib would begin anew.
    if (!data.empty()) sum = crc32_z(sum, data.data(), data.size());
    Bytes tail;
    append_number(tail, static_cast<std::uint32_t>(sum));
    for (const ByteSpan part : {ByteSpan(head), data, ByteSpan(tail)})
        failed_ = failed_ || (!part.empty() && !sink_(std::as_bytes(part)));
    return !failed_;
}

bool PngWriter::write_header() {
    begun_ = true;
    constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    failed_ = !sink_(std::as_bytes(std::span(signature)));
    write_chunk("IHDR", header_of(format_));
    constexpr std::array<std::uint8_t, 1> perceptual{0};
    write_chunk("sRGB", perceptual);
    if (format_.dots_per_inch > 0) write_chunk("pHYs", density_of(format_.dots_per_inch));
    for (const PngText& text : format_.texts)
        write_chunk("iTXt", text_chunk(text));
    constexpr std::array<std::uint8_t, 2> zlib_header{0x78, 0x5E};
    return write_chunk("IDAT", zlib_header);
}

bool PngWriter::add_rows(ByteSpan rows) {
    if (!begun_ && !write_header()) return false;
    const std::size_t row = format_.row_bytes();
    assert(rows.size() % row == 0);
    if (failed_ || rows.empty()) return !failed_;
    const std::size_t step = std::max<std::size_t>(piece_size / row, 1) * row;
    std::vector<Piece> pieces((rows.size() + step - 1) / step);
    parallel_for(pieces.size(), 0, [&](std::size_t i) {
        const ByteSpan part = rows.subspan(i * step, std::min(step, rows.size() - i * step));
        pieces[i] = piece_of(part, i == 0 ? last_row_.data() : part.data() - row, format_);
    });
    std::copy_n(rows.end() - static_cast<std::ptrdiff_t>(row), row, last_row_.begin());
    for (const Piece& piece : pieces) {
        sum_ = adler32_combine(sum_, piece.sum, static_cast<z_off_t>(piece.plain_size));
        failed_ = failed_ || piece.bytes.empty();
        if (failed_ || !write_chunk("IDAT", piece.bytes)) return false;
    }
    return true;
}

bool PngWriter::finish() {
    if (!begun_ && !write_header()) return false;
    Bytes end{0x03, 0x00};  // an empty block, the last one
    append_number(end, static_cast<std::uint32_t>(sum_));
    write_chunk("IDAT", end);
    return write_chunk("IEND", {});
}

}  // namespace zeroset
