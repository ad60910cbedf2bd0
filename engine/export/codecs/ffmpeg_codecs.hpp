#pragma once

#include "engine/export/codecs/ffmpeg_objects.hpp"
#include "engine/export/codecs/film_encoder.hpp"

extern "C" {
#include <libavutil/pixfmt.h>
}

#include <expected>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {

/// How FFmpeg makes a kind of film.
struct FilmCodecRow {
    const char* encoder;
    const char* muxer;
    AVPixelFormat opaque, with_alpha;  ///< the same where the codec knows no alpha
    bool is_video;                     ///< luma and chroma, by write_video_planes
    int ticks_per_second;              ///< of the file's clock; 0: those of the frames
    bool alpha_tag;                    ///< the stream says that it has alpha
    std::vector<std::pair<const char*, const char*>> muxer_options;
    void (*set_up)(AVCodecContext& encoder, const FilmSettings& settings);
    std::function<void(const VideoFrame& from, AVFrame& to)> fill;
};

/// The row of each codec. GIF takes numbers of colours: see ffmpeg_gif.cpp.
FilmCodecRow film_codec_row(FilmCodec codec);

/// Begins a film in a new file at `path`.
std::expected<std::unique_ptr<FilmEncoder>, std::string> open_ffmpeg_film(
    const FilmCodecRow& row, const std::filesystem::path& path, const FilmSettings& settings);

/// Begins a GIF in a new file at `path`; it needs all frames before it can choose its colours.
std::expected<std::unique_ptr<FilmEncoder>, std::string> open_ffmpeg_gif(
    const FilmCodecRow& row, const std::filesystem::path& path, const FilmSettings& settings);

}  // namespace zeroset
