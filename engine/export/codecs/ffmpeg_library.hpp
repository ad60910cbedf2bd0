#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
#include <libavutil/error.h>
#include <libavutil/frame.h>
#include <libavutil/log.h>
#include <libavutil/mathematics.h>
#include <libavutil/opt.h>
}

#include <string>

namespace zeroset {

/// FFmpeg's functions by their names; all are there, or none and an error.
struct FfmpegLibrary {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a declared name has none
#define ZEROSET_FFMPEG(library, function) decltype(&::function) function = nullptr;
#include "engine/export/codecs/ffmpeg_functions.def"
#undef ZEROSET_FFMPEG
    std::string error;  ///< why the libraries cannot be loaded; empty where they are
};

/// FFmpeg's libraries, of the versions whose headers were compiled with. The first call loads them:
/// with all that they need they take longer than the rest of the program. Thread-safe.
const FfmpegLibrary& ffmpeg();

}  // namespace zeroset
