#include "engine/export/codecs/ffmpeg_codecs.hpp"
#include "engine/export/codecs/film_palette.hpp"
#include "engine/export/packed.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace zeroset {
namespace {

/// Gathers all frames, chooses one palette for them, and then writes them.
class Gif final : public FilmEncoder {
public:
    Gif(FilmCodecRow row, std::filesystem::path path, const FilmSettings& settings)
        : row_(std::move(row)), path_(std::move(path)), settings_(settings) {}

    std::expected<void, std::string> add(const VideoFrame& frame) override {
        counts_.add(frame);
        const auto bytes = std::as_bytes(frame.pixels);
        frames_.push_back(
            packed({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, Packing::Quick));
        return {};
    }
    std::expected<void, std::string> finish() override;

private:
    FilmCodecRow row_;
    std::filesystem::path path_;
    FilmSettings settings_;
    ColorCounts counts_;
    std::vector<std::vector<std::uint8_t>> frames_;  ///< packed
};

constexpr std::uint8_t transparent = 255;

/// Writes the numbers of a frame's colours, and the palette.
void fill_numbers(const VideoFrame& from, AVFrame& to, const FilmPalette& palette) {
    const std::vector<std::uint8_t> numbers = dithered(from, palette, transparent);
    const auto width = static_cast<std::size_t>(from.width);
    for (int row = 0; row < from.height; ++row)
        std::memcpy(plane_row(to, 0, row), &numbers[static_cast<std::size_t>(row) * width], width);
    std::array<std::uint32_t, 256> colors{};
    std::fill_n(colors.begin(), transparent, 0xFF000000U);
    for (std::size_t i = 0; i < palette.size(); ++i)
        colors[i] |= palette[i];
    std::memcpy(to.data[1], colors.data(), sizeof colors);
}

std::expected<void, std::string> Gif::finish() {
    const FilmPalette palette = counts_.palette(transparent);
    row_.fill = [&palette](const VideoFrame& from, AVFrame& to) {
        fill_numbers(from, to, palette);
    };
    auto film = open_ffmpeg_film(row_, path_, settings_);
    if (!film) return std::unexpected(film.error());
    for (const std::vector<std::uint8_t>& bytes : frames_) {
        const auto rows = unpacked(bytes);
        if (!rows) return std::unexpected("memory is damaged");
        std::vector<std::uint32_t> pixels(rows->size() / sizeof(std::uint32_t));
        std::memcpy(pixels.data(), rows->data(), rows->size());
        const auto added = (*film)->add({.width = settings_.width,
                                         .height = settings_.height,
                                         .alpha = settings_.alpha,
                                         .pixels = pixels});
        if (!added) return added;
    }
    return (*film)->finish();
}

}  // namespace

std::expected<std::unique_ptr<FilmEncoder>, std::string> open_ffmpeg_gif(
    const FilmCodecRow& row, const std::filesystem::path& path, const FilmSettings& settings) {
    return std::make_unique<Gif>(row, path, settings);
}

}  // namespace zeroset
