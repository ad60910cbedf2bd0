#include "engine/export/png.hpp"

#include "engine/export/packed.hpp"
#include "engine/export/png_writer.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>

namespace zeroset {
namespace {

constexpr int largest_side = 4096;

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

std::vector<std::byte> encoded(const PngFormat& format, std::span<const std::uint8_t> rows) {
    std::vector<std::byte> png;
    PngWriter writer(format, [&png](std::span<const std::byte> bytes) {
        png.insert(png.end(), bytes.begin(), bytes.end());
        return true;
    });
    writer.add_rows(rows);
    writer.finish();
    return png;
}

std::uint32_t number_at(std::span<const std::byte> bytes) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8U | std::to_integer<std::uint32_t>(bytes[i]);
    return number;
}

std::span<const std::uint8_t> unsigned_bytes(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

std::string_view letters(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<std::byte> png_of(const Framebuffer& frame) {
    std::vector<std::uint8_t> rgb(frame.color.size() * 3);
    std::uint8_t* out = rgb.data();
    for (const std::uint32_t pixel : frame.color) {
        for (const unsigned shift : {0U, 8U, 16U})
            *out++ = static_cast<std::uint8_t>(pixel >> shift & 0xFFU);
    }
    return encoded({.width = frame.width, .height = frame.height, .texts = {}}, rgb);
}

std::vector<std::byte> png_of(const RgbaImage& image) {
    const auto* const rows = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
    return encoded({.width = image.width, .height = image.height, .channels = 4, .texts = {}},
                   {rows, image.pixels.size() * sizeof(std::uint32_t)});
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

std::optional<PngSize> size_of_png(std::span<const std::byte> png) {
    // signature, length and type of the first chunk, width, height
    if (png.size() < 24 || letters(png.subspan(1, 3)) != "PNG") return std::nullopt;
    return PngSize{.width = number_at(png.subspan(16)), .height = number_at(png.subspan(20))};
}

std::optional<std::string> text_in_png(std::span<const std::byte> png, std::string_view keyword) {
    constexpr std::size_t signature = 8;
    constexpr std::size_t around_data = 12;  // length, type and sum
    if (png.size() < signature || letters(png.subspan(1, 3)) != "PNG") return std::nullopt;
    auto rest = png.subspan(signature);
    while (rest.size() >= around_data) {
        const std::size_t size = number_at(rest);
        if (size > rest.size() - around_data) return std::nullopt;
        const auto data = rest.subspan(8, size);
        // keyword, 0, compressed, by zlib, language, 0, translated keyword, 0
        const std::string head = std::string(keyword) + std::string("\0\1\0\0\0", 5);
        if (letters(rest.subspan(4, 4)) == "iTXt" && letters(data).starts_with(head))
            return unpacked(unsigned_bytes(data.subspan(head.size())));
        rest = rest.subspan(around_data + size);
    }
    return std::nullopt;
}

}  // namespace zeroset
