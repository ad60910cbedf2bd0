#include "engine/base/translation.hpp"
#include "engine/export/codecs/encoded_picture.hpp"
#include "engine/export/pictures/picture_makers.hpp"
#include "engine/export/pictures/pixel_rows.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Makes a file of a whole picture.
using Encode = std::function<EncodedPicture(const RawPicture&)>;

/// A picture that is gathered in memory, as its encoder wants all of it.
class CodecPicture final : public PictureWriter {
public:
    CodecPicture(std::filesystem::path path, PictureOptions options, Encode encode)
        : path_(std::move(path)), options_(std::move(options)), encode_(std::move(encode)) {}

    std::expected<void, FileError> add(const PictureBand& band) override {
        const PixelLayout layout{.bits = options_.bits, .alpha = options_.alpha};
        take_pixel_rows(band, options_.size.height, layout, band_rows_);
        rows_.insert(rows_.end(), band_rows_.begin(), band_rows_.end());
        return {};
    }
    std::expected<void, FileError> finish() override {
        const auto file = encode_({.width = options_.size.width,
                                   .height = options_.size.height,
                                   .bits = options_.bits,
                                   .alpha = options_.alpha,
                                   .rows = rows_});
        if (file) return write_file(path_, *file);
        return std::unexpected(FileError{
            filled(tr("cannot write {0}: {1}"), {"'" + path_.string() + "'", file.error()})});
    }

private:
    std::filesystem::path path_;
    PictureOptions options_;
    Encode encode_;
    std::vector<std::uint8_t> rows_, band_rows_;
};

}  // namespace

std::unique_ptr<PictureWriter> make_jpeg_picture(const std::filesystem::path& path,
                                                 const PictureOptions& options) {
    return std::make_unique<CodecPicture>(path, options,
                                          [quality = options.quality](const RawPicture& picture) {
                                              return encoded_jpeg(picture, quality);
                                          });
}

std::unique_ptr<PictureWriter> make_webp_picture(const std::filesystem::path& path,
                                                 const PictureOptions& options) {
    return std::make_unique<CodecPicture>(path, options,
                                          [quality = options.quality](const RawPicture& picture) {
                                              return encoded_webp(picture, quality);
                                          });
}

std::unique_ptr<PictureWriter> make_tiff_picture(const std::filesystem::path& path,
                                                 const PictureOptions& options) {
    return std::make_unique<CodecPicture>(
        path, options, [density = options.dots_per_inch](const RawPicture& picture) {
            return encoded_tiff(picture, density);
        });
}

}  // namespace zeroset
