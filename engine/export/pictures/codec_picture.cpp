#include "engine/base/translation.hpp"
#include "engine/export/codecs/encoded_picture.hpp"
#include "engine/export/pictures/picture_makers.hpp"
#include "engine/export/pictures/pixel_rows.hpp"
#include "engine/image/background.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Makes a file of a whole picture.
using Encode = std::function<EncodedPicture(const RawPicture&)>;

std::expected<void, FileError> write_encoded(const std::filesystem::path& path,
                                             const EncodedPicture& file) {
    if (file) return write_file(path, *file);
    return std::unexpected(
        FileError{filled(tr("cannot write {0}: {1}"), {"'" + path.string() + "'", file.error()})});
}

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
        return write_encoded(path_, encode_({.width = options_.size.width,
                                             .height = options_.size.height,
                                             .bits = options_.bits,
                                             .alpha = options_.alpha,
                                             .rows = rows_}));
    }

private:
    std::filesystem::path path_;
    PictureOptions options_;
    Encode encode_;
    std::vector<std::uint8_t> rows_, band_rows_;
};

/// A picture of light, which is gathered in memory.
class HdrPicture final : public PictureWriter {
public:
    HdrPicture(std::filesystem::path path, const ImageSize& size)
        : path_(std::move(path)), size_(size) {}

    std::expected<void, FileError> add(const PictureBand& band) override {
        const Framebuffer& frame = band.frame;
        light_.reserve(3 * static_cast<std::size_t>(size_.width) *
                       static_cast<std::size_t>(size_.height));
        for (int row = 0; row < frame.height; ++row) {
            const auto background =
                background_light(frame.background, band.row + row, size_.height);
            for (int col = 0; col < frame.width; ++col) {
                const auto light = pixel_light(band, frame.index(col, row), background, false);
                light_.insert(light_.end(), light.begin(), light.begin() + 3);
            }
        }
        return {};
    }
    std::expected<void, FileError> finish() override {
        return write_encoded(path_, encoded_hdr(size_.width, size_.height, light_));
    }

private:
    std::filesystem::path path_;
    ImageSize size_;
    std::vector<float> light_;
};

}  // namespace

std::unique_ptr<PictureWriter> make_bmp_picture(const std::filesystem::path& path,
                                                const PictureOptions& options) {
    return std::make_unique<CodecPicture>(path, options, encoded_bmp);
}

std::unique_ptr<PictureWriter> make_tga_picture(const std::filesystem::path& path,
                                                const PictureOptions& options) {
    return std::make_unique<CodecPicture>(path, options, encoded_tga);
}

std::unique_ptr<PictureWriter> make_hdr_picture(const std::filesystem::path& path,
                                                const PictureOptions& options) {
    return std::make_unique<HdrPicture>(path, options.size);
}

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
