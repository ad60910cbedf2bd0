#include "engine/export/codecs/ffmpeg_library.hpp"

#include <dlfcn.h>

namespace zeroset {
namespace {

constexpr const char* avcodec_file = "libavcodec.so." AV_STRINGIFY(LIBAVCODEC_VERSION_MAJOR);
constexpr const char* avformat_file = "libavformat.so." AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR);
constexpr const char* avutil_file = "libavutil.so." AV_STRINGIFY(LIBAVUTIL_VERSION_MAJOR);

/// The message of the call of dlopen or dlsym that just failed.
std::string last_error() {
    const char* const text = dlerror();  // NOLINT(concurrency-mt-unsafe): glibc has one a thread
    return text == nullptr ? "unknown error" : text;
}

/// Sets `function` to the one of this name; where there is none, says so unless `error` tells more.
template <class Function>
void find(void* library, const char* name, Function& function, std::string& error) {
    if (!error.empty()) return;
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) error = last_error();
}

/// A library that stays loaded; where there is none, `error` says so.
void* open(const char* file, std::string& error) {
    if (!error.empty()) return nullptr;
    void* const library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) error = last_error();
    return library;
}

FfmpegLibrary loaded() {
    FfmpegLibrary found;
    void* const avformat = open(avformat_file, found.error);  // brings the others
    void* const avcodec = open(avcodec_file, found.error);
    void* const avutil = open(avutil_file, found.error);
#define ZEROSET_FFMPEG(library, function) find(library, #function, found.function, found.error);
#include "engine/export/codecs/ffmpeg_functions.def"
#undef ZEROSET_FFMPEG
    if (!found.error.empty()) return {.error = found.error};
    return found;
}

}  // namespace

const FfmpegLibrary& ffmpeg() {
    static const FfmpegLibrary library = loaded();
    return library;
}

}  // namespace zeroset
