#include "engine/export/png_writer.hpp"

#include "engine/base/parallel.hpp"
#include "engine/export/packed.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

namespace zeroset {
namespace {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

// zlib's level and strategy. Filtered pictures of surfaces are runs of equal bytes between numbers
// that do not repeat: looking for other matches makes them little smaller, and takes longer than
// drawing them.
constexpr int deflate_level = 1;
constexpr int deflate_strategy = Z_RLE;
/// Filtered bytes that are deflated at once, about: smaller pieces make larger files.
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

/// Sum of the absolute differences in a filtered row: small differences deflate best.
std::uint32_t size_of(ByteSpan differences) {
    std::uint32_t sum = 0;
    for (const std::uint8_t byte : differences)
        sum += static_cast<std::uint32_t>(std::min<int>(byte, 256 - byte));
    return sum;
}

/// Writes a row as it is deflated: as differences from the pixel before or from the row above,
/// whichever are smaller, behind a byte for the filter.
void filter_row(const std::uint8_t* row, const std::uint8_t* above, const PngFormat& format,
                std::uint8_t* out) {
    const std::size_t bytes = format.row_bytes();
    const std::size_t pixel = format.pixel_bytes();
    thread_local Bytes sub;
    sub.resize(bytes);
    std::copy_n(row, pixel, sub.data());
    for (std::size_t i = pixel; i < bytes; ++i)
        sub[i] = static_cast<std::uint8_t>(row[i] - row[i - pixel]);
    for (std::size_t i = 0; i < bytes; ++i)
        out[i + 1] = static_cast<std::uint8_t>(row[i] - above[i]);
    const bool up = size_of({out + 1, bytes}) <= size_of(sub);
    *out = static_cast<std::uint8_t>(up ? RowFilter::Up : RowFilter::Sub);
    if (!up) std::ranges::copy(sub, out + 1);
}

/// Part of a deflated stream.
struct Piece {
    Bytes bytes;
    unsigned long sum = 1;  ///< Adler-32 of what was deflated
};

/// Deflates `data`; the stream goes on. As runs refer to the byte before alone, a piece need not
/// know the one before.
Piece deflated(ByteSpan data) {
    z_stream stream{};
    constexpr int raw = -15;
    constexpr int memory = 9;
    Piece piece;
    if (deflateInit2(&stream, deflate_level, Z_DEFLATED, raw, memory, deflate_strategy) != Z_OK)
        return piece;
    constexpr std::size_t end_of_piece = 16;  // the empty block that Z_SYNC_FLUSH appends
    piece.bytes.resize(deflateBound(&stream, static_cast<uLong>(data.size())) + end_of_piece);
    stream.next_in = const_cast<Bytef*>(data.data());  // zlib only reads it
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = piece.bytes.data();
    stream.avail_out = static_cast<uInt>(piece.bytes.size());
    const int done = deflate(&stream, Z_SYNC_FLUSH);
    assert(done == Z_OK && stream.avail_in == 0);
    piece.bytes.resize(done == Z_OK ? stream.total_out : 0);
    deflateEnd(&stream);
    piece.sum = adler32_z(1, data.data(), data.size());
    return piece;
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

bool PngWriter::deflate_and_write(ByteSpan filtered) {
    const std::size_t row = format_.row_bytes() + 1;
    const std::size_t step = std::max<std::size_t>(piece_size / row, 1) * row;
    const auto part = [&](std::size_t i) {
        return filtered.subspan(i * step, std::min(step, filtered.size() - i * step));
    };
    std::vector<Piece> pieces((filtered.size() + step - 1) / step);
    parallel_for(pieces.size(), 0, [&](std::size_t i) { pieces[i] = deflated(part(i)); });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        sum_ = adler32_combine(sum_, pieces[i].sum, static_cast<z_off_t>(part(i).size()));
        if (!write_chunk("IDAT", pieces[i].bytes)) return false;
    }
    return true;
}

bool PngWriter::add_rows(ByteSpan rows) {
    if (!begun_ && !write_header()) return false;
    const std::size_t row = format_.row_bytes();
    const std::size_t count = rows.size() / row;
    assert(count * row == rows.size());
    if (failed_ || count == 0) return !failed_;
    filtered_.resize(count * (row + 1));
    parallel_for(count, 0, [&](std::size_t i) {
        const std::uint8_t* const own = rows.data() + i * row;
        const std::uint8_t* const above = i == 0 ? last_row_.data() : own - row;
        filter_row(own, above, format_, filtered_.data() + i * (row + 1));
    });
    std::copy_n(rows.end() - static_cast<std::ptrdiff_t>(row), row, last_row_.begin());
    return deflate_and_write(filtered_);
}

bool PngWriter::finish() {
    if (!begun_ && !write_header()) return false;
    Bytes end{0x03, 0x00};  // an empty block, the last one
    append_number(end, static_cast<std::uint32_t>(sum_));
    write_chunk("IDAT", end);
    return write_chunk("IEND", {});
}

}  // namespace zeroset
