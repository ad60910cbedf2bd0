#include "engine/export/png.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>

// PNG as in ISO/IEC 15948: a header, one stream of filtered rows, the end.

namespace zeroset {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// zlib's level. Higher ones make pictures of surfaces little smaller, and take longer
/// than drawing them.
constexpr int deflate_level = 4;

enum class RowFilter : std::uint8_t { Sub = 1, Up = 2 };

void append_number(std::vector<std::byte>& png, std::uint32_t number) {
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        png.push_back(static_cast<std::byte>(number >> shift & 0xFFU));
}

void append_chunk(std::vector<std::byte>& png, std::string_view type,
                  std::span<const std::uint8_t> data) {
    append_number(png, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = png.size();
    for (const char letter : type)
        png.push_back(static_cast<std::byte>(letter));
    const auto bytes = std::as_bytes(data);
    png.insert(png.end(), bytes.begin(), bytes.end());
    const auto* const covered = reinterpret_cast<const Bytef*>(png.data() + begin);
    const uLong sum = crc32_z(0, covered, png.size() - begin);
    append_number(png, static_cast<std::uint32_t>(sum));
}

/// Sum of the absolute differences in a filtered row: small differences deflate best.
std::uint32_t size_of(std::span<const std::uint8_t> differences) {
    std::uint32_t sum = 0;
    for (const std::uint8_t byte : differences)
        sum += static_cast<std::uint32_t>(std::min<int>(byte, 256 - byte));
    return sum;
}

/// The rows as they are deflated: each as differences from the pixel before or from the row above,
/// whichever are smaller, behind a byte for the filter.
Bytes filtered(const std::uint8_t* pixels, std::size_t row_bytes, std::size_t rows,
               std::size_t channels) {
    Bytes result(rows * (row_bytes + 1));
    Bytes sub(row_bytes);
    Bytes up(row_bytes);
    const Bytes nothing_above(row_bytes);
    const std::uint8_t* above = nothing_above.data();
    for (std::size_t row = 0; row < rows; ++row) {
        const std::uint8_t* const own = pixels + row * row_bytes;
        std::copy_n(own, std::min(channels, row_bytes), sub.data());
        for (std::size_t i = channels; i < row_bytes; ++i)
            sub[i] = static_cast<std::uint8_t>(own[i] - own[i - channels]);
        for (std::size_t i = 0; i < row_bytes; ++i)
            up[i] = static_cast<std::uint8_t>(own[i] - above[i]);
        const RowFilter filter = size_of(up) <= size_of(sub) ? RowFilter::Up : RowFilter::Sub;
        std::uint8_t* const out = result.data() + row * (row_bytes + 1);
        *out = static_cast<std::uint8_t>(filter);
        std::ranges::copy(filter == RowFilter::Up ? up : sub, out + 1);
        above = own;
    }
    return result;
}

/// The bytes deflated; empty where zlib fails.
Bytes deflated(const Bytes& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    Bytes result(size);
    const int done = compress2(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()),
                               deflate_level);
    if (done != Z_OK) return {};
    result.resize(size);
    return result;
}

/// The contents of IHDR for 8 bits per channel.
Bytes header_of(int width, int height, int channels) {
    Bytes header;
    for (const int side : {width, height}) {
        for (const unsigned shift : {24U, 16U, 8U, 0U})
            header.push_back(
                static_cast<std::uint8_t>(static_cast<unsigned>(side) >> shift & 0xFFU));
    }
    constexpr std::uint8_t bits = 8;
    constexpr std::uint8_t rgb = 2;
    constexpr std::uint8_t rgba = 6;
    for (const std::uint8_t byte :
         {bits, channels == 4 ? rgba : rgb, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}})
        header.push_back(byte);
    return header;
}

constexpr int largest_side = 4096;

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

std::vector<std::byte> encoded_png(const void* pixels, int width, int height, int channels) {
    const auto row_bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    const Bytes data =
        deflated(filtered(static_cast<const std::uint8_t*>(pixels), row_bytes,
                          static_cast<std::size_t>(height), static_cast<std::size_t>(channels)));
    if (data.empty()) return {};
    std::vector<std::byte> png;
    png.reserve(data.size() + 64);
    for (const int byte : {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A})
        png.push_back(static_cast<std::byte>(byte));
    append_chunk(png, "IHDR", header_of(width, height, channels));
    append_chunk(png, "IDAT", data);
    append_chunk(png, "IEND", {});
    return png;
}

std::vector<std::byte> png_of(const RgbaImage& image) {
    return encoded_png(image.pixels.data(), image.width, image.height, 4);
}

std::optional<RgbaImage> image_from_png(std::span<const std::byte> png) {
    RgbaImage image;
    int channels = 0;
    const auto* const data = reinterpret_cast<const stbi_uc*>(png.data());
    const int size = static_cast<int>(png.size());
    if (stbi_info_from_memory(data, size, &image.width, &image.height, &channels) == 0 ||
        std::max(image.width, image.height) > largest_side) {
        return std::nullopt;
    }
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 4));
    if (pixels == nullptr) return std::nullopt;
    image.pixels.resize(static_cast<std::size_t>(image.width) *
                        static_cast<std::size_t>(image.height));
    std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * sizeof(std::uint32_t));
    return image;
}

}  // namespace zeroset
