#include "engine/export/codecs/ffmpeg_codecs.hpp"

#include "engine/base/parallel.hpp"
#include "engine/export/codecs/ffmpeg_library.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace zeroset {
namespace {

/// A quality from 1 to 100 on an encoder's scale, whose best and worst are given.
int on_scale(int quality, double best, double worst) {
    return static_cast<int>(std::lround(best + (100 - quality) * (worst - best) / 99.0));
}

void set_up_h264(AVCodecContext& encoder, const FilmSettings& settings) {
    ffmpeg().av_opt_set(encoder.priv_data, "preset", "superfast", 0);
    ffmpeg().av_opt_set_double(encoder.priv_data, "crf", on_scale(settings.quality, 15, 43), 0);
}

void set_up_vp9(AVCodecContext& encoder, const FilmSettings& settings) {
    encoder.bit_rate = 0;
    ffmpeg().av_opt_set_int(encoder.priv_data, "crf", on_scale(settings.quality, 14, 55), 0);
    ffmpeg().av_opt_set(encoder.priv_data, "deadline", "good", 0);
    ffmpeg().av_opt_set_int(encoder.priv_data, "cpu-used", 5, 0);
    ffmpeg().av_opt_set_int(encoder.priv_data, "row-mt", 1, 0);
    // Frames that are never shown would have no alpha.
    if (settings.alpha) ffmpeg().av_opt_set_int(encoder.priv_data, "auto-alt-ref", 0, 0);
}

void set_up_prores(AVCodecContext& encoder, const FilmSettings&) {
    ffmpeg().av_opt_set(encoder.priv_data, "profile", "4444", 0);
    ffmpeg().av_opt_set(encoder.priv_data, "vendor", "apl0", 0);
    ffmpeg().av_opt_set_int(encoder.priv_data, "alpha_bits", 16, 0);
}

void set_up_ffv1(AVCodecContext& encoder, const FilmSettings&) {
    encoder.level = 3;
    encoder.slices = 4;
}

void set_up_nothing(AVCodecContext&, const FilmSettings&) {}

template <int bits, bool quartered>
void fill_video(const VideoFrame& from, AVFrame& to) {
    std::array<VideoPlane, 4> planes;
    for (std::size_t i = 0; i < planes.size(); ++i)
        planes[i] = {.data = to.data[i], .row_bytes = to.linesize[i]};
    write_video_planes(from, {.bits = bits, .quartered = quartered}, planes);
}

/// Words whose bytes are B, G, R, A on little-endian machines.
void fill_words(const VideoFrame& from, AVFrame& to) {
    parallel_for(static_cast<std::size_t>(from.height), 0, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        const std::uint32_t* const pixels = from.row(row);
        auto* const out = reinterpret_cast<std::uint32_t*>(plane_row(to, 0, row));
        const std::uint32_t opaque = from.alpha ? 0U : 0xFF000000U;
        for (int col = 0; col < from.width; ++col) {
            const std::uint32_t pixel = pixels[col] | opaque;
            out[col] = (pixel & 0xFF00FF00U) | channel_of(pixel, 0) << 16U | channel_of(pixel, 2);
        }
    });
}

void fill_bytes(const VideoFrame& from, AVFrame& to) {
    const unsigned channels = from.alpha ? 4 : 3;
    parallel_for(static_cast<std::size_t>(from.height), 0, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        std::uint8_t* out = plane_row(to, 0, row);
        for (int col = 0; col < from.width; ++col) {
            for (unsigned channel = 0; channel < channels; ++channel)
                *out++ = static_cast<std::uint8_t>(channel_of(from.row(row)[col], channel));
        }
    });
}

/// GIF's frames are numbers of colours: see ffmpeg_gif.cpp.
void fill_nothing(const VideoFrame&, AVFrame&) {}

FilmCodecRow h264_row() {
    return {.encoder = "libx264",
            .muxer = "mp4",
            .opaque = AV_PIX_FMT_YUV420P,
            .with_alpha = AV_PIX_FMT_YUV420P,
            .is_video = true,
            .ticks_per_second = 0,
            .alpha_tag = false,
            .muxer_options = {{"movflags", "+faststart"}},
            .set_up = set_up_h264,
            .fill = fill_video<8, true>};
}

FilmCodecRow vp9_row() {
    return {.encoder = "libvpx-vp9",
            .muxer = "webm",
            .opaque = AV_PIX_FMT_YUV420P,
            .with_alpha = AV_PIX_FMT_YUVA420P,
            .is_video = true,
            .ticks_per_second = 0,
            .alpha_tag = true,
            .muxer_options = {},
            .set_up = set_up_vp9,
            .fill = fill_video<8, true>};
}

FilmCodecRow prores_row() {
    return {.encoder = "prores_ks",
            .muxer = "mov",
            .opaque = AV_PIX_FMT_YUV444P10,
            .with_alpha = AV_PIX_FMT_YUVA444P10,
            .is_video = true,
            .ticks_per_second = 0,
            .alpha_tag = false,
            .muxer_options = {{"movflags", "+faststart"}},
            .set_up = set_up_prores,
            .fill = fill_video<10, false>};
}

FilmCodecRow ffv1_row() {
    return {.encoder = "ffv1",
            .muxer = "matroska",
            .opaque = AV_PIX_FMT_0RGB32,
            .with_alpha = AV_PIX_FMT_RGB32,
            .is_video = false,
            .ticks_per_second = 0,
            .alpha_tag = false,
            .muxer_options = {},
            .set_up = set_up_ffv1,
            .fill = fill_words};
}

FilmCodecRow gif_row() {
    return {.encoder = "gif",
            .muxer = "gif",
            .opaque = AV_PIX_FMT_PAL8,
            .with_alpha = AV_PIX_FMT_PAL8,
            .is_video = false,
            .ticks_per_second = 100,
            .alpha_tag = false,
            .muxer_options = {{"loop", "0"}},
            .set_up = set_up_nothing,
            .fill = fill_nothing};
}

FilmCodecRow apng_row() {
    return {.encoder = "apng",
            .muxer = "apng",
            .opaque = AV_PIX_FMT_RGB24,
            .with_alpha = AV_PIX_FMT_RGBA,
            .is_video = false,
            .ticks_per_second = 0,
            .alpha_tag = false,
            .muxer_options = {{"plays", "0"}},
            .set_up = set_up_nothing,
            .fill = fill_bytes};
}

}  // namespace

FilmCodecRow film_codec_row(FilmCodec codec) {
    switch (codec) {
        case FilmCodec::H264: return h264_row();
        case FilmCodec::Vp9: return vp9_row();
        case FilmCodec::ProRes: return prores_row();
        case FilmCodec::Ffv1: return ffv1_row();
        case FilmCodec::Gif: return gif_row();
        case FilmCodec::Apng: return apng_row();
    }
    return h264_row();
}

const char* encoder_of(FilmCodec codec) { return film_codec_row(codec).encoder; }

std::expected<std::unique_ptr<FilmEncoder>, std::string> open_film(
    FilmCodec codec, const std::filesystem::path& path, const FilmSettings& settings) {
    const FilmCodecRow row = film_codec_row(codec);
    return codec == FilmCodec::Gif ? open_ffmpeg_gif(row, path, settings)
                                   : open_ffmpeg_film(row, path, settings);
}

}  // namespace zeroset
