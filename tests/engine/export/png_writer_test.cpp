#include "engine/export/png_writer.hpp"

#include "engine/export/png.hpp"

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace zeroset::test::png_writer_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Rows with flat parts, slopes and noise, so that both filters and literals occur.
Bytes rows_of(const PngFormat& format) {
    std::mt19937 random(7);
    Bytes rows(format.row_bytes() * static_cast<std::size_t>(format.height));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t row = i / format.row_bytes();
        const std::size_t col = i % format.row_bytes();
        const bool noisy = row % 16 == 3 && col % 64 < 8;
        rows[i] = static_cast<std::uint8_t>(noisy ? random() : row / 4 + col / 100);
    }
    return rows;
}

/// The file, from bands of so many rows.
std::vector<std::byte> png_from(const PngFormat& format, const Bytes& rows, std::size_t band_rows) {
    std::vector<std::byte> file;
    PngWriter writer(format, [&file](std::span<const std::byte> bytes) {
        file.insert(file.end(), bytes.begin(), bytes.end());
        return true;
    });
    const std::size_t band = band_rows * format.row_bytes();
    for (std::size_t from = 0; from < rows.size(); from += band)
        EXPECT_TRUE(
            writer.add_rows(std::span(rows).subspan(from, std::min(band, rows.size() - from))));
    EXPECT_TRUE(writer.finish());
    return file;
}

std::string many_numbers() {
    std::string text;
    for (int i = 0; i < 1500; ++i)
        text += std::to_string(i) + " ";
    return text;
}

struct FreePixels {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

/// The pixels that stb_image reads, high bytes first; it checks no sums.
Bytes decoded(const std::vector<std::byte>& file, const PngFormat& format) {
    const auto* const data = reinterpret_cast<const stbi_uc*>(file.data());
    const auto size = static_cast<int>(file.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    Bytes rows;
    const auto check = [&](const void* pixels) {
        EXPECT_NE(pixels, nullptr);
        EXPECT_EQ(width, format.width);
        EXPECT_EQ(height, format.height);
        EXPECT_EQ(channels, format.channels);
    };
    const std::size_t count =
        static_cast<std::size_t>(format.width * format.height * format.channels);
    if (format.bits == 8) {
        const std::unique_ptr<stbi_uc, FreePixels> pixels(
            stbi_load_from_memory(data, size, &width, &height, &channels, 0));
        check(pixels.get());
        if (pixels != nullptr) rows.assign(pixels.get(), pixels.get() + count);
        return rows;
    }
    const std::unique_ptr<stbi_us, FreePixels> pixels(
        stbi_load_16_from_memory(data, size, &width, &height, &channels, 0));
    check(pixels.get());
    for (std::size_t i = 0; pixels != nullptr && i < count; ++i) {
        rows.push_back(static_cast<std::uint8_t>(pixels.get()[i] >> 8U));
        rows.push_back(static_cast<std::uint8_t>(pixels.get()[i] & 0xFFU));
    }
    return rows;
}

TEST(PngWriter, WritesWhatStbReads) {
    for (const int channels : {3, 4}) {
        for (const int bits : {8, 16}) {
            const PngFormat format{
                .width = 1237, .height = 301, .channels = channels, .bits = bits, .texts = {}};
            const Bytes rows = rows_of(format);
            for (const std::size_t band : {std::size_t{1}, std::size_t{64}, std::size_t{1000}})
                EXPECT_EQ(decoded(png_from(format, rows, band), format), rows) << channels << bits;
        }
    }
}

TEST(PngWriter, WritesWhatCannotGetSmaller) {
    const PngFormat format{.width = 700, .height = 400, .channels = 4, .bits = 16, .texts = {}};
    std::mt19937 random(11);
    Bytes rows(format.row_bytes() * static_cast<std::size_t>(format.height));
    for (std::uint8_t& byte : rows)
        byte = static_cast<std::uint8_t>(random());
    const std::vector<std::byte> file = png_from(format, rows, 200);
    EXPECT_EQ(decoded(file, format), rows);
    EXPECT_LE(file.size(), rows.size() + rows.size() / 100);
}

TEST(PngWriter, WritesOnePixel) {
    const PngFormat format{.width = 1, .height = 1, .texts = {}};
    const Bytes rows{1, 2, 3};
    EXPECT_EQ(decoded(png_from(format, rows, 1), format), rows);
}

TEST(PngWriter, TellsWhenTheSinkFails) {
    const PngFormat format{.width = 100, .height = 100, .texts = {}};
    const Bytes rows = rows_of(format);
    for (const std::size_t room : {std::size_t{0}, std::size_t{40}, std::size_t{200}}) {
        std::size_t written = 0;
        PngWriter writer(format, [&](std::span<const std::byte> bytes) {
            written += bytes.size();
            return written <= room;
        });
        EXPECT_FALSE(writer.add_rows(rows)) << room;
        EXPECT_FALSE(writer.finish()) << room;
    }
}

TEST(PngWriter, HoldsTextsThatAreFoundAgain) {
    const std::string text = "x\u00b2 + y = 1\n" + std::string(100'000, 'a');
    const PngFormat format{.width = 3,
                           .height = 2,
                           .dots_per_inch = 300.0,
                           .texts = {{"other", "not this"}, {"a text", text}}};
    const std::vector<std::byte> file = png_from(format, Bytes(18), 2);
    EXPECT_EQ(text_in_png(file, "a text"), text);
    EXPECT_EQ(text_in_png(file, "other"), "not this");
    EXPECT_FALSE(text_in_png(file, "a"));
    EXPECT_FALSE(text_in_png(std::as_bytes(std::span("no picture at all")), "a text"));
}

TEST(PngWriter, DamagedTextsAreNotFound) {
    PngFormat format{.width = 3, .height = 2, .texts = {}};
    format.texts.push_back({"a text", many_numbers()});
    const std::vector<std::byte> file = png_from(format, Bytes(18), 2);
    for (std::size_t size = 0; size < file.size(); ++size)
        (void)text_in_png(std::span(file).first(size), "a text");
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
        std::vector<std::byte> damaged = file;
        damaged[8 + random() % (damaged.size() - 8)] = static_cast<std::byte>(random());
        const auto text = text_in_png(damaged, "a text");
        EXPECT_LE(text.value_or("").size(), std::size_t{64} << 20U);
    }
}

}  // namespace
}  // namespace zeroset::test::png_writer_test
