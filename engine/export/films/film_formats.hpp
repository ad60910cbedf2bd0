#pragma once

#include "engine/export/codecs/film_encoder.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace zeroset {

/// A kind of film file.
struct FilmFormat {
    std::string_view name;    ///< "MP4"
    std::string_view ending;  ///< ".mp4"
    std::string_view about;   ///< what it is good for
    FilmCodec codec;
    bool alpha;  ///< can be transparent
    bool lossy;  ///< FilmSettings::quality counts
    bool even;   ///< both sides are even numbers of pixels
    int largest_side;
    double largest_rate;  ///< frames a second
};

/// All of them, MP4 first.
std::span<const FilmFormat> film_formats();

/// The format of the path's ending, in any case; nullptr where there is none.
const FilmFormat* film_format_of(const std::filesystem::path& path);

/// Why a film cannot be written so, with what can be done instead; nothing where it can.
std::optional<std::string> refusal(const FilmFormat& format, const FilmSettings& settings);

}  // namespace zeroset
