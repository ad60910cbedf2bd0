#include "engine/base/translation.hpp"
#include "engine/export/codecs/codec.hpp"
#include "engine/export/codecs/encoded_picture.hpp"
#include "engine/export/codecs/film_encoder.hpp"

// In place of the files ffmpeg_*.cpp in a build without FFmpeg.

namespace zeroset {
namespace {

std::unexpected<std::string> refused() { return std::unexpected(missing_encoder("")); }

}  // namespace

std::string missing_encoder(const char*) { return tr("this Zeroset was built without FFmpeg"); }

EncodedPicture encoded_webp(const RawPicture&, int) { return refused(); }
EncodedPicture encoded_tiff(const RawPicture&, double) { return refused(); }

const char* encoder_of(FilmCodec) { return ""; }
std::expected<std::unique_ptr<FilmEncoder>, std::string> open_film(FilmCodec,
                                                                   const std::filesystem::path&,
                                                                   const FilmSettings&) {
    return refused();
}

}  // namespace zeroset
