#include "engine/export/films/film_formats.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/codecs/codec.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace zeroset {
namespace {

constexpr double any_rate = 240.0;

constexpr std::array<FilmFormat, 6> known_films{{
    {.name = "MP4",
     .ending = ".mp4",
     .about = marked("H.264: plays everywhere, in talks and on telephones"),
     .codec = FilmCodec::H264,
     .alpha = false,
     .lossy = true,
     .even = true,
     .largest_side = 8192,
     .largest_rate = any_rate},
    {.name = "WebM",
     .ending = ".webm",
     .about = marked("VP9: for the web; can be transparent"),
     .codec = FilmCodec::Vp9,
     .alpha = true,
     .lossy = true,
     .even = true,
     .largest_side = 16384,
     .largest_rate = any_rate},
    {.name = "QuickTime",
     .ending = ".mov",
     .about = marked("ProRes 4444: for cutting; can be transparent"),
     .codec = FilmCodec::ProRes,
     .alpha = true,
     .lossy = false,
     .even = true,
     .largest_side = 8192,
     .largest_rate = any_rate},
    {.name = "Matroska",
     .ending = ".mkv",
     .about = marked("FFV1: without loss; can be transparent"),
     .codec = FilmCodec::Ffv1,
     .alpha = true,
     .lossy = false,
     .even = false,
     .largest_side = 16384,
     .largest_rate = any_rate},
    {.name = "GIF",
     .ending = ".gif",
     .about = marked("plays in every page and message; 255 colors"),
     .codec = FilmCodec::Gif,
     .alpha = true,
     .lossy = false,
     .even = false,
     .largest_side = 4000,
     .largest_rate = 50.0},  // viewers slow down what is quicker
    {.name = "APNG",
     .ending = ".apng",
     .about = marked("as GIF, but without loss; can be transparent"),
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
    for (const FilmFormat& format : known_films) {
        if (format.alpha && missing_encoder(encoder_of(format.codec)).empty())
            endings.push_back(format.ending);
    }
    return endings.empty() ? tr("#.png, for numbered pictures") : one_of(endings);
}

}  // namespace

std::span<const FilmFormat> film_formats() { return known_films; }

const FilmFormat* film_format_of(const std::filesystem::path& path) {
    const std::string ending = lower_case(path.extension().string());
    const auto* const found = std::ranges::find(known_films, ending, &FilmFormat::ending);
    return found == known_films.end() ? nullptr : found;
}

std::optional<std::string> refusal(const FilmFormat& format, const FilmSettings& settings) {
    const std::string name(format.name);
    const std::string missing = missing_encoder(encoder_of(format.codec));
    if (!missing.empty())
        return filled(tr("no {0}: {1}; numbered frames need none: type frame####.png"),
                      {name, missing});
    if (settings.alpha && !format.alpha)
        return filled(tr("a film in {0} cannot be transparent; type a name that ends in {1}"),
                      {name, transparent_endings()});
    if (format.even && (settings.width % 2 != 0 || settings.height % 2 != 0))
        return filled(tr("{0} has even sides only: {1} would do"), {name, even_size(settings)});
    if (std::max(settings.width, settings.height) > format.largest_side) {
        return filled(tr("{0} films cannot be larger than {1} pixels a side"),
                      {name, std::to_string(format.largest_side)});
    }
    const double rate = static_cast<double>(settings.rate.frames) / settings.rate.seconds;
    if (rate > format.largest_rate) {
        return filled(tr("{0} plays {1} frames a second at most"),
                      {name, std::to_string(static_cast<int>(format.largest_rate))});
    }
    return std::nullopt;
}

}  // namespace zeroset
