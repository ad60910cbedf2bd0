#include "engine/export/films/film_formats.hpp"

#include "engine/base/text.hpp"
#include "engine/export/codecs/codec.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace zeroset {
namespace {

constexpr double any_rate = 240.0;

constexpr std::array<FilmFormat, 6> formats{{
    {.name = "MP4",
     .ending = ".mp4",
     .about = "H.264: plays everywhere, in talks and on telephones",
     .codec = FilmCodec::H264,
     .alpha = false,
     .lossy = true,
     .even = true,
     .largest_side = 8192,
     .largest_rate = any_rate},
    {.name = "WebM",
     .ending = ".webm",
     .about = "VP9: for the web; can be transparent",
     .codec = FilmCodec::Vp9,
     .alpha = true,
     .lossy = true,
     .even = true,
     .largest_side = 16384,
     .largest_rate = any_rate},
    {.name = "QuickTime",
     .ending = ".mov",
     .about = "ProRes 4444: for cutting; can be transparent",
     .codec = FilmCodec::ProRes,
     .alpha = true,
     .lossy = false,
     .even = true,
     .largest_side = 8192,
     .largest_rate = any_rate},
    {.name = "Matroska",
     .ending = ".mkv",
     .about = "FFV1: without loss; can be transparent",
     .codec = FilmCodec::Ffv1,
     .alpha = true,
     .lossy = false,
     .even = false,
     .largest_side = 16384,
     .largest_rate = any_rate},
    {.name = "GIF",
     .ending = ".gif",
     .about = "plays in every page and message; 255 colors",
     .codec = FilmCodec::Gif,
     .alpha = true,
     .lossy = false,
     .even = false,
     .largest_side = 4000,
     .largest_rate = 50.0},  // viewers slow down what is quicker
    {.name = "APNG",
     .ending = ".apng",
     .about = "as GIF, but without loss; can be transparent",
     .codec = FilmCodec::Apng,
     .alpha = true,
     .lossy = false,
     .even = false,
     .largest_side = 16384,
     .largest_rate = any_rate},
}};

std::string even_size(const FilmSettings& settings) {
    return std::to_string(settings.width + settings.width % 2) + "x" +
           std::to_string(settings.height + settings.height % 2);
}

std::string transparent_endings() {
    std::vector<std::string_view> endings;
    for (const FilmFormat& format : formats) {
        if (format.alpha && missing_encoder(encoder_of(format.codec)).empty())
            endings.push_back(format.ending);
    }
    return endings.empty() ? "#.png, for numbered pictures" : one_of(endings);
}

}  // namespace

std::span<const FilmFormat> film_formats() { return formats; }

const FilmFormat* film_format_of(const std::filesystem::path& path) {
    const std::string ending = lower_case(path.extension().string());
    const auto* const found = std::ranges::find(formats, ending, &FilmFormat::ending);
    return found == formats.end() ? nullptr : found;
}

std::optional<std::string> refusal(const FilmFormat& format, const FilmSettings& settings) {
    const std::string name(format.name);
    const std::string missing = missing_encoder(encoder_of(format.codec));
    if (!missing.empty())
        return "no " + name + ": " + missing + "; numbered frames need none: type frame####.png";
    if (settings.alpha && !format.alpha)
        return "a film in " + name + " cannot be transparent; type a name that ends in " +
               transparent_endings();
    if (format.even && (settings.width % 2 != 0 || settings.height % 2 != 0))
        return name + " has even sides only: " + even_size(settings) + " would do";
    if (std::max(settings.width, settings.height) > format.largest_side) {
        return name + " films cannot be larger than " + std::to_string(format.largest_side) +
               " pixels a side";
    }
    const double rate = static_cast<double>(settings.rate.frames) / settings.rate.seconds;
    if (rate > format.largest_rate) {
        return name + " plays " + std::to_string(static_cast<int>(format.largest_rate)) +
               " frames a second at most";
    }
    return std::nullopt;
}

}  // namespace zeroset
