#include "engine/export/packed.hpp"

#include <zlib.h>

#include <array>
#include <cassert>

namespace zeroset {
namespace {

constexpr std::size_t longest_unpacked = std::size_t{64} << 20U;

}  // namespace

std::vector<std::uint8_t> packed(std::string_view text, Packing packing) {
    const int level = packing == Packing::Quick ? Z_BEST_SPEED : Z_BEST_COMPRESSION;
    uLongf size = compressBound(static_cast<uLong>(text.size()));
    std::vector<std::uint8_t> bytes(size);
    const auto* const plain = reinterpret_cast<const Bytef*>(text.data());
    [[maybe_unused]] const int done =
        compress2(bytes.data(), &size, plain, static_cast<uLong>(text.size()), level);
    assert(done == Z_OK);  // there is room
    bytes.resize(size);
    return bytes;
}

std::optional<std::string> unpacked(std::span<const std::uint8_t> bytes) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return std::nullopt;
    stream.next_in = const_cast<Bytef*>(bytes.data());  // zlib only reads it
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    int state = Z_OK;
    while (state == Z_OK && text.size() <= longest_unpacked) {
        std::array<char, 65536> part;
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        state = inflate(&stream, Z_NO_FLUSH);
        text.append(part.data(), part.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (state != Z_STREAM_END || text.size() > longest_unpacked) return std::nullopt;
    return text;
}

}  // namespace zeroset
