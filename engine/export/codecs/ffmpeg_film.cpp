#include "engine/base/translation.hpp"
#include "engine/export/codecs/codec.hpp"
#include "engine/export/codecs/ffmpeg_codecs.hpp"
#include "engine/export/codecs/ffmpeg_library.hpp"
#include "engine/export/codecs/ffmpeg_objects.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace zeroset {
namespace {

struct FreeMuxer {
    void operator()(AVFormatContext* muxer) const {
        ffmpeg().avio_closep(&muxer->pb);
        ffmpeg().avformat_free_context(muxer);
    }
};
using Muxer = std::unique_ptr<AVFormatContext, FreeMuxer>;

struct FreeDictionary {
    AVDictionary* entries = nullptr;
    ~FreeDictionary() { ffmpeg().av_dict_free(&entries); }
};

class FfmpegFilm final : public FilmEncoder {
public:
    FfmpegFilm(const FilmSettings& settings, FilmCodecRow row)
        : settings_(settings), row_(std::move(row)) {}

    /// Begins the file; to be called first.
    std::expected<void, std::string> open(const std::filesystem::path& path);
    std::expected<void, std::string> add(const VideoFrame& frame) override;
    std::expected<void, std::string> finish() override;

private:
    void set_up_encoder();
    std::expected<void, std::string> begin_file(const std::string& url);
    /// Sends a frame, or nullptr at the end, and writes what the encoder has finished.
    std::expected<void, std::string> encode(AVFrame* frame);

    FilmSettings settings_;
    FilmCodecRow row_;
    CodecContext encoder_;
    CodecFrame frame_;
    CodecPacket packet_;
    Muxer muxer_;
    AVStream* stream_ = nullptr;  ///< owned by the muxer
    std::int64_t frames_ = 0;
};

std::unexpected<std::string> failure(int error) { return std::unexpected(ffmpeg_error(error)); }

void FfmpegFilm::set_up_encoder() {
    AVCodecContext& encoder = *encoder_;
    encoder.width = settings_.width;
    encoder.height = settings_.height;
    encoder.time_base = av_make_q(settings_.rate.seconds, settings_.rate.frames);
    if (row_.ticks_per_second > 0) encoder.time_base = av_make_q(1, row_.ticks_per_second);
    encoder.framerate = av_make_q(settings_.rate.frames, settings_.rate.seconds);
    encoder.pix_fmt = settings_.alpha ? row_.with_alpha : row_.opaque;
    encoder.sample_aspect_ratio = av_make_q(1, 1);
    encoder.flags |= AV_CODEC_FLAG_BITEXACT;
    encoder.thread_count = 0;  // as many as there are cores
    if (row_.is_video) {
        encoder.color_range = AVCOL_RANGE_MPEG;
        encoder.colorspace = AVCOL_SPC_BT709;
        encoder.color_primaries = AVCOL_PRI_BT709;
        encoder.color_trc = AVCOL_TRC_BT709;
        encoder.chroma_sample_location = AVCHROMA_LOC_LEFT;
    }
    if ((muxer_->oformat->flags & AVFMT_GLOBALHEADER) != 0)
        encoder.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    row_.set_up(encoder, settings_);
}

std::expected<void, std::string> FfmpegFilm::begin_file(const std::string& url) {
    if (const int error = ffmpeg().avio_open(&muxer_->pb, url.c_str(), AVIO_FLAG_WRITE); error < 0)
        return failure(error);
    muxer_->flags |= AVFMT_FLAG_BITEXACT;
    if (settings_.alpha && row_.alpha_tag)
        ffmpeg().av_dict_set(&stream_->metadata, "alpha_mode", "1", 0);
    FreeDictionary options;
    for (const auto& [name, value] : row_.muxer_options)
        ffmpeg().av_dict_set(&options.entries, name, value, 0);
    if (const int error = ffmpeg().avformat_write_header(muxer_.get(), &options.entries); error < 0)
        return failure(error);
    return {};
}

std::expected<void, std::string> FfmpegFilm::open(const std::filesystem::path& path) {
    encoder_ = codec_context(row_.encoder);
    if (encoder_ == nullptr) return std::unexpected(missing_encoder(row_.encoder));
    const std::string url = "file:" + path.string();
    AVFormatContext* muxer = nullptr;
    if (const int error =
            ffmpeg().avformat_alloc_output_context2(&muxer, nullptr, row_.muxer, url.c_str());
        error < 0) {
        return failure(error);
    }
    muxer_.reset(muxer);
    set_up_encoder();
    if (const int error = ffmpeg().avcodec_open2(encoder_.get(), nullptr, nullptr); error < 0)
        return failure(error);
    stream_ = ffmpeg().avformat_new_stream(muxer, nullptr);
    packet_.reset(ffmpeg().av_packet_alloc());
    frame_ = codec_frame(*encoder_);
    if (stream_ == nullptr || packet_ == nullptr || frame_ == nullptr)
        return std::unexpected(tr("memory is short"));
    stream_->time_base = encoder_->time_base;
    stream_->avg_frame_rate = encoder_->framerate;
    if (const int error =
            ffmpeg().avcodec_parameters_from_context(stream_->codecpar, encoder_.get());
        error < 0) {
        return failure(error);
    }
    return begin_file(url);
}

std::expected<void, std::string> FfmpegFilm::encode(AVFrame* frame) {
    int error = ffmpeg().avcodec_send_frame(encoder_.get(), frame);
    while (error >= 0) {
        error = ffmpeg().avcodec_receive_packet(encoder_.get(), packet_.get());
        if (error == AVERROR(EAGAIN) || error == AVERROR_EOF) return {};
        if (error < 0) break;
        if (packet_->duration == 0)
            packet_->duration =
                ffmpeg().av_rescale_q(1, av_inv_q(encoder_->framerate), encoder_->time_base);
        ffmpeg().av_packet_rescale_ts(packet_.get(), encoder_->time_base, stream_->time_base);
        packet_->stream_index = stream_->index;
        error = ffmpeg().av_interleaved_write_frame(muxer_.get(), packet_.get());
    }
    return failure(error);
}

std::expected<void, std::string> FfmpegFilm::add(const VideoFrame& frame) {
    if (const int error = ffmpeg().av_frame_make_writable(frame_.get()); error < 0)
        return failure(error);
    row_.fill(frame, *frame_);
    frame_->pts = ffmpeg().av_rescale_q_rnd(frames_++, av_inv_q(encoder_->framerate),
                                            encoder_->time_base, AV_ROUND_NEAR_INF);
    return encode(frame_.get());
}

std::expected<void, std::string> FfmpegFilm::finish() {
    if (auto drained = encode(nullptr); !drained) return drained;
    if (const int error = ffmpeg().av_write_trailer(muxer_.get()); error < 0) return failure(error);
    if (const int error = ffmpeg().avio_closep(&muxer_->pb); error < 0) return failure(error);
    return {};
}

}  // namespace

std::expected<std::unique_ptr<FilmEncoder>, std::string> open_ffmpeg_film(
    const FilmCodecRow& row, const std::filesystem::path& path, const FilmSettings& settings) {
    auto film = std::make_unique<FfmpegFilm>(settings, row);
    if (auto opened = film->open(path); !opened) return std::unexpected(opened.error());
    return film;
}

}  // namespace zeroset
