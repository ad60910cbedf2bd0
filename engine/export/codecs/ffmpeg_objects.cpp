#include "engine/export/codecs/ffmpeg_objects.hpp"

#include "engine/base/translation.hpp"
#include "engine/export/codecs/codec.hpp"

#include <array>

namespace zeroset {

std::string missing_encoder(const char* name) {
    if (!ffmpeg().error.empty())
        return filled(tr("FFmpeg's libraries cannot be loaded: {0}"), {ffmpeg().error});
    if (ffmpeg().avcodec_find_encoder_by_name(name) != nullptr) return "";
    return filled(tr("the FFmpeg libraries here have no encoder {0}"), {name});
}

std::string ffmpeg_error(int error) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
    ffmpeg().av_strerror(error, text.data(), text.size());
    return text.data();
}

CodecContext codec_context(const char* encoder) {
    if (!ffmpeg().error.empty()) return nullptr;
    ffmpeg().av_log_set_level(AV_LOG_QUIET);
    const AVCodec* const codec = ffmpeg().avcodec_find_encoder_by_name(encoder);
    return CodecContext(codec == nullptr ? nullptr : ffmpeg().avcodec_alloc_context3(codec));
}

CodecFrame codec_frame(const AVCodecContext& context) {
    CodecFrame frame(ffmpeg().av_frame_alloc());
    if (frame == nullptr) return nullptr;
    frame->format = context.pix_fmt;
    frame->width = context.width;
    frame->height = context.height;
    frame->color_range = context.color_range;
    frame->colorspace = context.colorspace;
    frame->color_primaries = context.color_primaries;
    frame->color_trc = context.color_trc;
    frame->chroma_location = context.chroma_sample_location;
    if (ffmpeg().av_frame_get_buffer(frame.get(), 0) < 0) return nullptr;
    return frame;
}

}  // namespace zeroset
