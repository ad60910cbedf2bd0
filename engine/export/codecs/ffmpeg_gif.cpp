#include "engine/base/parallel.hpp"
#include "engine/base/translation.hpp"
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
    using Numbers = std::vector<std::uint8_t>;  ///< of colours in the palette

    /// The frame's colours in the palette; empty where memory is damaged.
    [[nodiscard]] Numbers numbers_of(std::size_t frame, const FilmPalette& palette) const;
    std::expected<void, std::string> write(FilmEncoder& film, const FilmPalette& palette);

    FilmCodecRow row_;
    std::filesystem::path path_;
    FilmSettings settings_;
    ColorCounts counts_;
    std::vector<std::vector<std::uint8_t>> frames_;  ///< packed
    Numbers numbers_;                                ///< of the frame that is written
};

constexpr std::uint8_t transparent = 255;

/// Copies the numbers of a frame's colours, and the palette.
void fill_numbers(std::span<const std::uint8_t> numbers, const FilmPalette& palette, AVFrame& to) {
    const auto width = static_cast<std::size_t>(to.width);
    for (int row = 0; row < to.height; ++row)
        std::memcpy(plane_row(to, 0, row), &numbers[static_cast<std::size_t>(row) * width], width);
    std::array<std::uint32_t, 256> colors{};
    std::fill_n(colors.begin(), transparent, 0xFF000000U);
    for (std::size_t i = 0; i < palette.size(); ++i)
        colors[i] |= palette[i];
    std::memcpy(to.data[1], colors.data(), sizeof colors);
}

Gif::Numbers Gif::numbers_of(std::size_t frame, const FilmPalette& palette) const {
    const auto rows = unpacked(frames_[frame]);
    if (!rows) return {};
    std::vector<std::uint32_t> pixels(rows->size() / sizeof(std::uint32_t));
    std::memcpy(pixels.data(), rows->data(), rows->size());
    return dithered({.width = settings_.width,
                     .height = settings_.height,
                     .alpha = settings_.alpha,
                     .pixels = pixels},
                    palette, transparent);
}

std::expected<void, std::string> Gif::write(FilmEncoder& film, const FilmPalette& palette) {
    // An error runs on from pixel to pixel, so that a frame is dithered by one core.
    std::vector<Numbers> some(static_cast<std::size_t>(core_count()));
    for (std::size_t first = 0; first < frames_.size(); first += some.size()) {
        const std::size_t count = std::min(some.size(), frames_.size() - first);
        parallel_for(count, 0, [&](std::size_t i) { some[i] = numbers_of(first + i, palette); });
        for (std::size_t i = 0; i < count; ++i) {
            numbers_ = std::move(some[i]);
            if (numbers_.empty()) return std::unexpected(tr("memory is damaged"));
            if (auto added =
                    film.add({.width = settings_.width, .height = settings_.height, .pixels = {}});
                !added)
                return added;
        }
    }
    return film.finish();
}

std::expected<void, std::string> Gif::finish() {
    const FilmPalette palette = counts_.palette(transparent);
    row_.fill = [this, &palette](const VideoFrame&, AVFrame& to) {
        fill_numbers(numbers_, palette, to);
    };
    const auto film = open_ffmpeg_film(row_, path_, settings_);
    if (!film) return std::unexpected(film.error());
    return write(**film, palette);
}

}  // namespace

std::expected<std::unique_ptr<FilmEncoder>, std::string> open_ffmpeg_gif(
    const FilmCodecRow& row, const std::filesystem::path& path, const FilmSettings& settings) {
    return std::make_unique<Gif>(row, path, settings);
}

}  // namespace zeroset
