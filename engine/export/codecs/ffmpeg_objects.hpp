#pragma once

#include "engine/export/codecs/ffmpeg_library.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace zeroset {

struct FreeFfmpeg {
    void operator()(AVCodecContext* context) const { ffmpeg().avcodec_free_context(&context); }
    void operator()(AVFrame* frame) const { ffmpeg().av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { ffmpeg().av_packet_free(&packet); }
};
using CodecContext = std::unique_ptr<AVCodecContext, FreeFfmpeg>;
using CodecFrame = std::unique_ptr<AVFrame, FreeFfmpeg>;
using CodecPacket = std::unique_ptr<AVPacket, FreeFfmpeg>;

/// FFmpeg's words for one of its error numbers.
std::string ffmpeg_error(int error);

/// A context for an encoder, not opened yet; nullptr where missing_encoder says why. FFmpeg's own
/// messages are kept off standard error.
CodecContext codec_context(const char* encoder);

/// A frame with room for the pixels of `context`.
CodecFrame codec_frame(const AVCodecContext& context);

/// A row of a plane of a frame.
inline std::uint8_t* plane_row(const AVFrame& frame, int plane, int row) {
    return frame.data[plane] +
           static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(frame.linesize[plane]);
}

}  // namespace zeroset
