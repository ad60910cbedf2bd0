#include "engine/base/parallel.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/codecs/codec.hpp"
#include "engine/export/codecs/encoded_picture.hpp"
#include "engine/export/codecs/ffmpeg_library.hpp"
#include "engine/export/codecs/ffmpeg_objects.hpp"

#include <cmath>
#include <cstring>
#include <functional>

namespace zeroset {
namespace {

/// Fills row `row` of a frame from the picture's.
using FillRow = std::function<void(const std::uint8_t* from, const AVFrame& to, int row)>;

/// An encoder with its settings.
struct PictureCodec {
    const char* name;
    AVPixelFormat format;
    FillRow fill_row;
    std::function<void(AVCodecContext&)> set_up;
};

EncodedPicture bytes_of(const AVPacket& packet) {
    const auto* const data = reinterpret_cast<const std::byte*>(packet.data);
    return std::vector<std::byte>(data, data + packet.size);
}

EncodedPicture encoded(const PictureCodec& codec, const RawPicture& picture) {
    const CodecContext context = codec_context(codec.name);
    if (context == nullptr) return std::unexpected(missing_encoder(codec.name));
    context->width = picture.width;
    context->height = picture.height;
    context->pix_fmt = codec.format;
    context->time_base = av_make_q(1, 1);
    context->flags |= AV_CODEC_FLAG_BITEXACT;
    codec.set_up(*context);
    if (const int error = ffmpeg().avcodec_open2(context.get(), nullptr, nullptr); error < 0)
        return std::unexpected(ffmpeg_error(error));
    const CodecFrame frame = codec_frame(*context);
    const CodecPacket packet(ffmpeg().av_packet_alloc());
    if (frame == nullptr || packet == nullptr) return std::unexpected(tr("memory is short"));
    frame->pts = 0;
    const std::size_t row_bytes = picture.rows.size() / static_cast<std::size_t>(picture.height);
    parallel_for(static_cast<std::size_t>(picture.height), 0, [&](std::size_t row) {
        codec.fill_row(picture.rows.data() + row * row_bytes, *frame, static_cast<int>(row));
    });
    int error = ffmpeg().avcodec_send_frame(context.get(), frame.get());
    if (error >= 0) error = ffmpeg().avcodec_send_frame(context.get(), nullptr);
    if (error >= 0) error = ffmpeg().avcodec_receive_packet(context.get(), packet.get());
    if (error < 0) return std::unexpected(ffmpeg_error(error));
    return bytes_of(*packet);
}

/// RGBA to words whose bytes are B, G, R, A on little-endian machines.
void fill_word_row(const std::uint8_t* from, const AVFrame& to, int row, bool alpha) {
    std::uint8_t* out = plane_row(to, 0, row);
    for (int col = 0; col < to.width; ++col, from += alpha ? 4 : 3, out += 4) {
        const std::uint32_t word = (alpha ? from[3] : 255U) << 24U |
                                   static_cast<std::uint32_t>(from[0]) << 16U |
                                   static_cast<std::uint32_t>(from[1]) << 8U | from[2];
        std::memcpy(out, &word, sizeof word);
    }
}

AVPixelFormat tiff_format(const RawPicture& picture) {
    if (picture.bits == 8) return picture.alpha ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24;
    return picture.alpha ? AV_PIX_FMT_RGBA64 : AV_PIX_FMT_RGB48;
}

}  // namespace

EncodedPicture encoded_webp(const RawPicture& picture, int quality) {
    const auto set_up = [quality](AVCodecContext& context) {
        ffmpeg().av_opt_set_int(context.priv_data, "lossless", quality == 100 ? 1 : 0, 0);
        ffmpeg().av_opt_set_double(context.priv_data, "quality", quality, 0);
    };
    const auto fill_row = [&picture](const std::uint8_t* from, const AVFrame& to, int row) {
        fill_word_row(from, to, row, picture.alpha);
    };
    return encoded(
        {.name = webp_encoder, .format = AV_PIX_FMT_RGB32, .fill_row = fill_row, .set_up = set_up},
        picture);
}

EncodedPicture encoded_tiff(const RawPicture& picture, double dots_per_inch) {
    const auto set_up = [dots_per_inch](AVCodecContext& context) {
        ffmpeg().av_opt_set(context.priv_data, "compression_algo", "deflate", 0);
        if (dots_per_inch > 0)
            ffmpeg().av_opt_set_int(context.priv_data, "dpi", std::lround(dots_per_inch), 0);
    };
    const std::size_t bytes = picture.rows.size() / static_cast<std::size_t>(picture.height);
    const auto fill_row = [bytes](const std::uint8_t* from, const AVFrame& to, int row) {
        std::memcpy(plane_row(to, 0, row), from, bytes);
    };
    return encoded({.name = tiff_encoder,
                    .format = tiff_format(picture),
                    .fill_row = fill_row,
                    .set_up = set_up},
                   picture);
}

}  // namespace zeroset
