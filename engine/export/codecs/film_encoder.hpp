#pragma once

#include "engine/base/clock.hpp"
#include "engine/export/codecs/video_pixels.hpp"

#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <string>

namespace zeroset {

/// The codecs of films, each with the kind of file it goes into.
enum class FilmCodec : std::uint8_t {
    H264,    ///< MP4
    Vp9,     ///< WebM
    ProRes,  ///< 4444, in a QuickTime file
    Ffv1,    ///< without loss, in a Matroska file
    Gif,     ///< one palette for all frames
    Apng,    ///< without loss
};

struct FilmSettings {
    int width = 0;
    int height = 0;
    FrameRate rate;
    bool alpha = false;
    int quality = 90;  ///< of codecs with losses, 1 to 100
};

/// FFmpeg's name of the encoder.
const char* encoder_of(FilmCodec codec);

/// Encodes frames into a film. One thread calls.
class FilmEncoder {
public:
    virtual ~FilmEncoder() = default;
    FilmEncoder() = default;
    FilmEncoder(const FilmEncoder&) = delete;
    FilmEncoder& operator=(const FilmEncoder&) = delete;

    /// Appends a frame of the film's size; or says why it cannot.
    virtual std::expected<void, std::string> add(const VideoFrame& frame) = 0;
    /// Completes the file.
    virtual std::expected<void, std::string> finish() = 0;
};

/// Begins a film in a new file at `path`; or says why it cannot.
std::expected<std::unique_ptr<FilmEncoder>, std::string> open_film(
    FilmCodec codec, const std::filesystem::path& path, const FilmSettings& settings);

}  // namespace zeroset
